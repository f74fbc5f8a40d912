#include "read/formats/image.h"

#include "available_memory.h"
#include "color/primaries.h"
#include "color/transfer.h"
#include "image/formats/image_formats.h"
#include "image/half_floats.h"
#include "parallel_errors.h"
#include "read/formats/input_files.h"
#include "read/formats/kept_images.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>

#include <strings.h>

namespace eikonal {
namespace {

// ---- opening ----------------------------------------------------------------------------------------------------------------

struct Problem { std::string message; };

std::unique_ptr<ImageReader> open(const std::string& path) {
    noteInputFile(path);
    std::string reason;
    auto input = openImage(path, true, reason);
    if (!input) throw Problem{reason.empty() ? "it is damaged" : reason};
    return input;
}

/// Refuses a header that claims far more pixels than the file can hold, so that a damaged file does not exhaust memory.
void checkPlausible(const std::string& path, const ImageReader::Header& header) {
    if (header.width <= 0 || header.height <= 0 || header.depth > 1)
        throw Problem{fmt::format("it is {} x {} x {} pixels", header.width, header.height, header.depth)};
    constexpr double alwaysFine = 1 << 26, highestCompression = 2000;
    const double claimed = static_cast<double>(header.bytes), size = static_cast<double>(std::filesystem::file_size(path));
    if (claimed > alwaysFine && claimed > highestCompression * size)
        throw Problem{fmt::format("it is damaged: {} bytes cannot hold {} x {} pixels", size, header.width, header.height)};
}

/// Memory that images are going to take while they are read, on several threads.
class PlannedMemory {
public:
    /// Throws Problem if so many more bytes do not fit.
    PlannedMemory(std::size_t bytes, const ImageReader::Header& header) : bytes_(bytes) {
        constexpr std::size_t alwaysFine = 1 << 26;
        const std::size_t all = planned_ += bytes_;
        if (bytes_ <= alwaysFine || all <= availableMemory()) return;
        planned_ -= bytes_;
        constexpr double gigabyte = 1e9;
        throw Problem{fmt::format("it has {} x {} pixels, which take {:.1f} GB, and there is not as much memory", header.width,
                                  header.height, static_cast<double>(bytes_) / gigabyte)};
    }
    ~PlannedMemory() { planned_ -= bytes_; }
    PlannedMemory(const PlannedMemory&) = delete;
    PlannedMemory& operator=(const PlannedMemory&) = delete;

private:
    static inline std::atomic<std::size_t> planned_ = 0;
    std::size_t bytes_;
};

/// What an image takes: as read, and twice with the channels that are kept, since it moves to the scene's tables.
std::size_t bytesToRead(const ImageReader::Header& header, std::size_t kept, bool isBytes) {
    const std::size_t values = header.channels.size() + 2 * kept;
    return header.pixels() * values * (isBytes ? 1 : sizeof(float));
}

/// The indices of R G B (A) in the file, or of its only channel.
std::vector<int> pickChannels(const ImageReader::Header& header) {
    const auto find = [&](const char* name) {
        const auto found =
            std::ranges::find_if(header.channels, [&](const std::string& n) { return ::strcasecmp(n.c_str(), name) == 0; });
        return found == header.channels.end() ? -1 : static_cast<int>(found - header.channels.begin());
    };
    if (header.channels.size() == 1) return {0};
    const int r = find("R"), g = find("G"), b = find("B"), a = find("A");
    if (r >= 0 && g >= 0 && b >= 0) return a >= 0 ? std::vector{r, g, b, a} : std::vector{r, g, b};
    if (const int grey = find("Y"); grey >= 0) return {grey};
    std::string names;
    for (const std::string& name : header.channels) names += (names.empty() ? "" : " ") + name;
    throw Problem{"it has none of the channels R G B or Y; its channels: " + names};
}

// ---- values -----------------------------------------------------------------------------------------------------------------

template <class T> std::vector<T> readPicked(ImageReader& input, const std::vector<int>& picked) {
    const std::size_t pixels = input.header().pixels(), channels = input.header().channels.size(), kept = picked.size();
    std::vector<T> all(pixels * channels);
    if (!input.read(all.data())) throw Problem{input.error()};
    bool inPlace = kept == channels;
    for (std::size_t k = 0; k < kept; ++k) inPlace = inPlace && picked[k] == static_cast<int>(k);
    if (inPlace) return all;
    std::vector<T> result(pixels * kept);
    for (std::size_t i = 0; i < pixels; ++i)
        for (std::size_t k = 0; k < kept; ++k) result[i * kept + k] = all[i * channels + static_cast<std::size_t>(picked[k])];
    return result;
}

template <class T> void dropChannel3(std::vector<T>& values) {
    for (std::size_t i = 0; i < values.size() / 4; ++i) std::copy_n(&values[4 * i], 3, &values[3 * i]);
    values.resize(values.size() / 4 * 3);
}

template <class T> bool isOpaque(const std::vector<T>& values, T one) {
    for (std::size_t i = 3; i < values.size(); i += 4)
        if (values[i] != one) return false;
    return true;
}

/// The matrix from the file's primaries to those of sRGB; nothing if they are the same.
std::optional<glm::dmat3> conversion(const ImageReader& file) {
    const std::optional<Primaries> primaries = file.chromaticities();
    if (!primaries) return {};
    const auto matrix = srgbFromPrimaries(*primaries);
    if (matrix && !std::isfinite(glm::dot((*matrix)[0] + (*matrix)[1] + (*matrix)[2], glm::dvec3(1))))
        throw Problem{"its chromaticities are not those of a colour space"};
    return matrix;
}

void convert(std::vector<float>& values, std::size_t channels, const glm::dmat3& matrix) {
    if (channels < 3) return;
    for (std::size_t i = 0; i < values.size(); i += channels) {
        const glm::dvec3 color = matrix * glm::dvec3(values[i], values[i + 1], values[i + 2]);
        for (int c = 0; c < 3; ++c) values[i + static_cast<std::size_t>(c)] = static_cast<float>(color[c]);
    }
}

std::size_t replaceNonFinite(std::vector<float>& values) {
    std::size_t count = 0;
    for (float& value : values) {
        if (std::isfinite(value)) continue;
        value = std::isnan(value) ? 0.f : std::copysign(mostHalf, value);
        ++count;
    }
    return count;
}

ImageData read(const ImageFile& file) {
    const auto input = open(file.path);
    const ImageReader::Header& header = input->header();
    checkPlausible(file.path, header);
    const std::vector<int> picked = pickChannels(header);

    ImageData image;
    image.width = header.width;
    image.height = header.height;
    image.channels = static_cast<int>(picked.size());
    const bool isInteger = !header.isFloatingPoint;
    const bool isLinear = file.encoding == ColorEncoding::linear;
    const bool isBytes = header.isBytes && file.gamma <= 0;
    const PlannedMemory memory(bytesToRead(header, picked.size(), isBytes), header);
    if (isBytes) {
        image.format = isLinear ? format_linear8 : format_srgb8;
        image.bytes = readPicked<std::uint8_t>(*input, picked);
        if (image.channels == 4 && isOpaque<std::uint8_t>(image.bytes, 255)) { dropChannel3(image.bytes); image.channels = 3; }
        return image;
    }
    image.floats = readPicked<float>(*input, picked);
    if (image.channels == 4 && isOpaque(image.floats, 1.f)) { dropChannel3(image.floats); image.channels = 3; }
    image.replaced = replaceNonFinite(image.floats);
    if (isInteger && file.gamma > 0)
        for (float& value : image.floats) value = static_cast<float>(std::pow(value, file.gamma));
    else if (isInteger && !isLinear)
        for (float& value : image.floats) value = static_cast<float>(linearFromSrgb(value));
    if (const auto matrix = conversion(*input)) convert(image.floats, static_cast<std::size_t>(image.channels), *matrix);
    return image;
}

}  // namespace

std::shared_ptr<const ImageData> loadImage(const ImageFile& file) {
    if (file.pixels) return file.pixels;
    if (auto before = keptImage(file)) {
        noteInputFile(file.path);
        return before;
    }
    try {
        const FileStamp stamp = stampOf(file.path);
        const auto image = std::make_shared<const ImageData>(read(file));
        keepImage(file, stamp, image);
        return image;
    } catch (const Problem& problem) {
        throw SceneError(file.where, fmt::format("cannot read image \"{}\": {}", file.path, problem.message));
    } catch (const std::bad_alloc&) {
        throw SceneError(file.where, fmt::format("cannot read image \"{}\": not enough memory", file.path));
    }
}

int addImage(Scene& scene, ImageFile file) {
    const auto found = std::ranges::find(scene.images, file);
    if (found != scene.images.end()) return static_cast<int>(found - scene.images.begin());
    if (!file.pixels) beginLoadingImageFormats();
    scene.images.push_back(std::move(file));
    return static_cast<int>(scene.images.size()) - 1;
}

std::vector<std::shared_ptr<const ImageData>> loadImages(std::span<const ImageFile> files) {
    std::vector<std::shared_ptr<const ImageData>> images(files.size());
    forEachInParallel(files.size(), [&](std::size_t i) { images[i] = loadImage(files[i]); });
    return images;
}

ImageData scalarImage(const ImageData& image) {
    const std::size_t pixels = static_cast<std::size_t>(image.width) * image.height, channels = static_cast<std::size_t>(image.channels);
    ImageData result{.width = image.width, .height = image.height, .channels = 1, .format = image.format, .replaced = image.replaced};
    if (channels != 3) {
        const std::size_t picked = channels - 1;
        for (std::size_t i = 0; i < image.bytes.size(); i += channels) result.bytes.push_back(image.bytes[i + picked]);
        for (std::size_t i = 0; i < image.floats.size(); i += channels) result.floats.push_back(image.floats[i + picked]);
        return result;
    }

    // Check for grey stored as colour, as in most bump and roughness maps: it needs no mean.
    bool isGrey = !image.bytes.empty();
    for (std::size_t i = 0; i < image.bytes.size() && isGrey; i += 3)
        isGrey = image.bytes[i] == image.bytes[i + 1] && image.bytes[i] == image.bytes[i + 2];
    if (isGrey) {
        for (std::size_t i = 0; i < image.bytes.size(); i += 3) result.bytes.push_back(image.bytes[i]);
        return result;
    }
    result.format = format_float;
    result.floats.resize(pixels);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            result.floats[static_cast<std::size_t>(y) * image.width + x] = (image.at(x, y, 0) + image.at(x, y, 1) + image.at(x, y, 2)) / 3;
    return result;
}

}  // namespace eikonal
