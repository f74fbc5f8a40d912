#include "kinds/medium_packing.h"

#include "pack/motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace eikonal {

/// Voxels per majorant cell along each axis, and the most cells along an axis.
constexpr int majorantVoxels = 4, mostMajorants = 64;

medium newMedium(const MediumPacking& in, const Medium& description) {
    medium m{};
    m.kind = description.kind->value;
    m.sigma_a = in.colors.coefficient(description.sigmaA, 1 / in.context.space.scale);
    /* Nearly forward scattering counts as less of a wider kind (the similarity relation, van de Hulst 1980): its density would overflow */
    constexpr double mostForward = 0.99;
    const double similar = description.g > mostForward ? (1 - description.g) / (1 - mostForward) : 1;
    m.sigma_s = in.colors.coefficient(description.sigmaS, similar / in.context.space.scale);
    m.Le = in.colors.emission(description.Le);
    const auto check = [&](const color& packed, const char* parameter) {
        in.colors.checkRange(packed, description.where, fmt::format("\"{}\" of medium \"{}\"", parameter, description.name));
    };
    check(m.sigma_a, "sigma_a");
    check(m.sigma_s, "sigma_s");
    check(m.Le, "Le");
    m.scatters = in.colors.greatestSum(&m.sigma_s, nullptr) > 0;
    m.g = static_cast<float>(std::clamp(description.g, -mostForward, mostForward));
    m.density = m.temperature = m.Le_scale = m.first_sigma_a = m.first_sigma_s = m.first_Le = m.first_majorant = m.motion = NONE;
    return m;
}

glm::dmat4 packBox(const MediumPacking& in, const Medium& description, glm::dvec3 p0, glm::dvec3 p1, medium& m) {
    glm::dmat4 mediumFromBox(1);
    for (int axis = 0; axis < 3; ++axis) mediumFromBox[axis][axis] = p1[axis] - p0[axis];
    mediumFromBox[3] = glm::dvec4(p0, 1);
    if (description.worldFromMediumAtEnd) {
        for (Feature feature : {Feature::MOTION, Feature::MEDIUM_MOTION}) in.context.require(feature, description.where.toString());
        m.motion = static_cast<uint>(in.tables.medium_motions.size());
        const Motion motion(description.worldFromMedium, *description.worldFromMediumAtEnd);
        in.tables.medium_motions.push_back(motion.pack(in.context.space, {}));
        m.box_from_scene = toAffine(glm::inverse(mediumFromBox));
    } else
        m.box_from_scene = toAffine(glm::inverse(description.worldFromMedium * mediumFromBox) * in.context.space.worldFromScene());
    return mediumFromBox;
}

glm::ivec3 majorantCells(glm::dvec3 voxels) {
    return glm::ivec3(glm::clamp(glm::ceil(voxels / double(majorantVoxels)), glm::dvec3(1), glm::dvec3(mostMajorants)));
}

void packDensityCells(MediumTables& tables, medium& m, glm::dvec3 voxels) {
    m.cells_from_box = tables.grids[m.density].cell_from_box;
    m.has_cells = 1;
    packMajorants(tables, m, majorantCells(voxels), [&](glm::dvec3 low, glm::dvec3 high) { return boundOn(tables, m.density, low, high); });
}

static void packBlackbodyColors(MediumTables& tables) {
    if (!tables.blackbodies.empty()) return;
    for (int i = 0; i <= BLACKBODY_STEPS; ++i) {
        const double kelvin = BLACKBODY_COLDEST * std::pow(double(BLACKBODY_HOTTEST) / BLACKBODY_COLDEST, double(i) / BLACKBODY_STEPS);
        const glm::dvec3 xyz = integrateXyz(Spectrum::blackbody(kelvin).dense());
        const vec3 rgb = toVec3(rgbFromXyz(ColorSpace::srgb) * (xyz / xyz.y));
        tables.blackbodies.push_back({static_cast<float>(std::log(xyz.y)), rgb.x, rgb.y, rgb.z});
    }
}

void packBlackbodyEmission(const MediumPacking& in, const Medium& description, medium& m) {
    packBlackbodyColors(in.tables);
    m.temperature_offset = static_cast<float>(description.temperatureOffset);
    m.temperature_scale = static_cast<float>(description.temperatureScale);
    m.Le = in.colors.constant(description.emissionScale);
}

}  // namespace eikonal
