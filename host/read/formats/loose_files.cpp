#include "read/formats/loose_files.h"

#include "image/image_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <vector>

namespace eikonal {
namespace {

namespace fs = std::filesystem;

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// The names that a path consists of, without its root.
std::vector<std::string> namesIn(std::string path) {
    std::ranges::replace(path, '\\', '/');
    std::vector<std::string> names;
    for (const fs::path& part : fs::path(path).relative_path())
        if (const std::string name = part.string(); !name.empty() && name != "." && !name.ends_with(':')) names.push_back(name);
    return names;
}

/// The entry of a folder with this name in any case; exactly it, if it is there. Empty: none.
fs::path entryLike(const fs::path& folder, const std::string& name) {
    std::error_code error;
    if (fs::exists(folder / name, error)) return folder / name;
    std::set<std::string> like;
    for (fs::directory_iterator entry(folder.empty() ? "." : folder, error), end; !error && entry != end; entry.increment(error))
        if (const std::string other = entry->path().filename().string(); lower(other) == lower(name)) like.insert(other);
    return like.empty() ? fs::path() : folder / *like.begin();
}

}  // namespace

std::optional<std::string> findLoosely(const std::string& name, const fs::path& folder) {
    const std::vector<std::string> names = namesIn(name);
    std::error_code error;
    for (size_t first = 0; first < names.size(); ++first)
        for (const fs::path& base : {folder, entryLike(folder, "textures")}) {
            if (base.empty() && !folder.empty()) continue;
            fs::path place = base;
            bool isThere = true;
            for (size_t i = first; i < names.size() && isThere; ++i) {
                place = entryLike(place, names[i]);
                isThere = !place.empty();
            }
            if (isThere && fs::is_regular_file(place, error)) return place.lexically_normal().string();
        }
    return std::nullopt;
}

ImageFile magentaImage(const std::string& name) {
    static const auto pixel = [] {
        auto image = std::make_shared<ImageData>();
        image->width = image->height = 1;
        image->channels = 3;
        image->format = format_float;
        image->floats = {1, 0, 1};
        return image;
    }();
    ImageFile file;
    file.path = name;
    file.pixels = pixel;
    return file;
}

std::string looseMatchMessage(const std::string& name, const std::string& found) {
    return fmt::format("there is no file \"{}\"; \"{}\" is read instead", name, found);
}

}  // namespace eikonal
