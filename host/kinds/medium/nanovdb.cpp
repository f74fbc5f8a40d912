// A medium whose density, and perhaps temperature, come from a sparse grid of a NanoVDB file (kernels/medium/nanovdb.clh).

#include "kinds/medium_packing.h"
#include "kinds/medium_reading.h"
#include "read/formats/nanovdb.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace eikonal {

static void readGrids(const pbrt::Arguments& arguments, const std::string& path, Medium& medium) {
    const auto expectGrid = [&](bool isThere, const char* parameter) {
        if (isThere) return;
        throw SceneError(arguments.whereOf(parameter), fmt::format("{} has no grid \"{}\"; it has \"{}\"", path, arguments.text(parameter),
                                                                   fmt::join(gridNames(path), "\", \"")));
    };
    try {
        medium.sparseDensity = readNanoVdb(path, arguments.text("gridname"));
        medium.sparseTemperature = readNanoVdb(path, arguments.text("temperaturename"));
        expectGrid(medium.sparseDensity != nullptr, "gridname");
        expectGrid(medium.sparseTemperature || !arguments.has("temperaturename"), "temperaturename");
    } catch (const ReadProblem& problem) {
        throw SceneError(arguments.whereOf("filename"), path + " " + problem.what());
    }
}

static bool read(const pbrt::MediumReading& in, Medium& medium) {
    const pbrt::Arguments& arguments = in.arguments;
    readCoefficients(arguments, medium);
    pbrt::scaleCoefficients(medium, arguments.number("scale"));
    if (!arguments.has("filename")) throw SceneError(arguments.where(), "medium \"nanovdb\" needs a \"string filename\"");
    const std::optional<std::string> path = arguments.file("filename", "the medium is left out");
    if (!path) return false;
    readGrids(arguments, *path, medium);
    medium.emissionScale = arguments.number("Lescale");
    readTemperature(arguments, medium);
    return true;
}

/// The box of a grid's voxels in medium space, from the first voxel to one past the last.
static Box boxOf(const SparseGrid& grid) {
    const glm::dmat4 mediumFromVoxel = glm::inverse(grid.voxelFromMedium);
    Box box;
    for (int corner = 0; corner < 8; ++corner)
        box.grow(transformPoint(mediumFromVoxel, {corner & 1 ? grid.high.x + 1. : grid.low.x, corner & 2 ? grid.high.y + 1. : grid.low.y,
                                                  corner & 4 ? grid.high.z + 1. : grid.low.z}));
    return box;
}

static medium pack(const MediumPacking& in, const Medium& d) {
    MediumTables& tables = in.tables;
    const SparseGrid &density = *d.sparseDensity, *temperature = d.sparseTemperature.get();
    medium m = newMedium(in, d);
    Box box = boxOf(density);
    if (temperature) box.grow(boxOf(*temperature));
    const glm::dmat4 mediumFromBox = packBox(in, d, box.low, box.high, m), voxelFromBox = density.voxelFromMedium * mediumFromBox;

    m.density = packGrid(tables, density, voxelFromBox);
    if (temperature) {
        m.temperature = packGrid(tables, *temperature, temperature->voxelFromMedium * mediumFromBox);
        packBlackbodyEmission(in, d, m);
    }
    packDensityCells(tables, m, {glm::length(voxelFromBox[0]), glm::length(voxelFromBox[1]), glm::length(voxelFromBox[2])});
    return m;
}

static MediumEmission emission(const Medium& d) { return d.sparseTemperature ? MediumEmission::blackbody : MediumEmission::none; }

const MediumTraits nanovdb_medium{
    .parameters = {pbrt::phaseParameters, pbrt::coefficientParameters, pbrt::temperatureParameters,
                   "file filename; string gridname = density; string temperaturename = temperature;"
                   "float Lescale = 1 in [0, inf); float scale = 1 in [0, inf)"},
    .read = read, .pack = pack, .emission = emission};

}  // namespace eikonal
