#pragma once
// The film in host memory, with the per-pixel fields of include/eikonal/film.h. The device holds some blocks of it at a time, so an image
// may be as large as host memory.

#include "device/buffer.h"
#include "device/layout.h"
#include "image/film_image.h"
#include "film/batch.h"
#include "film/noise.h"

#include <memory>
#include <span>
#include <vector>

namespace eikonal {

class Film {
public:
    /// The film of the pixels that are rendered of a scene, for kernels built with `features`. Memory pages are taken only when written.
    Film(const PackedScene& scene, const Features& features);
    explicit Film(const PackedScene& scene) : Film(scene, scene.features) {}

    const PixelRect& pixels() const { return pixels_; }
    int words() const { return layout_.words; }
    const QueueLayout& layout() const { return layout_; }

    /// Copies a batch's pixels to a buffer that holds its blocks one after the other.
    void upload(const Context& context, Buffer& buffer, const Batch& batch);
    /// Waits for such a buffer, and reads it. The film does not change before keep().
    void download(const Context& context, const Buffer& buffer, const Batch& batch);
    /// Takes over what download() has read: the batch's samples are now part of the film.
    void keep(const Batch& batch);

    /// Samples taken of each pixel, row by row; also those that do not count because they missed the lens.
    std::span<const unsigned> taken() const { return taken_; }
    /// Word `word` of the pixels of row y, which is counted from the top of the whole image.
    std::span<const uint> row(int word, int y) const { return {&data_[rowStart(word, y)], static_cast<size_t>(pixels_.width())}; }
    /// Replaces the pixels x0 <= x < x1 of row y: each now has `samples` samples, and word w of pixel x is words[w * (x1 - x0) + x - x0].
    void restore(int y, int x0, int x1, unsigned samples, std::span<const uint> words);

    /// Bytes per pixel of the film, and of the image that develop() returns.
    static size_t bytes(const PackedScene& scene);
    static size_t developedBytes(const PackedScene& scene);
    /// The image so far: sums divided by weights. Distances and positions are in world space of `scene`.
    FilmImage develop(const PackedScene& scene) const;

    /// The number of samples that were not finite, and the first pixel with one.
    struct Invalid { size_t count = 0; int x = -1, y = -1; };
    Invalid invalid() const;
    /// The fewest, most and mean samples per pixel.
    struct Samples { unsigned fewest = 0, most = 0; double mean = 0; };
    Samples samples() const;
    /// What the samples of the pixels of `part`, a part of pixels(), say about their error; see noise.h. decay: of the variance.
    NoiseSums noise(const PixelRect& part, ErrorMetric metric, double decay = 1) const;
    /// The error of the image.
    ErrorEstimate error(ErrorMetric metric) const;

private:
    struct Free { void operator()(void* p) const { std::free(p); } };
    void developAovs(FilmImage& image, const PackedScene& scene) const;
    void developSpectrum(FilmImage& image, const PackedScene& scene) const;
    size_t plane() const { return static_cast<size_t>(pixels_.width()) * static_cast<size_t>(pixels_.height()); }
    size_t index(int x, int y) const {
        return static_cast<size_t>(y - pixels_.y0) * static_cast<size_t>(pixels_.width()) + static_cast<size_t>(x - pixels_.x0);
    }
    size_t rowStart(int word, int y) const { return static_cast<size_t>(word) * plane() + index(pixels_.x0, y); }
    template <class Copy> void forStagedRows(const Batch& batch, Copy copy);
    struct Planes;
    double expectedLuminance(const Planes& planes, int x, int y) const;
    const float* floats(const char* field) const;
    const uint* numbers(const char* field) const;
    int width_, height_;
    PixelRect pixels_;
    QueueLayout layout_;
    std::unique_ptr<uint[], Free> data_;   ///< word w of pixel i: [w * plane + i]
    std::vector<unsigned> taken_;
    std::vector<uint> staged_;             ///< pixels of a batch, on their way to or from the device
};

}  // namespace eikonal
