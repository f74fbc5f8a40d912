#pragma once
// The film in host memory, with the per-pixel fields of include/eikonal/film.h. The device holds some blocks of it at a time, so an image
// may be as large as host memory.

#include "device/buffer.h"
#include "device/layout.h"
#include "image/film_image.h"
#include "film/batch.h"
#include "film/noise.h"

#include <memory>

namespace eikonal {

class Film {
public:
    /// The film of the pixels that are rendered of a scene, for kernels built with `features`. Memory pages are taken only when written.
    Film(const PackedScene& scene, const Features& features);
    explicit Film(const PackedScene& scene) : Film(scene, scene.features) {}

    const PixelRect& pixels() const { return pixels_; }
    int words() const { return layout_.words; }

    /// Enqueue copies of a batch's pixels to or from a buffer that holds its blocks one after the other. Do not wait.
    void upload(const Context& context, const Buffer& buffer, const Batch& batch) const;
    void download(const Context& context, const Buffer& buffer, const Batch& batch);

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
    struct Planes;
    double expectedLuminance(const Planes& planes, int x, int y) const;
    const float* floats(const char* field) const;
    const uint* numbers(const char* field) const;
    int width_, height_;
    PixelRect pixels_;
    QueueLayout layout_;
    std::unique_ptr<uint[], Free> data_;   ///< word w of pixel i: [w * plane + i]
};

}  // namespace eikonal
