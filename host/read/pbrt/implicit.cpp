#include "read/pbrt/implicit.h"

#include "read/formats/expression.h"

namespace eikonal::pbrt {

ImplicitSurface readImplicit(const Arguments& arguments) {
    const std::string title = arguments.kind().title();
    if (!arguments.has("F")) throw SceneError(arguments.where(), title + " needs its function, as in \"string F\" \"x^2 + y^2 + z^2 - 1\"");
    std::map<std::string, double> constants;
    for (const char* name : {"a", "b", "c", "d"})
        if (arguments.has(name)) constants[name] = arguments.number(name);
    ImplicitSurface surface;
    const std::string text = arguments.text("F");
    surface.F = std::make_shared<const Expression>(readExpression(text, arguments.given("F")->whereText, constants));

    const std::vector<glm::vec3> corners = arguments.vectors3("bounds");
    if (corners.size() != 2)
        throw SceneError(arguments.whereOf("bounds"), title + " needs a box that bounds it, given by two corners, as in \"point3 bounds\" [-1 -1 -1  1 1 1]");
    surface.low = glm::min(corners[0], corners[1]);
    surface.high = glm::max(corners[0], corners[1]);
    for (int c = 0; c < 3; ++c)
        if (!(surface.low[c] < surface.high[c])) throw SceneError(arguments.whereOf("bounds"), "\"point3 bounds\" is a box without volume: both corners have the same " + std::string(1, "xyz"[c]));
    return surface;
}

}  // namespace eikonal::pbrt
