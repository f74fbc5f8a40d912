// Participating media: coefficients per unit of scene space, what varies in them, and bounds on it.

#include "kinds/light_kind.h"
#include "pack/grids.h"
#include "pack/packer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace eikonal {
namespace {

/// One bound for so many voxels along a side, and no more bounds than that; slabs of a cloud.
constexpr int majorantVoxels = 4, mostMajorants = 64, cloudMajorants = 32;

Feature featureOf(MediumKind kind) {
    switch (kind) {
        case MediumKind::homogeneous: return Feature::MEDIUM_HOMOGENEOUS;
        case MediumKind::uniformGrid: return Feature::MEDIUM_UNIFORMGRID;
        case MediumKind::rgbGrid: return Feature::MEDIUM_RGBGRID;
        case MediumKind::cloud: return Feature::MEDIUM_CLOUD;
        default: return Feature::MEDIUM_NANOVDB;
    }
}
medium_kind deviceKind(MediumKind kind) {
    switch (kind) {
        case MediumKind::homogeneous: return kind_homogeneous_medium;
        case MediumKind::uniformGrid: return kind_uniformgrid_medium;
        case MediumKind::rgbGrid: return kind_rgbgrid_medium;
        case MediumKind::cloud: return kind_cloud_medium;
        default: return kind_nanovdb_medium;
    }
}

/// From the unit cube to the box of corners p0 and p1.
glm::dmat4 boxToCorners(glm::dvec3 p0, glm::dvec3 p1) {
    glm::dmat4 m(1);
    for (int axis = 0; axis < 3; ++axis) m[axis][axis] = p1[axis] - p0[axis];
    m[3] = glm::dvec4(p0, 1);
    return m;
}

/// The grid of bounds: as many cells as given, of which `bound` knows a part of the unit cube each.
template <class Bound> void packMajorants(SceneTables& tables, medium& m, glm::ivec3 cells, const Bound& bound) {
    m.majorants_x = static_cast<uint>(cells.x);
    m.majorants_y = static_cast<uint>(cells.y);
    m.majorants_z = static_cast<uint>(cells.z);
    m.first_majorant = static_cast<uint>(tables.majorants.size());
    const glm::dvec3 size(cells);
    for (int z = 0; z < cells.z; ++z)
        for (int y = 0; y < cells.y; ++y)
            for (int x = 0; x < cells.x; ++x) tables.majorants.push_back(bound(glm::dvec3(x, y, z) / size, glm::dvec3(x + 1, y + 1, z + 1) / size));
}

/// Cells of bounds for a grid of so many voxels.
glm::ivec3 majorantCells(glm::dvec3 voxels) { return glm::ivec3(glm::clamp(glm::ceil(voxels / double(majorantVoxels)), glm::dvec3(1), glm::dvec3(mostMajorants))); }

void packBlackbodies(SceneTables& tables) {
    if (!tables.blackbodies.empty()) return;
    for (int i = 0; i <= BLACKBODY_STEPS; ++i) {
        const double kelvin = BLACKBODY_COLDEST * std::pow(double(BLACKBODY_HOTTEST) / BLACKBODY_COLDEST, double(i) / BLACKBODY_STEPS);
        const glm::dvec3 xyz = integrateXyz(Spectrum::blackbody(kelvin).dense());
        const vec3 rgb = toVec3(rgbFromXyz(ColorSpace::srgb) * (xyz / xyz.y));
        tables.blackbodies.push_back({static_cast<float>(std::log(xyz.y)), rgb.x, rgb.y, rgb.z});
    }
}

void packUniformGrid(SceneTables& tables, medium& m, const Medium& description) {
    const Grid& density = description.density;
    const glm::dmat4 toVoxels = voxelFromBox(density.nx, density.ny, density.nz);
    m.density = packGrid(tables, density, toVoxels);
    if (!description.LeScale.values.empty()) m.Le_scale = packGrid(tables, description.LeScale, voxelFromBox(description.LeScale.nx, description.LeScale.ny, description.LeScale.nz));
    if (!description.temperature.values.empty()) m.temperature = packGrid(tables, description.temperature, toVoxels);
    packMajorants(tables, m, majorantCells({density.nx, density.ny, density.nz}), [&](glm::dvec3 low, glm::dvec3 high) { return boundOn(tables, m.density, low, high); });
}

uint packColors(Packer& packer, const std::vector<glm::vec3>& colors, const ColorGrid& grid, bool emitted) {
    Table<color>& table = packer.packed.tables.medium_colors;
    if (colors.empty()) return NONE;
    const uint first = static_cast<uint>(table.size());
    for (const glm::vec3& rgb : colors) {
        const Spectrum spectrum = Spectrum::rgb(rgb, grid.space);
        table.push_back(emitted ? packEmission(packer, spectrum) : packCoefficient(packer, spectrum));
    }
    return first;
}

void packColorGrid(Packer& packer, medium& m, const Medium& description) {
    SceneTables& tables = packer.packed.tables;
    const ColorGrid& grid = description.colors;
    m.nx = static_cast<uint>(grid.nx);
    m.ny = static_cast<uint>(grid.ny);
    m.nz = static_cast<uint>(grid.nz);
    m.first_sigma_a = packColors(packer, grid.sigmaA, grid, false);
    m.first_sigma_s = packColors(packer, grid.sigmaS, grid, false);
    m.first_Le = packColors(packer, grid.Le, grid, true);

    /* Bounds are those of a grid of the greatest component of sigma_t */
    Grid greatest{grid.nx, grid.ny, grid.nz, std::vector<float>(size_t(grid.nx) * grid.ny * grid.nz)};
    for (size_t i = 0; i < greatest.values.size(); ++i) {
        const color* a = m.first_sigma_a == NONE ? nullptr : &tables.medium_colors[m.first_sigma_a + i];
        const color* s = m.first_sigma_s == NONE ? nullptr : &tables.medium_colors[m.first_sigma_s + i];
        greatest.values[i] = greatestSum(packer, a, s);
    }
    const float everywhere = m.first_sigma_a == NONE || m.first_sigma_s == NONE ? 1.f : 0.f;   // what is not given is 1
    SceneTables scratch;
    const uint packed = packGrid(scratch, greatest, voxelFromBox(grid.nx, grid.ny, grid.nz));
    packMajorants(tables, m, majorantCells({grid.nx, grid.ny, grid.nz}), [&](glm::dvec3 low, glm::dvec3 high) { return everywhere + boundOn(scratch, packed, low, high); });
}

/// Above y = 1/2 density is at most (1 - y) 4.5 density |noise|, and five octaves of noise sum up to less than 1.01.
void packCloud(SceneTables& tables, medium& m, const Medium& description) {
    m.low = toVec3(description.p0);
    m.extent = toVec3(description.p1 - description.p0);
    m.cloud_density = static_cast<float>(description.cloudDensity);
    m.wispiness = static_cast<float>(description.wispiness);
    m.frequency = static_cast<float>(description.frequency);
    packMajorants(tables, m, {1, cloudMajorants, 1}, [&](glm::dvec3 low, glm::dvec3 high) {
        const double a = description.p0.y + low.y * m.extent.y, b = description.p0.y + high.y * m.extent.y;
        const double cloud = std::max(std::abs(1 - a), std::abs(1 - b)) * 4.5 * std::abs(description.cloudDensity) * 1.01, mist = 2 * std::max(0.5 - std::min(a, b), 0.);
        return static_cast<float>(std::min(cloud + mist, 1.));
    });
}

/// The box of a grid's voxels in the medium's space: from the first voxel to one behind the last.
Box boxOf(const SparseGrid& grid) {
    const glm::dmat4 mediumFromVoxel = glm::inverse(grid.voxelFromMedium);
    Box box;
    for (int corner = 0; corner < 8; ++corner)
        box.grow(transformPoint(mediumFromVoxel, {corner & 1 ? grid.high.x + 1. : grid.low.x, corner & 2 ? grid.high.y + 1. : grid.low.y, corner & 4 ? grid.high.z + 1. : grid.low.z}));
    return box;
}

void packSparse(SceneTables& tables, medium& m, const SparseGrid& density, const SparseGrid* temperature, const glm::dmat4& mediumFromBox) {
    m.density = packGrid(tables, density, density.voxelFromMedium * mediumFromBox);
    if (temperature) m.temperature = packGrid(tables, *temperature, temperature->voxelFromMedium * mediumFromBox);
    const glm::dmat4 voxelFromBox = density.voxelFromMedium * mediumFromBox;
    const glm::dvec3 voxels(glm::length(voxelFromBox[0]), glm::length(voxelFromBox[1]), glm::length(voxelFromBox[2]));
    packMajorants(tables, m, majorantCells(voxels), [&](glm::dvec3 low, glm::dvec3 high) { return boundOn(tables, m.density, low, high); });
}

medium packMedium(Packer& packer, const Medium& description) {
    SceneTables& tables = packer.packed.tables;
    medium m{};
    m.kind = deviceKind(description.kind);
    m.sigma_a = packCoefficient(packer, description.sigmaA, 1 / packer.space.scale);
    m.sigma_s = packCoefficient(packer, description.sigmaS, 1 / packer.space.scale);
    m.Le = packEmission(packer, description.Le);
    m.g = static_cast<float>(std::clamp(description.g, -0.99, 0.99));
    m.density = m.temperature = m.Le_scale = m.first_sigma_a = m.first_sigma_s = m.first_Le = m.first_majorant = NONE;
    m.temperature_offset = static_cast<float>(description.temperatureOffset);
    m.temperature_scale = static_cast<float>(description.temperatureScale);
    if (description.kind == MediumKind::homogeneous) return m;

    glm::dmat4 mediumFromBox = boxToCorners(description.p0, description.p1);
    if (description.kind == MediumKind::uniformGrid) packUniformGrid(tables, m, description);
    if (description.kind == MediumKind::rgbGrid) packColorGrid(packer, m, description);
    if (description.kind == MediumKind::cloud) packCloud(tables, m, description);
    if (description.kind == MediumKind::nanovdb) {
        Box box = boxOf(*description.sparseDensity);
        if (description.sparseTemperature) box.grow(boxOf(*description.sparseTemperature));
        mediumFromBox = boxToCorners(box.low, box.high);
        packSparse(tables, m, *description.sparseDensity, description.sparseTemperature.get(), mediumFromBox);
    }
    if (m.temperature != NONE) packBlackbodies(tables);
    if (m.temperature != NONE || m.first_Le != NONE) m.Le = packConstant(packer, description.emissionScale);
    m.box_from_scene = toAffine(glm::inverse(description.worldFromMedium * mediumFromBox) * packer.space.worldFromScene());
    return m;
}

}  // namespace

void packMedia(Packer& packer) {
    if (!packer.hasMedia) return;
    for (const Medium& description : packer.scene.media) {
        const std::string what = description.where.toString() + ": medium \"" + description.name + "\"";
        packer.packed.require(featureOf(description.kind), what);
        packer.packed.require(Feature::MEDIA, what);
        packer.packed.tables.media.push_back(packMedium(packer, description));
    }
}

uint packInterior(Packer& packer, const std::shared_ptr<const Medium>& interior, const std::string& why) {
    Table<medium>& media = packer.packed.tables.media;
    const auto [place, isNew] = packer.interiors.try_emplace(interior.get(), static_cast<uint>(media.size()));
    if (isNew) {
        for (Feature feature : {Feature::SUBSURFACE, Feature::MEDIA, Feature::MEDIUM_HOMOGENEOUS}) packer.packed.require(feature, why);
        media.push_back(packMedium(packer, *interior));
    }
    return place->second;
}

void packEquiangularLights(Packer& packer) {
    SceneTables& tables = packer.packed.tables;
    std::vector<std::pair<float, vec3>> points;
    for (const light& l : tables.lights)
        if (kindOf(l).place == LightPlace::POINT) points.emplace_back(greatestSum(packer, &l.L, nullptr), l.p);
    std::ranges::stable_sort(points, [](const auto& a, const auto& b) { return a.first > b.first; });
    points.resize(std::min(points.size(), size_t{MOST_EQUIANGULAR_LIGHTS}));
    float sum = 0;
    for (const auto& [intensity, p] : points) sum += intensity;
    if (!(sum > 0)) return;
    /* The media of the scene come first; what fills a body is lit through its surface */
    const size_t open = packer.hasMedia ? packer.scene.media.size() : 0;
    for (medium& m : std::span(tables.media).first(open)) {
        if (m.kind != kind_homogeneous_medium || greatestSum(packer, &m.sigma_s, nullptr) <= 0) continue;
        m.equiangular_lights = static_cast<uint>(points.size());
        packer.packed.require(Feature::EQUIANGULAR, "the scene has a light that is a point, and a medium that scatters");
    }
    if (!packer.packed.features.has(Feature::EQUIANGULAR)) return;
    for (const auto& [intensity, p] : points) tables.point_lights.push_back({p, intensity / sum});
}

}  // namespace eikonal
