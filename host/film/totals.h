#pragma once
// What a film has added up of each pixel, with the per-pixel fields of include/eikonal/film.h, and what follows from it: the image, and
// its error.

#include "device/layout.h"
#include "film/noise.h"
#include "film/splats.h"
#include "image/film_image.h"
#include "pack/tables.h"

#include <memory>
#include <optional>

namespace eikonal {

class FilmTotals {
public:
    /// words: word w of pixel i of the pixels that are rendered of the scene is words[w * number of pixels + i]. splats: of the same
    /// pixels; null: none.
    FilmTotals(const PackedScene& scene, const QueueLayout& layout, std::shared_ptr<uint[]> words, const SplatSums* splats = nullptr);

    const PixelRect& pixels() const { return pixels_; }

    /// The image so far: sums divided by weights. Distances and positions are in world space of `scene`.
    FilmImage develop(const PackedScene& scene) const;

    /// The number of samples that were not finite, and the first pixel with one.
    struct Invalid { size_t count = 0; int x = -1, y = -1; };
    Invalid invalid() const;
    /// The fewest, most and mean samples per pixel.
    struct Samples { unsigned fewest = 0, most = 0; double mean = 0; };
    Samples samples() const;
    /// What a metric adds to the square of a pixel's luminance, by which it divides the pixel's squared error; nothing if it does not.
    std::optional<double> relativeFloor(ErrorMetric metric) const;
    /// What the samples of the pixels of `part`, a part of pixels(), say about their error; see noise.h. floor: of the metric, see above.
    /// decay: of the variance.
    NoiseSums noise(const PixelRect& part, std::optional<double> floor, double decay = 1) const;
    /// The error of the image.
    ErrorEstimate error(ErrorMetric metric) const;

private:
    /// Of each pixel, by words of a colour that begin at `sum`: its mean over the samples.
    std::vector<glm::vec3> meanColors(const float* sum) const;
    void reweightFireflies(FilmImage& image) const;
    void developPasses(FilmImage& image) const;
    void developLightGroups(FilmImage& image, const std::vector<std::string>& names) const;
    /// field: the film's. name, manifest: of the layer.
    void developMattes(FilmImage& image, const char* field, const char* name, const std::string& manifest) const;
    void developAovs(FilmImage& image, const PackedScene& scene) const;
    void developSpectrum(FilmImage& image, const PackedScene& scene) const;
    size_t plane() const { return static_cast<size_t>(pixels_.width()) * static_cast<size_t>(pixels_.height()); }
    size_t index(int x, int y) const {
        return static_cast<size_t>(y - pixels_.y0) * static_cast<size_t>(pixels_.width()) + static_cast<size_t>(x - pixels_.x0);
    }
    void developSplats(const SplatSums& splats, double scale);
    struct Planes;
    /// suspicion: how far a pixel's squared error, relative to that luminance, may be from what it is taken for: its mean square.
    struct ExpectedLuminance { double luminance, suspicion; };
    ExpectedLuminance expectedLuminance(const Planes& planes, int x, int y, double floor) const;
    const float* floats(const char* field) const;
    const uint* numbers(const char* field) const;
    int width_, height_;
    PixelRect pixels_;
    QueueLayout layout_;
    std::shared_ptr<uint[]> data_;
    std::vector<glm::vec3> splatColors_;      ///< what light paths add to each pixel; empty: nothing
    std::vector<glm::vec3> directSplats_, indirectSplats_, volumeSplats_;   ///< the same by render pass, if the film has them
    std::vector<float> splatVariances_;       ///< of its luminance
    std::vector<unsigned> lostSplats_;        ///< how many were too bright
};

}  // namespace eikonal
