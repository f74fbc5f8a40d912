#include "image/cryptomatte.h"

#include "json_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

namespace eikonal {

std::uint32_t murmurHash3(const std::string& bytes) {
    const auto scrambled = [](std::uint32_t k) { return std::rotl(k * 0xcc9e2d51u, 15) * 0x1b873593u; };
    const auto wordAt = [&](std::size_t at, std::size_t count) {
        std::uint32_t word = 0;
        for (std::size_t i = 0; i < count; ++i) word |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
        return word;
    };
    std::uint32_t hash = 0;
    const std::size_t whole = bytes.size() - bytes.size() % 4;
    for (std::size_t i = 0; i < whole; i += 4) hash = std::rotl(hash ^ scrambled(wordAt(i, 4)), 13) * 5 + 0xe6546b64u;
    hash ^= scrambled(wordAt(whole, bytes.size() - whole));
    /* Every bit of the result depends on every bit before */
    hash ^= static_cast<std::uint32_t>(bytes.size());
    hash = (hash ^ hash >> 16) * 0x85ebca6bu;
    hash = (hash ^ hash >> 13) * 0xc2b2ae35u;
    return hash ^ hash >> 16;
}

std::uint32_t cryptomatteId(const std::string& name) {
    const std::uint32_t hash = murmurHash3(name), exponent = hash >> 23 & 255;
    return exponent == 0 || exponent == 255 ? hash ^ 1u << 23 : hash;
}

std::string cryptomatteName(const std::string& name) {
    if (std::ranges::all_of(name, [](unsigned char c) { return c < 128; })) return name;
    return nlohmann::json::parse(jsonText(nlohmann::json(name))).get<std::string>();
}

std::string cryptomatteManifest(const CryptomatteIds& ids) {
    nlohmann::ordered_json manifest = nlohmann::ordered_json::object();
    auto& entries = manifest.get_ref<nlohmann::ordered_json::object_t&>();
    for (const auto& [name, id] : ids) entries.emplace_back(name, fmt::format("{:08x}", id));   // looks for no equal name, which takes long
    return jsonText(manifest);
}

std::string cryptomatteChannel(const std::string& layer, std::size_t i) { return fmt::format("{}{:02}.{}", layer, i / 4, "rgba"[i % 4]); }

std::string cryptomatteAttribute(const std::string& layer, const char* what) {
    return fmt::format("cryptomatte/{}/{}", fmt::format("{:08x}", murmurHash3(layer)).substr(0, 7), what);
}

std::vector<std::pair<std::string, std::string>> cryptomatteAttributes(const CryptomatteLayer& layer) {
    std::vector<std::pair<std::string, std::string>> attributes;
    const auto add = [&](const char* what, const std::string& text) {
        if (!text.empty()) attributes.emplace_back(cryptomatteAttribute(layer.name, what), text);
    };
    add("name", layer.name);
    add("hash", "MurmurHash3_32");
    add("conversion", "uint32_to_float32");
    add("manifest", layer.manifest);
    return attributes;
}

}  // namespace eikonal
