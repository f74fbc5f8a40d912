#pragma once
// A scene as described by its file, before it is packed for a device: the pbrt and OBJ readers produce it, and host/pack makes tables of
// it. Plain data: parts refer to one another by index (`none` = -1), to their kind by pointer, and share large data (meshes, curves, grids,
// images) by shared_ptr. Positions and lengths are in world units, angles in degrees as in the file, matrices column-major (glm).

#include "scene/camera.h"
#include "scene/film.h"
#include "scene/integrator.h"
#include "scene/lights.h"
#include "scene/materials.h"
#include "scene/media.h"
#include "scene/shapes.h"
#include "scene/textures.h"

#include <string>
#include <vector>

namespace eikonal {

/// How colours are represented: as linear sRGB, or at sampled wavelengths. automatic: at wavelengths if the scene needs them
/// (pack/color_mode.h).
enum class ColorMode { automatic, rgb, spectral };

struct Scene {
    std::string name;                    ///< the file's name without folder and extension
    CameraDescription camera;
    FilmDescription film;
    FilterDescription filter;
    SamplerDescription sampler;
    IntegratorDescription integrator;
    ColorMode colorMode = ColorMode::automatic;
    bool forcesDiffuse = false;          ///< every surface scatters as a diffuse one that reflects as much does (option "forcediffuse")
    std::vector<Shape> shapes;
    std::vector<Object> objects;
    std::vector<Instance> instances;
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::vector<ImageFile> images;
    std::vector<Medium> media;
    std::vector<Light> lights;
    std::vector<AreaLight> areaLights;
    double motionStart = 0, motionEnd = 1;   ///< everything that moves does so between these times; start < end
};

}  // namespace eikonal
