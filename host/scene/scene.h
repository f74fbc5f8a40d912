#pragma once
// A scene as it was described, before it is packed for a device: what the pbrt and OBJ readers produce and
// host/pack turns into tables. Plain data; indices instead of pointers; -1 means "none".
// Positions and lengths are in world units, angles in degrees as the file gives them, matrices column-major (glm).

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

/// How colours are carried: as linear sRGB, or at wavelengths. automatic: at wavelengths where the scene needs them (pack/color_mode.h).
enum class ColorMode { automatic, rgb, spectral };

struct Scene {
    std::string name;                    ///< the file's name without folder and extension
    CameraDescription camera;
    FilmDescription film;
    FilterDescription filter;
    SamplerDescription sampler;
    IntegratorDescription integrator;
    ColorMode colorMode = ColorMode::automatic;
    std::vector<Shape> shapes;
    std::vector<Object> objects;
    std::vector<Instance> instances;
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::vector<ImageFile> images;
    std::vector<Medium> media;
    std::vector<Light> lights;
    std::vector<AreaLight> areaLights;
    double motionStart = 0, motionEnd = 1;   ///< between these times everything moves that does; start < end
};

}  // namespace eikonal
