#pragma once
// Ways through a medium of every kind, as paths and shadow rays go them, and integrals along them of what the medium says of itself.

#include "device_function.h"
#include "stage.h"
#include "statistics.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace eikonal {

/// A file with the grids "density" and "temperature", of this process.
std::string nanoVdbFile();
/// A medium of each kind, with colours that differ, around the origin; most shine.
std::string parametersOf(const std::string& kind);

/// The sphere makes scene space what world space is.
PackedScene sceneWith(const std::string& kind, const std::string& parameters, const std::string& lights = "");

using Channels = std::array<double, 3>;
inline Channels channelsOf(spectrum s) { return {s.r, s.g, s.b}; }

struct MediumRay { vec3 o, d; };
constexpr float wayLength = 2;
/// Through the media, along an axis and askew; the second starts inside.
inline const std::array<MediumRay, 3> rays = {MediumRay{{-0.9f, 0.3f, 0.1f}, {1, 0, 0}},
                                              MediumRay{{0.1f, 0.25f, 0.05f}, {-0.48f, 0.6f, 0.64f}},
                                              MediumRay{{0.05f, -0.7f, -0.3f}, {0, 0.8f, 0.6f}}};

struct Integrals {
    spectrum tau, absorbed, scattered, emitted;
};  ///< up to a distance; the last three: of sigma * T, and sigma_a * Le * T
const DeviceFunction<Integrals>& integrate();

struct Walked { uint end; float t; spectrum beta, r_u, r_l, L; };
/// A path's way, and a shadow ray's to a light that nothing else could find.
const DeviceFunction<Walked>& track();
const DeviceFunction<Walked>& attenuate();

/// n walks along a ray; heroes take turns, or are all the same.
std::vector<Walked> walk(const DeviceFunction<Walked>& function, const DeviceScene& scene, const MediumRay& ray, float t, size_t n,
                         int hero = -1);

inline double mean(spectrum s) { return (double(s.r) + s.g + s.b) / 3; }
inline bool finite(spectrum s) { return std::isfinite(s.r) && std::isfinite(s.g) && std::isfinite(s.b); }

/// Holds an estimate to what it estimates: within what chance does once in a hundred thousand times, and what quadrature gets wrong.
void expectMean(const Accumulator& a, double expected, const std::string& what);

/// Holds what becomes of paths along a ray to the integrals, and single paths to weighing no more than they can.
void expectWeights(const DeviceScene& scene, const MediumRay& ray);

}  // namespace eikonal
