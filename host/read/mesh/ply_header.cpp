#include "read/mesh/ply_header.h"

#include "read/formats/read_bytes.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace eikonal::ply {

static std::vector<std::string_view> words(std::string_view line) {
    std::vector<std::string_view> result;
    for (std::size_t at = 0; (at = line.find_first_not_of(" \t", at)) != line.npos;) {
        const std::size_t end = std::min(line.find_first_of(" \t", at), line.size());
        result.push_back(line.substr(at, end - at));
        at = end;
    }
    return result;
}

static const TypeName& parseType(std::string_view word, int line) {
    const auto found = std::ranges::find_if(typeNames, [&](const TypeName& type) { return word == type.name || word == type.sizedName; });
    if (found != typeNames.end()) return *found;
    throw ReadProblem{
        fmt::format("has an unknown type \"{}\" in line {}; known: char uchar short ushort int uint float double", word, line)};
}

Header parseHeader(std::string_view text) {
    if (!text.starts_with("ply\n") && !text.starts_with("ply\r")) throw ReadProblem{"is not a PLY file: it does not begin with \"ply\""};
    const std::string_view newline = text.starts_with("ply\r\n") ? "\r\n" : text.starts_with("ply\r") ? "\r" : "\n";
    Header header;
    bool hasFormat = false;
    for (int line = 1;; ++line) {
        const std::size_t end = text.find(newline, header.size);
        if (end == text.npos) throw ReadProblem{"is truncated: there is no \"end_header\""};
        const std::vector<std::string_view> word = words(text.substr(header.size, end - header.size));
        header.size = end + newline.size();
        const auto malformed = [&] { return ReadProblem{fmt::format("has a malformed \"{}\" in line {}", word[0], line)}; };

        if (word.empty() || word[0] == "ply" || word[0] == "comment" || word[0] == "obj_info") continue;
        if (word[0] == "end_header") break;
        if (word[0] == "format") {
            if (word.size() < 2) throw malformed();
            if (word[1] == "ascii") header.format = Format::ascii;
            else if (word[1] == "binary_little_endian") header.format = Format::littleEndian;
            else if (word[1] == "binary_big_endian") header.format = Format::bigEndian;
            else
                throw ReadProblem{
                    fmt::format("has the unknown format \"{}\"; known: ascii binary_little_endian binary_big_endian", word[1])};
            hasFormat = true;
        } else if (word[0] == "element") {
            Element element;
            if (word.size() != 3) throw malformed();
            element.name = word[1];
            const auto [stop, error] = std::from_chars(word[2].data(), word[2].data() + word[2].size(), element.count);
            if (error != std::errc{} || stop != word[2].data() + word[2].size()) throw malformed();
            header.elements.push_back(std::move(element));
        } else if (word[0] == "property") {
            const bool isList = word.size() == 5 && word[1] == "list";
            if ((word.size() != 3 && !isList) || header.elements.empty()) throw malformed();
            Property property{std::string(word.back()), parseType(word[word.size() - 2], line).type, isList};
            if (isList) property.countType = parseType(word[2], line).type;
            header.elements.back().properties.push_back(std::move(property));
        } else if (header.elements.empty()) {
            header.skippedLine = line;
        } else {
            throw ReadProblem{fmt::format("has an unknown keyword \"{}\" in line {} of its header", word[0], line)};
        }
    }
    if (!hasFormat) throw ReadProblem{"has no \"format\" line"};
    return header;
}

}  // namespace eikonal::ply
