#include "read/pbrt/lights.h"

#include "kinds/light_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace eikonal::pbrt {

/// The name of a light group is part of names of channels. Empty: the default group. Throws SceneError.
static std::string lightGroup(const Arguments& arguments) {
    const std::string name = arguments.text("lightgroup");
    if (std::ranges::all_of(name, [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; })) return name;
    throw SceneError(arguments.whereOf("lightgroup"),
                     fmt::format("the light group \"{}\" is part of the name of a layer, so it has letters, digits, _ and - only", name));
}

const KindTable& lightKinds() {
    static const KindTable table = [] {
        std::vector<Row> rows;
        for (const LightKind& e : lightKindList())
            if (e.traits.directive) rows.push_back({e.traits.directive, e.value, e.traits.parameters});
        return KindTable("light", "float scale = 1 in [0, inf); string lightgroup", rows);
    }();
    return table;
}

const KindTable& areaLightKinds() {
    static const KindTable table("area light", "", {
        {"diffuse", 0, "spectrum L; float scale = 1 in [0, inf); float power = -1; bool twosided = false; file filename; "
                       "string lightgroup"},
    });
    return table;
}

void addLight(Reading& reading, TextureRegistry& textures, const std::string& kindName, const GraphicsState& state,
              ParameterList parameters, const SourceLocation& where) {
    const Kind& kind = lightKinds().find(kindName, where);
    const Arguments arguments(reading, kind, where, std::move(parameters), state.attributesOf(Target::light), state.space);
    if (state.moves())
        reading.unsupported("moving light", where, "a moving light is not rendered yet; it stays where its motion starts");
    Light light;
    light.kind = &kindOf(static_cast<light_kind>(kind.value));
    const LightTraits& traits = light.kind->traits;
    if (traits.hasDirections && !isInvertible(state.transform))
        throw SceneError(where, kind.title() + ": its transform cannot be inverted; is there a Scale of 0?");
    light.where = where;
    light.scale = arguments.number("scale");
    light.group = lightGroup(arguments);
    light.worldFromLight = state.transform[0];
    if (!traits.read({reading, textures, arguments}, light)) return;
    arguments.reportUnused();
    reading.scene.lights.push_back(std::move(light));
}

int addAreaLight(Reading& reading, TextureRegistry& textures, const std::string& kindName, const GraphicsState& state,
                 ParameterList parameters, const SourceLocation& where) {
    const Kind& kind = areaLightKinds().find(kindName, where);
    const Arguments arguments(reading, kind, where, std::move(parameters), state.attributesOf(Target::light), state.space);
    if (arguments.has("filename") && arguments.has("L"))
        throw SceneError(arguments.whereOf("L"), "area light \"diffuse\" has either \"L\" or \"filename\", not both");
    AreaLight light;
    if (std::optional<ImageFile> file = arguments.image("filename")) {
        file->wrap = wrap_clamp;
        light.image = textures.image(*file);
    }
    light.where = where;
    light.L = arguments.spectrum("L", whiteOf(arguments));
    light.scale = arguments.number("scale");
    light.twoSided = arguments.flag("twosided");
    light.group = lightGroup(arguments);
    light.power = strengthOf(reading, arguments, "power");
    arguments.reportUnused();
    reading.scene.areaLights.push_back(std::move(light));
    return static_cast<int>(reading.scene.areaLights.size()) - 1;
}

}  // namespace eikonal::pbrt
