// Participating media, in the scene and inside of bodies; the point lights that ways through them are sampled towards.

#include "kinds/light_kind.h"
#include "kinds/medium_kind.h"
#include "pack/packer.h"

#include <algorithm>
#include <span>

namespace eikonal {

void packMedia(Packer& packer) {
    if (!packer.hasMedia) return;
    for (const Medium& description : packer.scene.media) {
        const std::string what = description.where.toString() + ": medium \"" + description.name + "\"";
        packer.packed.require(description.kind->feature, what);
        packer.packed.require(Feature::MEDIA, what);
        packer.packed.tables.media.push_back(description.kind->traits.pack(packer, description));
    }
}

uint packInterior(Packer& packer, const std::shared_ptr<const Medium>& interior, const std::string& why) {
    Table<medium>& media = packer.packed.tables.media;
    const auto [place, isNew] = packer.interiors.try_emplace(interior.get(), static_cast<uint>(media.size()));
    if (isNew) {
        for (Feature feature : {Feature::SUBSURFACE, Feature::MEDIA, interior->kind->feature}) packer.packed.require(feature, why);
        media.push_back(interior->kind->traits.pack(packer, *interior));
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
        if (kindOf(m).variation != MediumVariation::HOMOGENEOUS || greatestSum(packer, &m.sigma_s, nullptr) <= 0) continue;
        m.equiangular_lights = static_cast<uint>(points.size());
        packer.packed.require(Feature::EQUIANGULAR, "the scene has a light that is a point, and a medium that scatters");
    }
    if (!packer.packed.features.has(Feature::EQUIANGULAR)) return;
    for (const auto& [intensity, p] : points) tables.point_lights.push_back({p, intensity / sum});
}

}  // namespace eikonal
