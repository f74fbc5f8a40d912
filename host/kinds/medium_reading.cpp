#include "kinds/medium_reading.h"

#include <fmt/format.h>

#include <algorithm>

namespace eikonal::pbrt {

void readCoefficients(const Arguments& arguments, Medium& medium) {
    medium.sigmaA = arguments.spectrum("sigma_a");
    medium.sigmaS = arguments.spectrum("sigma_s");
}

void scaleCoefficients(Medium& medium, double scale) {
    medium.sigmaA = medium.sigmaA * scale;
    medium.sigmaS = medium.sigmaS * scale;
}

void readBox(const Arguments& arguments, Medium& medium) {
    medium.p0 = arguments.vector("p0", glm::dvec3(0));
    medium.p1 = arguments.vector("p1", glm::dvec3(1));
    const glm::dvec3 low = glm::min(medium.p0, medium.p1);
    medium.p1 = glm::max(medium.p0, medium.p1);
    medium.p0 = low;
    if (glm::any(glm::equal(medium.p0, medium.p1))) throw SceneError(arguments.where(), "the medium's box from \"p0\" to \"p1\" is flat");
}

glm::ivec3 readSize(const Arguments& arguments) {
    const glm::ivec3 size(arguments.integer("nx"), arguments.integer("ny"), arguments.integer("nz"));
    if (size.x < 1 || size.y < 1 || size.z < 1) throw SceneError(arguments.where(), "the grid's nx, ny and nz must be at least 1");
    return size;
}

/// Throws SceneError unless there is one value per grid cell.
static void checkCount(const Arguments& arguments, const std::string& name, size_t count, glm::ivec3 size, const char* type) {
    const double expected = double(size.x) * size.y * size.z;
    if (static_cast<double>(count) != expected)
        throw SceneError(arguments.whereOf(name), fmt::format("\"{} {}\" has {} values; nx * ny * nz = {} * {} * {} = {:.0f} are expected",
                                                              type, name, count, size.x, size.y, size.z, expected));
}

Grid readGrid(const Arguments& arguments, const std::string& name) {
    const glm::ivec3 size = readSize(arguments);
    const std::vector<double> values = arguments.numbers(name);
    if (!values.empty()) checkCount(arguments, name, values.size(), size, "float");
    const auto below = std::ranges::find_if(values, [](double value) { return value < 0; });
    if (below != values.end())
        throw SceneError(arguments.whereOf(name), fmt::format("\"float {}\" has a value below 0: {:g}", name, *below));
    return {size.x, size.y, size.z, {values.begin(), values.end()}};
}

std::vector<glm::vec3> readColors(const Arguments& arguments, const std::string& name) {
    std::vector<glm::vec3> colors = arguments.colors(name);
    if (!colors.empty()) checkCount(arguments, name, colors.size(), readSize(arguments), "rgb");
    return colors;
}

void readTemperature(const Arguments& arguments, Medium& medium) {
    medium.temperatureOffset = arguments.number("temperatureoffset");
    medium.temperatureScale = arguments.number("temperaturescale");
}

}  // namespace eikonal::pbrt
