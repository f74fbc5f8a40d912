#pragma once
// Shared code for reading media from a pbrt scene.

#include "kinds/medium_kind.h"
#include "read/pbrt/arguments.h"
#include "scene/media.h"

#include <string>
#include <vector>

namespace eikonal::pbrt {

/// The input of a medium's `read`.
struct MediumReading {
    Reading& reading;
    const Arguments& arguments;
};

/* Parts of rows (read/pbrt/kinds.h) that several kinds share */
constexpr const char* phaseParameters = "float g = 0 clamped to [-0.99, 0.99]";
constexpr const char* coefficientParameters = "spectrum sigma_a = 1; spectrum sigma_s = 1";
constexpr const char* boxParameters = "point3 p0; point3 p1";
constexpr const char* gridParameters = "integer nx = 1; integer ny = 1; integer nz = 1";
constexpr const char* temperatureParameters =
    "float temperaturecutoff = 0; float temperatureoffset | temperaturecutoff = 0; float temperaturescale = 1";

/// Reads "sigma_a" and "sigma_s".
void readCoefficients(const Arguments& arguments, Medium& medium);
void scaleCoefficients(Medium& medium, double scale);

/// Reads the corners "p0" and "p1". Throws SceneError if the box has no volume.
void readBox(const Arguments& arguments, Medium& medium);

/// The dimensions of a grid: "nx", "ny" and "nz". Throws SceneError.
glm::ivec3 readSize(const Arguments& arguments);
/// The values of a grid, not negative; empty if the parameter is not given. Throws SceneError.
Grid readGrid(const Arguments& arguments, const std::string& name);
/// The colours of a grid; empty if the parameter is not given. Throws SceneError.
std::vector<glm::vec3> readColors(const Arguments& arguments, const std::string& name);

/// Reads "temperatureoffset" and "temperaturescale".
void readTemperature(const Arguments& arguments, Medium& medium);

}  // namespace eikonal::pbrt
