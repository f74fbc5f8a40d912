#include "pack/pack.h"

#include "kinds/shape_kind.h"
#include "pack/color_mode.h"
#include "pack/motion.h"
#include "pack/packer.h"

#include <algorithm>
#include <bit>
#include <chrono>

namespace eikonal {

/// Whether anything in the scene can be inside a medium: the camera, or a shape that names one.
static bool mediaAreUsed(const Scene& scene) {
    if (scene.camera.medium != none) return true;
    const auto names = [](const Shape& s) { return s.interface && (s.interface->inside != none || s.interface->outside != none); };
    if (std::any_of(scene.shapes.begin(), scene.shapes.end(), names)) return true;
    return std::any_of(scene.objects.begin(), scene.objects.end(),
                       [&](const Object& o) { return std::any_of(o.shapes.begin(), o.shapes.end(), names); });
}

/// What a box reaches that stands still, or moves.
static Box reachOf(const Box& box, const glm::dmat4& start, const std::optional<glm::dmat4>& end, TimeSpan seen) {
    return end ? boundsInMotion({Motion(start, *end)}, box, seen) : transformed(box, start);
}
static Box reachOf(const Shape& s, TimeSpan seen) {
    const auto bound = s.kind->traits.bound;
    if (!s.worldFromObjectAtEnd) return bound(s, s.worldFromObject);
    return reachOf(bound(s, glm::dmat4(1)), s.worldFromObject, s.worldFromObjectAtEnd, seen);
}

static Box worldBounds(const Scene& scene) {
    const TimeSpan seen = timesSeen(scene);
    Box box;
    for (const Shape& s : scene.shapes) box.grow(reachOf(s, seen));
    std::vector<Box> objects;
    for (const Object& o : scene.objects) {
        Box b;
        for (const Shape& s : o.shapes) b.grow(reachOf(s, seen));
        objects.push_back(b);
    }
    for (const Instance& i : scene.instances) box.grow(reachOf(objects[static_cast<size_t>(i.object)], i.worldFromObject, i.worldFromObjectAtEnd, seen));
    return box;
}

PackedTextures packTextures(const Scene& scene, std::span<const int> textures, Diagnostics& diagnostics) {
    PackedTextures result;
    Packer packer{scene, diagnostics, result.scene, {}, {}};
    packer.images = loadImages(scene.images);
    result.scene.tables.frame.emplace_back();
    for (const int texture : textures) result.programs.push_back(packTexture(packer, texture));
    return result;
}

Packing packTables(const Scene& scene, Diagnostics& diagnostics) {
    const auto start = std::chrono::steady_clock::now();
    Packing result;
    PackedScene& packed = result.scene;
    Packer packer{scene, diagnostics, packed, {}, worldBounds(scene)};
    packer.space = spaceOf(packer.bounds);
    const bool wouldUseMedia = mediaAreUsed(scene);
    packer.hasMedia = wouldUseMedia && countsMedia(scene.integrator);
    packer.images = loadImages(scene.images);
    packed.worldScale = 1 / packer.space.scale;
    packed.worldCenter = packer.space.center;

    packed.tables.frame.emplace_back();
    const std::string need = scene.colorMode == ColorMode::automatic ? needOfWavelengths(scene) : "--color";
    packer.spectral = scene.colorMode != ColorMode::rgb && !need.empty();
    if (packer.spectral) {
        packed.require(Feature::SPECTRAL, need);
        packSensor(packer);
        packSpectrumKept(packer);
    } else if (scene.film.spectrum)
        throw SceneError(scene.film.where, "film \"spectral\" keeps light wavelength by wavelength, and --color rgb has no wavelengths; --color spectral and --color auto have them");
    packIntegrator(packer, wouldUseMedia && !packer.hasMedia);
    packCamera(packer);
    packMedia(packer);
    packMaterials(packer);
    result.hierarchies = packGeometry(packer);
    packLights(packer);
    packEquiangularLights(packer);

    settings& frame = packed.frame();
    frame.seed = static_cast<uint>(scene.sampler.seed);
    if (scene.sampler.kind == SamplerKind::zsobol) {
        /* The indices of a tile's samples fit in 32 bits */
        frame.sequence_sample_bits = static_cast<uint>(std::bit_width(static_cast<uint>(std::max(scene.sampler.pixelSamples, 1)) - 1));
        frame.sequence_tile_bits = std::min(8u, (32 - frame.sequence_sample_bits) / 2);
    }
    frame.light_count = static_cast<uint>(packed.tables.light_aliases.size());
    frame.world_scale = static_cast<float>(packed.worldScale);
    /* At wavelengths, samples are what the film makes of light; in RGB they are light, which is exposed in the end */
    frame.max_component_value = static_cast<float>(scene.film.maxComponentValue / (packer.spectral ? 1 : scene.film.exposureTime * scene.film.iso / 100));
    packed.constants.environments = static_cast<int>(packed.tables.environments.size());
    packed.samples = scene.sampler.pixelSamples;
    if (scene.sampler.kind != SamplerKind::independent) packed.require(Feature::SOBOL, scene.sampler.where.toString());
    if (scene.sampler.kind == SamplerKind::sobol || scene.sampler.kind == SamplerKind::zsobol) packed.require(Feature::JOINT_PAIRS, scene.sampler.where.toString());

    SceneCounts& counts = packed.counts;
    counts.objects = scene.objects.size();
    counts.instances = scene.instances.size();
    counts.lights = packed.tables.lights.size();
    counts.materials = packed.tables.materials.size();
    counts.textures = scene.textures.size();
    counts.images = scene.images.size();
    counts.media = packed.tables.media.size();
    counts.loadSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

PackedScene packScene(const Scene& scene, Diagnostics& diagnostics) {
    Packing packing = packTables(scene, diagnostics);
    packing.hierarchies.build(packing.scene, diagnostics);
    return std::move(packing.scene);
}

}  // namespace eikonal
