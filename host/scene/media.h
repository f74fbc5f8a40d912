#pragma once
// Participating media of a scene.

#include "error.h"
#include "scene/basics.h"
#include "color/spectrum.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace eikonal {

/// Values on a regular grid, x fastest.
struct Grid {
    int nx = 1, ny = 1, nz = 1;
    std::vector<float> values;
};

/// A sparse grid of numbers in blocks of 8 x 8 x 8 voxels, as a VDB tree stores them.
struct SparseGrid {
    glm::ivec3 low{0}, high{0};            ///< inclusive bounds of the voxels that may differ from 0
    glm::ivec3 firstBlock{0}, blocks{0};   ///< the blocks of these voxels: block b has the voxels 8 b ... 8 b + 7
    std::vector<std::uint32_t> blockOf;    ///< x fastest: which 512 of `values`; empty: all zero
    std::vector<float> values;             ///< 512 for each stored block, x fastest; not negative
    Transform voxelFromMedium{1};          ///< maps the medium's space to the space where voxel (i, j, k) is at the point (i, j, k)
    static constexpr std::uint32_t empty = 0xffffffffu;
};

/// Colours on regular grids, x fastest; grids that are not given are empty.
struct ColorGrid {
    int nx = 1, ny = 1, nz = 1;
    std::vector<glm::vec3> sigmaA, sigmaS, Le;
    ColorSpace space = ColorSpace::srgb;
};

struct MediumKind;   // host/kinds/medium_kind.h

/// A medium. Which fields count depends on its kind (host/kinds/medium/); the others keep their defaults.
struct Medium {
    const MediumKind* kind = nullptr;   ///< never null in a scene
    std::string name;
    Spectrum sigmaA, sigmaS;       ///< per world unit, "scale" included; rgbgrid: only the scale, which its colours multiply
    Spectrum Le;                   ///< "Lescale" included, if it is a single number
    double g = 0;
    glm::dvec3 p0{0}, p1{1};       ///< heterogeneous media: their box in medium space
    Transform worldFromMedium{1};
    std::optional<Transform> worldFromMediumAtEnd;   ///< set: the medium moves, and has this transform at Scene::motionEnd

    Grid density;                  ///< uniformgrid
    Grid temperature, LeScale;     ///< uniformgrid: empty if not given
    std::shared_ptr<const SparseGrid> sparseDensity, sparseTemperature;  ///< nanovdb; the temperature may be null
    double temperatureOffset = 0, temperatureScale = 1;                  ///< kelvin = (temperature - offset) * scale
    double emissionScale = 1;      ///< factor of emission by temperature or by a grid of colours
    ColorGrid colors;              ///< rgbgrid
    double noiseDensity = 1, wispiness = 1, frequency = 5;               ///< cloud

    SourceLocation where;
};

}  // namespace eikonal
