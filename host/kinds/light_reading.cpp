#include "kinds/light_reading.h"

#include <fmt/format.h>

namespace eikonal::pbrt {

Spectrum whiteOf(const Arguments& arguments) { return Spectrum::rgb({1, 1, 1}, arguments.space()); }

std::optional<double> strengthOf(Reading& reading, const Arguments& arguments, const char* name) {
    const double strength = arguments.number(name);
    if (strength > 0) return strength;
    if (strength != -1)
        reading.diagnostics.warn(arguments.whereOf(name),
                                 fmt::format("\"{}\" {:g} has no effect, as in pbrt-v4: only one above 0 has. For a light that emits "
                                             "nothing, leave it out",
                                             name, strength));
    return {};
}

void readDirection(const Arguments& arguments, Light& light) {
    light.from = arguments.vector("from");
    light.to = arguments.vector("to", {0, 0, 1});
    if (light.from == light.to)
        throw SceneError(
            arguments.has("to") ? arguments.whereOf("to") : arguments.whereOf("from"),
            fmt::format("{}: \"from\" and \"to\" are the same point, ({:g}, {:g}, {:g}); they must differ",
                        arguments.kind().title(), light.to.x, light.to.y, light.to.z));
}

bool readImage(const LightReading& in, image_wrap wrap, Light& light) {
    const Arguments& arguments = in.arguments;
    if (!arguments.has("filename")) throw SceneError(arguments.where(), arguments.kind().title() + " needs an image: \"string filename\"");
    const std::optional<std::string> path = arguments.file("filename", "the light is left out");
    if (!path) return false;
    ImageFile file{*path};
    file.wrap = wrap;
    file.where = arguments.whereOf("filename");
    light.image = in.textures.image(file);
    return true;
}

}  // namespace eikonal::pbrt
