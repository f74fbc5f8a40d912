#pragma once
// A rendered image in memory, and what is known about how it was made.

#include "image/cryptomatte.h"
#include "scene/film.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace eikonal {

/// The spectrum of each pixel, in buckets of equal width.
struct PixelSpectra {
    std::vector<double> wavelengths;   ///< nm, ascending: the centres of the buckets
    std::vector<float> radiance;       ///< [i * wavelengths.size() + b]: mean over bucket b of pixel i, before sensor and exposure
};

/// The light of one light group.
struct LightGroup {
    std::string name;
    std::vector<glm::vec3> color;
};

/// An image in linear sRGB. `bounds` is the part of the whole image that is present: all of it, or a crop. Each non-empty vector has one
/// entry per pixel in bounds, row by row from the top.
struct FilmImage {
    int width = 0, height = 0;     ///< of the whole image
    PixelBounds bounds;            ///< inside [0, width) x [0, height), except in files of other programs
    std::vector<glm::vec3> color;  ///< radiance as the film received it

    std::vector<glm::vec3> noisy;      ///< of a denoised image: color before (image/denoise.h)
    std::vector<glm::vec3> fireflies;  ///< what color, or `noisy`, lacks of the mean of the samples (film/fireflies.h); empty: nothing
    std::vector<glm::vec3> emission, direct, indirect, volume;   ///< render passes (enum render_pass), which sum to color, or to `noisy`,
                                                                ///< with fireflies
    std::vector<glm::vec3> albedo;     ///< in [0, 1], of the first surface that is not a mirror or clear glass, as seen through those
    std::vector<glm::vec3> normal;     ///< shading normal of the first surface, world space, unit length or zero
    std::vector<glm::vec3> geometricNormal;  ///< geometric normal of the first surface, on the same side
    std::vector<glm::vec3> position;   ///< of the first surface, world space: mean over the samples that hit one; zero: none did
    std::vector<glm::vec2> uv;         ///< texture coordinates of the first surface: mean over the samples that hit one; zero: none did
    std::vector<glm::vec2> depthSlope; ///< change of camera-space z to the next pixel right and down, on the tangent plane; 0: no surface
    std::vector<glm::vec2> motion;     ///< motion in pixels, right and down, while the shutter is open; zero: no surface
    std::vector<float> depth;          ///< distance to the first surface, world units; infinity: no surface
    std::vector<float> object;         ///< the object that most samples hit: 1, 2, 3 ..., shapes before instances; 0: none
    std::vector<float> material;       ///< the material that most samples hit: 1, 2, 3 ...; 0: none
    std::vector<float> variance;       ///< variance of the pixel's mean luminance
    std::vector<float> sampleCount;    ///< samples taken in the pixel
    std::vector<glm::vec3> sampleVariance;    ///< variance of a sample, for pbrt's readers (image/sample_variance.h)
    std::vector<glm::vec3> relativeVariance;  ///< the same over the mean
    std::vector<LightGroup> lightGroups;   ///< which sum to color, or to `noisy`; empty unless the film keeps them
    std::vector<CryptomatteLayer> cryptomattes;   ///< empty unless the film keeps them
    PixelSpectra spectrum;             ///< empty unless the film keeps one
    bool halfFloats = false;           ///< FilmDescription::halfFloats

    FilmImage() = default;
    /// A black image of the whole frame, or of the part within bounds.
    FilmImage(int width, int height) : FilmImage(width, height, {0, width, 0, height}) {}
    FilmImage(int width, int height, const PixelBounds& part) : width(width), height(height), bounds(part), color(pixelCount()) {}

    int columns() const { return bounds.x1 - bounds.x0; }
    int rows() const { return bounds.y1 - bounds.y0; }
    std::size_t pixelCount() const { return static_cast<std::size_t>(columns()) * static_cast<std::size_t>(rows()); }
    /// Index of pixel (x, y) of the whole image, which must be in bounds, in the vectors.
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y - bounds.y0) * columns() + static_cast<std::size_t>(x - bounds.x0);
    }
};

/// How an image was made. Stored as file attributes with the names in brackets. Unset: not stored.
struct Metadata {
    std::optional<int> samples;              ///< per pixel, or the fewest of any pixel [samplesPerPixel]
    std::optional<double> meanSamples;       ///< mean over all pixels, if they differ [meanSamplesPerPixel]
    std::optional<double> targetError;       ///< of adaptive sampling [targetError]
    std::optional<double> error;             ///< of the image, estimated [errorEstimate]
    std::optional<double> errorLow;          ///< the true error is above this with a probability of about 97.5 % [errorLow]
    std::optional<double> errorHigh;         ///< and below this [errorHigh]
    std::string errorMetric;                 ///< what the error is, and the target [errorMetric]
    std::string errorDoubt;                  ///< why the estimate is not reliable; empty: it is [errorDoubt]
    std::optional<double> firefliesShare;    ///< of the light of the whole image that is in `fireflies` [firefliesShare]
    std::string partial;                     ///< which samples that were asked for are missing; empty: none [partial]
    std::optional<double> renderSeconds;     ///< wall-clock time [renderTimeSeconds]
    std::optional<int> seed;                 ///< [seed]
    std::string version;                     ///< the program and its version, "Eikonal 0.1.0" [Software]
    std::string scene;                       ///< the scene's file [scene]
    std::string sceneHash;                   ///< [sceneHash]
    std::string device;                      ///< the OpenCL device [device]
    std::string biasedChoices;               ///< render/biased_choices.h [biasedChoices]
    std::string commandLine;                 ///< [commandLine]
    std::optional<std::array<float, 16>> worldToCamera;   ///< row by row, for column vectors: when the shutter opens [worldToCamera]
    std::optional<std::array<float, 16>> worldToNdc;      ///< likewise: CameraTraits::screenFromCamera, from [-1, 1] to [0, 1] [worldToNDC]
    bool operator==(const Metadata&) const = default;
};

}  // namespace eikonal
