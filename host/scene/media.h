#pragma once
// Participating media of a scene.

#include "error.h"
#include "scene/basics.h"
#include "color/spectrum.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace eikonal {

/// Values on a regular grid, x fastest.
struct Grid {
    int nx = 1, ny = 1, nz = 1;
    std::vector<float> values;
};

/// Numbers on a sparse grid, in blocks of 8 x 8 x 8 voxels: what a VDB tree holds.
struct SparseGrid {
    glm::ivec3 low{0}, high{0};            ///< bounds, inclusive, of the voxels that may differ from 0
    glm::ivec3 firstBlock{0}, blocks{0};   ///< the blocks that hold them: block b is the voxels 8 b ... 8 b + 7
    std::vector<std::uint32_t> blockOf;    ///< x fastest: which 512 of `values`; empty: 0 everywhere
    std::vector<float> values;             ///< 512 for each stored block, x fastest; not negative
    Transform voxelFromMedium{1};          ///< to where voxel (i, j, k) has its value at the point (i, j, k)
    static constexpr std::uint32_t empty = 0xffffffffu;
};

/// Colours on a regular grid, x fastest; those that are not given are empty.
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
    Spectrum sigmaA, sigmaS;       ///< per world unit, "scale" multiplied in; rgbgrid: that alone, for its colours to multiply
    Spectrum Le;                   ///< "Lescale" multiplied in, if it is one number
    double g = 0;
    glm::dvec3 p0{0}, p1{1};       ///< heterogeneous: its box in the medium's own space
    Transform worldFromMedium{1};

    Grid density;                  ///< uniformgrid
    Grid temperature, LeScale;     ///< uniformgrid: empty if not given
    std::shared_ptr<const SparseGrid> sparseDensity, sparseTemperature;  ///< nanovdb; the temperature may be null
    double temperatureOffset = 0, temperatureScale = 1;                  ///< kelvin = (temperature - offset) * scale
    double emissionScale = 1;      ///< of what shines by its temperature, or by the colours of a grid
    ColorGrid colors;              ///< rgbgrid
    double cloudDensity = 1, wispiness = 1, frequency = 5;               ///< cloud

    SourceLocation where;
};

}  // namespace eikonal
