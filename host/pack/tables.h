#pragma once
// A packed scene: every table of include/eikonal/scene.h, and the features that it requires.

#include "bvh/uninitialized.h"
#include "eikonal/scene.h"
#include "feature_set.h"
#include "pack/color_choice.h"
#include "pack/scene_constants.h"
#include "scene/integrator.h"

#include <glm/glm.hpp>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace eikonal {

// Groups of the tables of include/eikonal/scene.h, by the part of packing that writes them.
#define TABLE_VECTOR(type, name) Table<type> name;
struct GeometryTables { GEOMETRY_TABLES(TABLE_VECTOR) VERTEX_TABLES(TABLE_VECTOR) };
struct TextureTables { PROGRAM_TABLES(TABLE_VECTOR) };
struct MaterialTables { MATERIAL_TABLES(TABLE_VECTOR) };
struct LightTables { LIGHT_TABLES(TABLE_VECTOR) EMISSION_TABLES(TABLE_VECTOR) };
struct BsdfTables { BSDF_TABLES(TABLE_VECTOR) };
struct MediumTables { MEDIUM_TABLES(TABLE_VECTOR) };
struct ColorTables { COLOR_TABLES(TABLE_VECTOR) };
struct CameraTables { CAMERA_TABLES(TABLE_VECTOR) };
struct MatteTables { MATTE_TABLES(TABLE_VECTOR) };
#undef TABLE_VECTOR

/// A table of elements for each of SCENE_TABLES, of its name.
struct SceneTables : GeometryTables, TextureTables, MaterialTables, LightTables, BsdfTables, MediumTables, ColorTables, CameraTables,
                     MatteTables {
    Table<settings> frame;

    /// Bytes of all tables.
    size_t bytes() const {
        size_t sum = 0;
#define TABLE_BYTES(type, name) sum += name.size() * sizeof(type);
        SCENE_TABLES(TABLE_BYTES)
#undef TABLE_BYTES
        return sum;
    }
};

/// A rectangle of pixels: x0 <= x < x1, y0 <= y < y1, rows counted from the top of the whole image.
struct PixelRect {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }
};

/// Statistics of a scene, for reports.
struct SceneCounts {
    size_t triangles = 0, patches = 0, quadrics = 0, curves = 0, implicits = 0, objects = 0, instances = 0, lights = 0, materials = 0,
           textures = 0, images = 0, media = 0;
    double loadSeconds = 0, buildSeconds = 0;
    int bvhDepth = 0;
};

/// The features that a scene requires.
struct RequiredFeatures {
    Features features;
    std::map<Feature, std::string> reasons;  ///< the first thing that asked for each feature: "scene.pbrt:12:1: material \"glass\""

    /// Notes that `why` asks for a feature.
    void require(Feature feature, const std::string& why) {
        features.require(feature);
        reasons.emplace(feature, why);
    }
};

/// A packed scene.
struct PackedScene : RequiredFeatures {
    SceneTables tables;
    SceneConstants constants;
    std::vector<std::string> lightGroups{"default"};   ///< names, by light::group; constants.lightGroups: how many are kept
    std::vector<int> materialSources;        ///< by index in `materials`: of which scene material; none: of no other than pbrt's default
    std::string objectManifest, materialManifest;   ///< of the layers of Cryptomatte; empty: not required
    PixelRect pixels;                        ///< the pixels to render, of width x height (settings)
    int samples = 16;                        ///< per pixel
    bool isGuideOptional = false;            ///< with PATH_GUIDE: do without it where it does not pay
    bool isAlwaysGuided = false;             ///< with ENVIRONMENT_GUIDE: use the guide even in open scenes
    ColorChoice color;                       ///< RGB or wavelengths, and why
    std::optional<Roulette> roulette;        ///< unset: chosen by pilot paths; until then the settings have the default
    double worldScale = 1;                   ///< world units in one unit of scene space
    glm::dvec3 worldCenter{0};               ///< the origin of scene space, world space
    std::array<glm::dmat4, 3> cameraFromScene{glm::dmat4(1), glm::dmat4(1),
                                              glm::dmat4(1)};  ///< when the shutter opens, in the middle, and when it closes
    double cameraUnit = 1;                   ///< camera space units in one unit of the device's camera space
    SceneCounts counts;

    const settings& frame() const { return tables.frame.front(); }
    settings& frame() { return tables.frame.front(); }
    /// The camera paths of a whole render.
    double paths() const { return static_cast<double>(frame().width) * frame().height * samples; }
};

}  // namespace eikonal
