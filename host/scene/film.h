#pragma once
// The film of a scene, and its sampler.

#include "error.h"
#include "color/observer.h"

#include <array>
#include <optional>
#include <string>
#include <utility>

namespace eikonal {

struct PixelBounds { int x0 = 0, x1 = 0, y0 = 0, y1 = 0; };  ///< x0 <= x < x1

/// The additional channels of pbrt-v4's film "gbuffer", and the space of their positions and normals.
enum class GBuffer { none, cameraSpace, worldSpace };

/// pbrt-v4's kinds of film.
enum class FilmKind { rgb, gbuffer, spectral };

/// The spectrum that a film keeps for each pixel: buckets of equal width from `first` to `last` nm, which lie in [360, 830] and are at
/// least 1 nm apart.
struct SpectrumKept { int buckets = 16; double first = 360, last = 830; };

struct FilmDescription {
    int width = 1280, height = 720;
    std::optional<std::array<double, 4>> cropWindow;     ///< x0 x1 y0 y1 in [0, 1]
    std::optional<PixelBounds> pixelBounds;
    SourceLocation cropPlace;   ///< what asked for either; without a file: `where`
    std::string filename;                                ///< empty: named after the scene
    double diagonal = 35;                                ///< of a realistic camera's film, millimetres
    double iso = 100, exposureTime = 1, whiteBalance = 0;
    std::string sensor = "cie1931";                      ///< with iso, exposureTime and whiteBalance: see color/sensor.h
    ColorSpace colorSpace = ColorSpace::srgb;            ///< of the image
    double maxComponentValue = 0;                        ///< > 0: brighter samples are scaled down to this
    bool reweightsFireflies = false;                     ///< see film/fireflies.h
    GBuffer gbuffer = GBuffer::none;
    std::optional<SpectrumKept> spectrum;                ///< for pbrt-v4's film "spectral"
    bool halfFloats = false;                             ///< store colours and normals in 16 bits where the file can
    std::string errorReference, errorLog;                ///< files: the mean squared error against the first is logged in the second
    SourceLocation where;
};

/// The shape of a pixel filter (kinds/filter_kind.h).
struct FilterKind;
extern const FilterKind gaussian_filter;

struct FilterDescription {
    const FilterKind* kind = &gaussian_filter;
    double xRadius = 1.5, yRadius = 1.5; ///< box only: 0 is the centre of the pixel
    double sigma = 0.5;                  ///< gaussian
    double B = 1. / 3, C = 1. / 3;       ///< mitchell
    double tau = 3;                      ///< sinc
    SourceLocation where;
};

/// independent: uncorrelated numbers. paddedsobol: a low-discrepancy sequence for each pixel and each dimension. sobol: the first
/// dimensions of a path share one sequence. zsobol: so do neighbouring pixels, so blocks of pixels are sampled as evenly as pixels, and the
/// remaining error is blue noise.
enum class SamplerKind { independent, paddedsobol, sobol, zsobol };
/// The names for --sampler.
inline constexpr std::pair<const char*, SamplerKind> samplerNames[] = {{"independent", SamplerKind::independent},
                                                                       {"paddedsobol", SamplerKind::paddedsobol},
                                                                       {"sobol", SamplerKind::sobol},
                                                                       {"zsobol", SamplerKind::zsobol}};

struct SamplerDescription { SamplerKind kind = SamplerKind::zsobol; int pixelSamples = 16; int seed = 0; SourceLocation where; };

}  // namespace eikonal
