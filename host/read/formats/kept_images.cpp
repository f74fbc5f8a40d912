#include "read/formats/kept_images.h"

#include "available_memory.h"

#include <map>
#include <mutex>
#include <tuple>

namespace eikonal {
namespace {

/// How a file is decoded.
using Key = std::tuple<std::string, ColorEncoding, double>;

struct Kept {
    FileStamp stamp{};
    std::shared_ptr<const ImageData> image;
    unsigned lastUse = 0;  // the number of a render
};

struct KeptImages {
    std::mutex mutex;
    unsigned render = 0;  // the number of the current one; 0: nothing is kept
    std::size_t bytes = 0;
    std::map<Key, Kept> images;
};
KeptImages& kept() {
    static KeptImages all;
    return all;
}

Key keyOf(const ImageFile& file) { return {file.path, file.encoding, file.gamma}; }

std::size_t bytesOf(const ImageData& image) { return image.bytes.size() + image.floats.size() * sizeof(float); }

}  // namespace

void keepImages() {
    KeptImages& all = kept();
    const std::lock_guard lock(all.mutex);
    std::erase_if(all.images, [&](const auto& entry) {
        const bool isUnused = entry.second.lastUse != all.render;
        if (isUnused) all.bytes -= bytesOf(*entry.second.image);
        return isUnused;
    });
    ++all.render;
}

std::shared_ptr<const ImageData> keptImage(const ImageFile& file) {
    KeptImages& all = kept();
    const std::lock_guard lock(all.mutex);
    const auto found = all.images.find(keyOf(file));
    if (found == all.images.end() || stampOf(file.path) != found->second.stamp) return nullptr;
    found->second.lastUse = all.render;
    return found->second.image;
}

void keepImage(const ImageFile& file, const FileStamp& stamp, const std::shared_ptr<const ImageData>& image) {
    constexpr std::size_t shareOfMemory = 4;
    KeptImages& all = kept();
    const std::lock_guard lock(all.mutex);
    if (all.render == 0 || stamp == FileStamp{}) return;
    if (const auto old = all.images.find(keyOf(file)); old != all.images.end()) {
        all.bytes -= bytesOf(*old->second.image);
        all.images.erase(old);
    }
    if (all.bytes + bytesOf(*image) > availableMemory() / shareOfMemory) return;
    all.bytes += bytesOf(*image);
    all.images[keyOf(file)] = {stamp, image, all.render};
}

}  // namespace eikonal
