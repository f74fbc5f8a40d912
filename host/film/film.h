#pragma once
// The film in host memory: per pixel what include/eikonal/film.h lists. The device sees some blocks of it at a time, so an
// image may be as large as the host's memory.

#include "device/buffer.h"
#include "device/layout.h"
#include "image/film_image.h"
#include "render/batch.h"

#include <memory>

namespace eikonal {

class Film {
public:
    /// Of the pixels that are rendered of a scene, by kernels with these features. Memory is only taken where something is written.
    Film(const PackedScene& scene, const Features& features);
    explicit Film(const PackedScene& scene) : Film(scene, scene.features) {}

    const PixelRect& pixels() const { return pixels_; }
    int words() const { return layout_.words; }

    /// Enqueues copies of the pixels of a batch to and from a buffer that holds its blocks one after another. Does not wait.
    void upload(const Context& context, const Buffer& buffer, const Batch& batch) const;
    void download(const Context& context, const Buffer& buffer, const Batch& batch);

    /// Bytes a pixel of the film of a scene, and of what develop returns.
    static size_t bytes(const PackedScene& scene);
    static size_t developedBytes(const PackedScene& scene);
    /// The image so far: sums divided by weights. Distances and positions in the world of `scene`.
    FilmImage develop(const PackedScene& scene) const;

    /// Samples that were not finite, and the first pixel that has one.
    struct Invalid { size_t count = 0; int x = -1, y = -1; };
    Invalid invalid() const;
    /// The fewest and the most samples that any pixel has, and those of all pixels.
    struct Samples { unsigned fewest = 0, most = 0; double mean = 0; };
    Samples samples() const;
    /// The expected relative squared error of the pixels of `part`, added up: of each the variance of its mean luminance over that luminance squared + 0.01.
    /// As samples vary that are independent: those of a Sobol' sequence have less.
    double relativeVariance(const PixelRect& part) const;

private:
    struct Free { void operator()(void* p) const { std::free(p); } };
    void developAovs(FilmImage& image, const PackedScene& scene) const;
    void developSpectrum(FilmImage& image, const PackedScene& scene) const;
    size_t plane() const { return static_cast<size_t>(pixels_.width()) * static_cast<size_t>(pixels_.height()); }
    struct Planes;
    const float* floats(const char* field) const;
    const uint* numbers(const char* field) const;
    int width_, height_;
    PixelRect pixels_;
    QueueLayout layout_;
    std::unique_ptr<uint[], Free> data_;   ///< word w of pixel i: [w * plane + i]
};

}  // namespace eikonal
