// A medium whose coefficients and emission are colours on a regular grid (kernels/medium/rgbgrid.clh).

#include "kinds/medium_packing.h"
#include "kinds/medium_reading.h"

#include <algorithm>

namespace eikonal {

static bool read(const pbrt::MediumReading& in, Medium& medium) {
    const pbrt::Arguments& arguments = in.arguments;
    const glm::ivec3 size = readSize(arguments);
    medium.colors = {
        size.x,           size.y, size.z, readColors(arguments, "sigma_a"), readColors(arguments, "sigma_s"), readColors(arguments, "Le"),
        arguments.space()};
    if (medium.colors.sigmaA.empty() && medium.colors.sigmaS.empty())
        throw SceneError(arguments.where(), "medium \"rgbgrid\" needs \"rgb sigma_a\" or \"rgb sigma_s\"");
    if (!medium.colors.Le.empty() && medium.colors.sigmaA.empty())
        throw SceneError(arguments.whereOf("Le"), "an emitting medium must absorb: \"rgb Le\" needs \"rgb sigma_a\"");
    readBox(arguments, medium);
    medium.sigmaA = medium.sigmaS = Spectrum::constant(arguments.number("scale"));
    /* As in pbrt-v4, and unlike the emission of lights, these are not divided by the luminance of white */
    medium.emissionScale = arguments.number("Lescale") * integrateXyz(whiteSpectrum(arguments.space())).y;
    return true;
}

static uint packColors(const MediumPacking& in, const std::vector<glm::vec3>& colors, const ColorGrid& grid, bool emitted) {
    Table<color>& table = in.tables.medium_colors;
    if (colors.empty()) return NONE;
    const uint first = static_cast<uint>(table.size());
    for (const glm::vec3& rgb : colors) {
        const Spectrum spectrum = Spectrum::rgb(rgb, grid.space);
        table.push_back(emitted ? in.colors.emission(spectrum) : in.colors.coefficient(spectrum));
    }
    return first;
}

/// Packs the majorants of the largest component of sigma_t.
static void packColorMajorants(const MediumPacking& in, const ColorGrid& grid, medium& m) {
    MediumTables& tables = in.tables;
    Grid greatest{grid.nx, grid.ny, grid.nz, std::vector<float>(size_t(grid.nx) * grid.ny * grid.nz)};
    for (size_t i = 0; i < greatest.values.size(); ++i) {
        const color* a = m.first_sigma_a == NONE ? nullptr : &tables.medium_colors[m.first_sigma_a + i];
        const color* s = m.first_sigma_s == NONE ? nullptr : &tables.medium_colors[m.first_sigma_s + i];
        greatest.values[i] = in.colors.greatestSum(a, s);
    }
    const float everywhere = m.first_sigma_a == NONE || m.first_sigma_s == NONE ? 1.f : 0.f;   // sigma_a or sigma_s defaults to 1
    MediumTables scratch;
    const uint packed = packGrid(scratch, greatest, voxelFromBox(grid.nx, grid.ny, grid.nz));
    packMajorants(tables, m, majorantCells({grid.nx, grid.ny, grid.nz}),
                  [&](glm::dvec3 low, glm::dvec3 high) { return everywhere + boundOn(scratch, packed, low, high); });
}

static medium pack(const MediumPacking& in, const Medium& d) {
    const ColorGrid& grid = d.colors;
    medium m = newMedium(in, d);
    packBox(in, d, d.p0, d.p1, m);
    m.nx = static_cast<uint>(grid.nx);
    m.ny = static_cast<uint>(grid.ny);
    m.nz = static_cast<uint>(grid.nz);
    m.first_sigma_a = packColors(in, grid.sigmaA, grid, false);
    m.first_sigma_s = packColors(in, grid.sigmaS, grid, false);
    m.first_Le = packColors(in, grid.Le, grid, true);
    if (m.first_Le != NONE) m.Le = in.colors.constant(d.emissionScale);
    m.scatters &= m.first_sigma_s == NONE || std::ranges::any_of(grid.sigmaS, [](const glm::vec3& s) { return s != glm::vec3(0); });
    m.cells_from_box = toAffine(voxelFromBox(grid.nx, grid.ny, grid.nz));
    m.has_cells = 1;
    packColorMajorants(in, grid, m);
    return m;
}

static MediumEmission emission(const Medium& d) { return d.colors.Le.empty() ? MediumEmission::none : MediumEmission::spectrum; }

const MediumTraits rgbgrid_medium{
    .parameters = {pbrt::boxParameters, pbrt::gridParameters,
                   "colors sigma_a; colors sigma_s; colors Le; float Lescale = 1 in [0, inf); float scale = 1 in [0, inf)",
                   pbrt::phaseParameters},
    .read = read, .pack = pack, .emission = emission};

}  // namespace eikonal
