#pragma once
// What developing a film needs of its scene, as text, so that a film can be developed without the scene.

#include "pack/tables.h"
#include "scene/film.h"

#include <string>

namespace eikonal {

struct StoredScene {
    PackedScene packed;      ///< with the tables of the camera and of wavelengths only
    FilmDescription film;   ///< how its image is stored: gbuffer and halfFloats only
};

/// JSON. Numbers keep all bits; the camera and the settings are those of this build of the program. pixels: of the image that parts make.
std::string toJson(const PackedScene& packed, const PixelRect& pixels, const FilmDescription& film);
/// Throws Error (ExitCode::scene), "name: ...", for a text that toJson did not make.
StoredScene storedScene(const std::string& text, const std::string& name);

}  // namespace eikonal
