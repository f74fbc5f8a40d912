// Checkpoints, and parts of images.

#include "targets.h"

#include "app/commands.h"
#include "app/stored_metadata.h"
#include "error.h"
#include "film/film_file.h"
#include "film/stored_scene.h"
#include "render/render_identity.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

namespace eikonal::fuzz {
namespace {

/// As in host/film/record_file.cpp.
constexpr size_t kindBytes = 32;
struct Head { std::uint32_t tag, contentCheck; std::uint64_t bytes; std::uint32_t check, unused; };

std::uint32_t checksum(const void* data, size_t bytes) {
    return static_cast<std::uint32_t>(::crc32_z(0, static_cast<const unsigned char*>(data), bytes));
}

/// The first record file of `bytes`, with sizes, checksums and the number of records made right, and what follows it in `rest`.
std::string repaired(std::string_view bytes, std::string_view& rest) {
    std::string file(bytes.substr(0, kindBytes));
    std::uint64_t records = 0;
    const auto add = [&](std::uint32_t tag, std::string_view content) {
        Head head{tag, checksum(content.data(), content.size()), content.size(), 0, 0};
        head.check = checksum(&head, offsetof(Head, check));
        file.append(reinterpret_cast<const char*>(&head), sizeof head).append(content);
        ++records;
    };
    rest = bytes.substr(file.size());
    while (rest.size() >= sizeof(Head)) {
        Head head;
        std::memcpy(&head, rest.data(), sizeof head);
        const std::string_view content = rest.substr(sizeof head, std::min<std::uint64_t>(head.bytes, rest.size() - sizeof head));
        rest.remove_prefix(sizeof head + content.size());
        if (head.tag == recordTag("LAST")) break;
        add(head.tag, content);
    }
    const std::uint64_t count = records;
    add(recordTag("LAST"), {reinterpret_cast<const char*>(&count), sizeof count});
    return file;
}

/// Whether the image of the parts is so large that it may take much memory and time.
bool isLarge(const std::string& part) {
    constexpr double mostPixels = 1 << 18;
    try {
        const PixelRect pixels = storedScene(FilmFileReader(part).head().scene, part).packed.pixels;
        return static_cast<double>(pixels.width()) * pixels.height() > mostPixels;
    } catch (const Error&) { return false; }
}

}  // namespace

bool runFilm(std::string_view input) {
    const std::string path = writeInput("input.film", input);
    try {
        const FilmFileReader file(path);
        for (const RecordReader::Record& record : file.pixelRecords()) file.readHead(record);
        file.forSplats([](const SplatRow&) {});
        identityFromJson(file.head().identity, path);
        storedMetadata(file.head().metadata, path);
        storedScene(file.head().scene, path);
    } catch (const Error&) {}
    return true;
}

bool runMerge(std::string_view input) {
    if (input.empty()) return true;
    const int choice = static_cast<unsigned char>(input.back());
    Options options;
    options.log = LogLevel::silent;
    options.isPartial = choice & 1;
    if (choice & 2) options.output.checkpoint = inputFolder() + "/merged.film";
    else options.output.files = {inputFolder() + "/merged.exr"};
    options.output.hasImage = !(choice & 2);
    for (std::string_view rest = input.substr(0, input.size() - 1); rest.size() >= kindBytes && options.parts.size() < 4;)
        options.parts.push_back(writeInput(fmt::format("{}.film", options.parts.size()), repaired(std::string_view(rest), rest)));
    if (options.parts.empty() || isLarge(options.parts.front())) return true;
    try {
        mergeCommand(options);
    } catch (const Error&) {}
    return true;
}

}  // namespace eikonal::fuzz
