// A medium whose density, and perhaps temperature or emission, are given on a regular grid (kernels/medium/uniformgrid.clh).

#include "kinds/medium_packing.h"
#include "kinds/medium_reading.h"

namespace eikonal {

static bool read(const pbrt::MediumReading& in, Medium& medium) {
    const pbrt::Arguments& arguments = in.arguments;
    readCoefficients(arguments, medium);
    medium.density = readGrid(arguments, "density");
    if (medium.density.values.empty()) throw SceneError(arguments.where(), "medium \"uniformgrid\" needs \"float density\"");
    medium.temperature = readGrid(arguments, "temperature");
    if (arguments.has("Le") && arguments.has("temperature"))
        throw SceneError(arguments.whereOf("Le"), "the medium has both \"Le\" and \"temperature\"; give one of them");
    /* If it is not given, pbrt-v4 uses a grid of a single 1, which falls off towards the sides */
    medium.LeScale = readGrid(arguments, "Lescale");
    if (medium.LeScale.values.empty()) medium.LeScale = {1, 1, 1, {1}};
    readBox(arguments, medium);
    pbrt::scaleCoefficients(medium, arguments.number("scale"));
    medium.Le = arguments.spectrum("Le");
    readTemperature(arguments, medium);
    return true;
}

static medium pack(const MediumPacking& in, const Medium& d) {
    MediumTables& tables = in.tables;
    medium m = newMedium(in, d);
    packBox(in, d, d.p0, d.p1, m);
    const glm::dmat4 voxelsFromBox = voxelFromBox(d.density.nx, d.density.ny, d.density.nz);
    m.density = packGrid(tables, d.density, voxelsFromBox);
    if (!d.LeScale.values.empty()) m.Le_scale = packGrid(tables, d.LeScale, voxelFromBox(d.LeScale.nx, d.LeScale.ny, d.LeScale.nz));
    if (!d.temperature.values.empty()) {
        m.temperature = packGrid(tables, d.temperature, voxelsFromBox);
        packBlackbodyEmission(in, d, m);
    }
    packDensityCells(tables, m, {d.density.nx, d.density.ny, d.density.nz});
    return m;
}

static MediumEmission emission(const Medium& d) {
    if (!d.temperature.values.empty()) return MediumEmission::blackbody;
    return d.Le.illuminant() != glm::dvec3(0) ? MediumEmission::spectrum : MediumEmission::none;
}

const MediumTraits uniformgrid_medium{
    .parameters = {pbrt::phaseParameters, pbrt::coefficientParameters, pbrt::boxParameters, pbrt::gridParameters,
                   pbrt::temperatureParameters,
                   "float scale = 1 in [0, inf); spectrum Le = 0; floats Lescale; floats density; floats temperature"},
    .read = read,
    .pack = pack,
    .emission = emission};

}  // namespace eikonal
