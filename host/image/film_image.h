#pragma once
// A rendered image in memory, and what is known about how it was made.

#include "scene/scene.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace eikonal {

/// The spectrum of each pixel, in buckets of equal width.
struct PixelSpectra {
    std::vector<double> wavelengths;   ///< nm, ascending: the middles of the buckets
    std::vector<float> radiance;       ///< its mean over bucket b in pixel i: [i * wavelengths.size() + b]; a light whose spectrum is 1 everywhere has 1. Not exposed: what comes before sensor and iso
};

/// Pixels of linear sRGB light. `bounds` are those of the whole image that are present: all of them, or a crop. Every non-empty vector has
/// one entry for each pixel in bounds, row by row from the top.
struct FilmImage {
    int width = 0, height = 0;     ///< of the whole image
    PixelBounds bounds;            ///< inside of [0, width) x [0, height), except in files of others
    std::vector<glm::vec3> color;  ///< radiance as the film saw it

    std::vector<glm::vec3> albedo;     ///< in [0, 1], of the first surface that is not a mirror or clear glass, as seen through those
    std::vector<glm::vec3> normal;     ///< of the first surface: shading normal, world space, unit length or zero
    std::vector<glm::vec3> geometricNormal;  ///< of the first surface, on the same side
    std::vector<glm::vec3> position;   ///< of the first surface, world space: mean over the samples that saw one; zero: none did
    std::vector<glm::vec2> uv;         ///< texture coordinates of the first surface: mean over the samples that saw one; zero: none did
    std::vector<glm::vec2> depthSlope; ///< camera units: how much z of the camera's space changes from pixel to pixel, to the right and down, on the plane that touches the first surface; >= 0; zero: none
    std::vector<glm::vec2> motion;     ///< pixels, x to the right and y down, that the first surface's point moves in the image while the shutter is open; zero: none
    std::vector<float> depth;          ///< distance to the first surface, world units; infinity: none
    std::vector<float> object;         ///< which object most samples saw: 1, 2, 3 ... in the order of the scene, shapes before instances; 0: none
    std::vector<float> material;       ///< which material most samples saw: 1, 2, 3 ...; 0: none
    std::vector<float> variance;       ///< of the pixel's mean luminance: its standard error squared
    std::vector<float> sampleCount;    ///< samples taken in the pixel
    PixelSpectra spectrum;             ///< of a film that keeps one, otherwise empty

    FilmImage() = default;
    /// A black image, or the part of it within bounds.
    FilmImage(int width, int height) : FilmImage(width, height, {0, width, 0, height}) {}
    FilmImage(int width, int height, const PixelBounds& part) : width(width), height(height), bounds(part), color(pixelCount()) {}

    int columns() const { return bounds.x1 - bounds.x0; }
    int rows() const { return bounds.y1 - bounds.y0; }
    std::size_t pixelCount() const { return static_cast<std::size_t>(columns()) * static_cast<std::size_t>(rows()); }
    /// Where pixel (x, y) of the whole image, which must be in bounds, is in the vectors.
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y - bounds.y0) * columns() + static_cast<std::size_t>(x - bounds.x0);
    }
};

/// How an image was made. Kept as attributes of the file under the names in brackets (the first two are pbrt-v4's). Unset: left out.
struct Metadata {
    std::optional<int> samples;              ///< for each pixel, or the fewest of any [samplesPerPixel]
    std::optional<double> meanSamples;       ///< of all pixels, if they differ [meanSamplesPerPixel]
    std::optional<double> targetError;       ///< that sampling was to come down to [targetError]
    std::optional<double> renderSeconds;     ///< wall-clock time [renderTimeSeconds]
    std::optional<int> seed;                 ///< [seed]
    std::string version;                     ///< the program and its version, "Eikonal 0.1.0" [Software]
    std::string scene;                       ///< the scene's file [scene]
    std::string sceneHash;                   ///< [sceneHash]
    std::string device;                      ///< the OpenCL device [device]
    std::string commandLine;                 ///< [commandLine]
    bool operator==(const Metadata&) const = default;
};

}  // namespace eikonal
