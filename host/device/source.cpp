#include "device/source.h"

#include "device/kind_files.h"
#include "error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

namespace fs = std::filesystem;

namespace eikonal {

struct ContractHeader { const char *name, *text; };

/// The contract headers that this program was built with.
constexpr ContractHeader contractHeaders[] = {
#include "contract_headers.inc"
};

/// The content of a file; nothing if it cannot be read.
static std::optional<std::string> contentOf(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) return std::nullopt;
    std::stringstream content;
    content << file.rdbuf();
    return content.str();
}

static void checkContract(const fs::path& include) {
    for (const ContractHeader& header : contractHeaders)
        if (contentOf(include / header.name) != header.text)
            throw DeviceError(
                fmt::format("{} is not the one that this program was built with, so the kernels next to it do not fit. "
                            "Build the program again, or set EIKONAL_KERNELS to the folder of the kernels that it was built with.",
                            (include / header.name).string()));
}

KernelFolders findKernelFolders() {
    std::vector<fs::path> roots;
    if (const char* set = std::getenv("EIKONAL_KERNELS")) roots.push_back(set);
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    if (!program.empty()) roots.push_back(program.parent_path().parent_path() / EIKONAL_INSTALL_DATADIR);
    roots.push_back(EIKONAL_SOURCE_DIR);
    std::string tried;
    for (const fs::path& root : roots) {
        tried += "\n  " + root.string();
        if (!fs::exists(root / "kernels" / "stages/queue.clh")) continue;
        /* An installation has the headers in the prefix's include folder, the source tree next to the kernels */
        for (const fs::path& include : {root / "include", root.parent_path().parent_path() / "include"})
            if (fs::exists(include / "eikonal" / "queues.h")) {
                checkContract(include);
                return {(root / "kernels").string(), include.string()};
            }
    }
    throw DeviceError("cannot find the kernels. Looked for kernels/ and include/eikonal/ in:" + tried +
                      "\nSet EIKONAL_KERNELS to the folder that holds them.");
}

std::uint64_t hashBytes(std::string_view bytes, std::uint64_t hash) {
    /* The shift mixes high bits of the product back into low ones */
    const auto add = [&](std::uint64_t value) {
        hash = (hash ^ value) * 1099511628211u;
        hash ^= hash >> 32;
    };
    for (; bytes.size() >= sizeof(std::uint64_t); bytes.remove_prefix(sizeof(std::uint64_t))) {
        std::uint64_t word;
        std::memcpy(&word, bytes.data(), sizeof word);
        add(word);
    }
    for (const unsigned char c : bytes) add(c);
    return hash;
}

const std::string& KernelFiles::text(const std::string& name) {
    if (const auto known = texts_.find(name); known != texts_.end()) return known->second;
    std::optional<std::string> text = kindFiles(name);
    for (const std::string& folder : {folders_.kernels, folders_.include})
        if (!text) text = contentOf(fs::path(folder) / name);
    if (!text)
        throw DeviceError(fmt::format("a kernel includes \"{}\", which is in neither {} nor {}", name, folders_.kernels, folders_.include));
    return texts_.emplace(name, std::move(*text)).first->second;
}

KernelSource::KernelSource(KernelFiles& files, const std::string& text) {
    append(files, text, "program");
    noteWords();
}

/// The file that a line includes; empty if it includes none.
static std::string includedBy(std::string_view line) {
    const size_t hash = line.find_first_not_of(" \t");
    if (hash == std::string_view::npos || !line.substr(hash).starts_with("#include")) return {};
    const size_t open = line.find('"'), close = open == std::string_view::npos ? open : line.find('"', open + 1);
    return close == std::string_view::npos ? std::string() : std::string(line.substr(open + 1, close - open - 1));
}

void KernelSource::append(KernelFiles& files, std::string_view text, const std::string& name) {
    text_ += fmt::format("#line 1 \"{}\"\n", name);
    int number = 0;
    for (size_t begin = 0; begin < text.size();) {
        const std::string_view line = text.substr(begin, text.find('\n', begin) - begin);
        begin += line.size() + 1;
        ++number;
        const std::string included = includedBy(line);
        if (included.empty()) text_.append(line) += '\n';
        else if (files_.contains(included)) text_ += '\n';
        else {
            include(files, included);
            text_ += fmt::format("#line {} \"{}\"\n", number + 1, name);
        }
    }
}

void KernelSource::include(KernelFiles& files, const std::string& name) {
    const std::string& text = files.text(name);
    /* A file without an include guard comes each time that it is included, such as once for each BSDF */
    if (text.find("\n#ifndef ") != std::string::npos || name.ends_with("/kinds.clh")) files_.insert(name);
    append(files, text, name);
}

void KernelSource::noteWords() {
    const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'; };
    for (auto at = text_.begin(); at != text_.end();) {
        const auto begin = std::find_if(at, text_.end(), isLetter);
        at = std::find_if_not(begin, text_.end(), isLetter);
        if (begin != at && *begin >= 'A' && *begin <= 'Z') words_.emplace(begin, at);
    }
}

std::string KernelSource::options(const Features& features, const Constants& constants) const {
    std::string options;
    for (size_t i = 0; i < featureCount(); ++i) {
        const Feature feature = static_cast<Feature>(i);
        const std::string& name = featureName(feature);
        /* Queue fields name their feature without HAS_ */
        if (words_.contains("HAS_" + name) || (isGeneral(feature) && words_.contains(name)))
            options += fmt::format(" -DHAS_{}={}", name, features.has(feature) ? 1 : 0);
    }
    for (const auto& [name, value] : constants)
        if (words_.contains(name)) options += fmt::format(" -D{}={}", name, value);
    return options;
}

}  // namespace eikonal
