#include "read/pbrt/lights.h"

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

#include <cmath>

namespace eikonal::pbrt {
namespace {

enum LightKind { pointKind, spotKind, distantKind, infiniteKind, goniometricKind, projectionKind };

Spectrum whiteOf(const Arguments& arguments) { return Spectrum::rgb({1, 1, 1}, arguments.space()); }

void readPoint(const Arguments& arguments, Light& light) {
    light.kind = PointLight{arguments.spectrum("I", whiteOf(arguments)), arguments.vector("from")};
    if (const double power = arguments.number("power"); power > 0) light.scale *= power / (4 * glm::pi<double>());
}

/// Checks that two points define a direction. Throws SceneError if they are equal.
void expectDirection(const Arguments& arguments, const glm::dvec3& from, const glm::dvec3& to) {
    if (from == to)
        throw SceneError(arguments.has("to") ? arguments.whereOf("to") : arguments.whereOf("from"),
                         fmt::format("{}: \"from\" and \"to\" are the same point, ({:g}, {:g}, {:g}); the light shines from one to the other", arguments.kind().title(), to.x, to.y, to.z));
}

void readSpot(Reading& reading, const Arguments& arguments, Light& light) {
    SpotLight spot{arguments.spectrum("I", whiteOf(arguments)), arguments.vector("from"), arguments.vector("to", {0, 0, 1}),
                   arguments.number("coneangle"), arguments.number("conedeltaangle")};
    expectDirection(arguments, spot.from, spot.to);
    if (spot.coneDeltaAngle > 2 * spot.coneAngle) {
        reading.diagnostics.warnOnce("conedeltaangle", arguments.whereOf("conedeltaangle"),
                                     fmt::format("{}: \"float conedeltaangle\" is {:g}, more than twice coneangle; it counts as coneangle, {:g}", arguments.kind().title(),
                                                 spot.coneDeltaAngle, spot.coneAngle));
        spot.coneDeltaAngle = spot.coneAngle;
    }
    if (const double power = arguments.number("power"); power > 0) {
        const double end = std::cos(glm::radians(spot.coneAngle)), start = std::cos(glm::radians(spot.coneAngle - spot.coneDeltaAngle));
        light.scale *= power / (2 * glm::pi<double>() * ((1 - start) + (start - end) / 2));
    }
    light.kind = spot;
}

void readDistant(const Arguments& arguments, Light& light) {
    const DistantLight distant{arguments.spectrum("L", whiteOf(arguments)), arguments.vector("from"), arguments.vector("to", {0, 0, 1})};
    expectDirection(arguments, distant.from, distant.to);
    light.kind = distant;
    if (const double illuminance = arguments.number("illuminance"); illuminance > 0) light.scale *= illuminance;
}

/// The required image of a light; none if the file is missing, which is noted.
int readImage(TextureRegistry& textures, const Arguments& arguments, WrapMode wrap) {
    if (!arguments.has("filename")) throw SceneError(arguments.where(), arguments.kind().title() + " needs an image: \"string filename\"");
    const std::optional<std::string> path = arguments.file("filename");
    if (!path) return none;
    ImageFile file{*path};
    file.wrap = wrap;
    file.where = arguments.whereOf("filename");
    return textures.image(file);
}

void readGoniometric(TextureRegistry& textures, const Arguments& arguments, Light& light) {
    light.kind = GoniometricLight{arguments.spectrum("I", whiteOf(arguments)), readImage(textures, arguments, WrapMode::octahedral)};
    if (const double power = arguments.number("power"); power > 0) light.power = power;
}

void readProjection(TextureRegistry& textures, const Arguments& arguments, Light& light) {
    light.kind = ProjectionLight{readImage(textures, arguments, WrapMode::clamp), arguments.number("fov")};
    if (const double power = arguments.number("power"); power > 0) light.power = power;
}

/// The corners of a portal. Throws SceneError unless they form a rectangle.
std::array<glm::dvec3, 4> readPortal(const Arguments& arguments) {
    const std::vector<glm::vec3> corners = arguments.vectors3("portal");
    if (corners.size() != 4)
        throw SceneError(arguments.whereOf("portal"), "a portal has 4 corners, not " + std::to_string(corners.size()));
    const std::array<glm::dvec3, 4> p{corners[0], corners[1], corners[2], corners[3]};
    const glm::dvec3 x = p[3] - p[0], y = p[1] - p[0], across = p[2] - p[1], up = p[2] - p[3];
    const double size = std::max(glm::length(x), glm::length(y));
    const bool isRectangle = std::min(glm::length(x), glm::length(y)) > 0 && glm::length(across - x) <= 1e-3 * size && glm::length(up - y) <= 1e-3 * size &&
                             std::abs(glm::dot(x, y)) <= 1e-3 * glm::length(x) * glm::length(y);
    if (!isRectangle) throw SceneError(arguments.whereOf("portal"), "the corners of a portal must be those of a rectangle, one after the other along its edge");
    return p;
}

/// Returns false if its image is missing.
bool readInfinite(TextureRegistry& textures, const Arguments& arguments, Light& light) {
    const double illuminance = arguments.number("illuminance");
    if (arguments.has("filename") && arguments.has("L"))
        throw SceneError(arguments.whereOf("L"), "light \"infinite\" has either \"L\" or \"filename\", not both");
    const int image = arguments.has("filename") ? readImage(textures, arguments, WrapMode::octahedral) : none;
    if (arguments.has("filename") && image == none) return false;
    const Spectrum L = arguments.spectrum("L", whiteOf(arguments));
    if (arguments.has("portal")) light.kind = PortalInfiniteLight{L, image, readPortal(arguments)};
    else if (image != none) light.kind = ImageInfiniteLight{image};
    else light.kind = ConstantInfiniteLight{L};
    if (image != none) {
        if (illuminance > 0) light.illuminance = illuminance;
    } else {
        if (illuminance > 0) light.scale *= illuminance / glm::pi<double>();
    }
    return true;
}

}  // namespace

const KindTable& lightKinds() {
    static const KindTable table("light", "float scale = 1 in [0, inf)", {
        {"point", pointKind, "spectrum I; float power = -1; point3 from"},
        {"spot", spotKind, "spectrum I; float power = -1; point3 from; point3 to; float coneangle = 30 in (0, 180]; float conedeltaangle = 5 in [0, 180]"},
        {"distant", distantKind, "spectrum L; float illuminance = -1; point3 from; point3 to"},
        {"infinite", infiniteKind, "spectrum L; file filename; float illuminance = -1; point3s portal"},
        {"goniometric", goniometricKind, "spectrum I; file filename; float power = -1"},
        {"projection", projectionKind, "file filename; float power = -1; float fov = 90 in (0, 180)"},
    });
    return table;
}

const KindTable& areaLightKinds() {
    static const KindTable table("area light", "", {
        {"diffuse", 0, "spectrum L; float scale = 1 in [0, inf); float power = -1; bool twosided = false; file filename"},
    });
    return table;
}

void addLight(Reading& reading, TextureRegistry& textures, const std::string& kindName, const GraphicsState& state, ParameterList parameters,
              const SourceLocation& where) {
    const Kind& kind = lightKinds().find(kindName, where);
    const Arguments arguments(reading, kind, where, std::move(parameters), state.attributesOf(Target::light), state.space);
    if (state.transform[0] != state.transform[1])
        reading.unsupported("moving light", where, "a light that moves is not rendered yet; it stays where it is when the shutter opens");
    if (kind.value != pointKind && !isInvertible(state.transform))
        throw SceneError(where, kind.title() + ": its transform cannot be inverted; is there a Scale of 0?");
    Light light;
    light.where = where;
    light.scale = arguments.number("scale");
    light.worldFromLight = state.transform[0];
    switch (kind.value) {
        case pointKind: readPoint(arguments, light); break;
        case spotKind: readSpot(reading, arguments, light); break;
        case distantKind: readDistant(arguments, light); break;
        case goniometricKind:
            readGoniometric(textures, arguments, light);
            if (std::get<GoniometricLight>(light.kind).image == none) return;
            break;
        case projectionKind:
            readProjection(textures, arguments, light);
            if (std::get<ProjectionLight>(light.kind).image == none) return;
            break;
        default:
            if (!readInfinite(textures, arguments, light)) return;
    }
    reading.scene.lights.push_back(std::move(light));
}

int addAreaLight(Reading& reading, TextureRegistry& textures, const std::string& kindName, const GraphicsState& state, ParameterList parameters, const SourceLocation& where) {
    const Kind& kind = areaLightKinds().find(kindName, where);
    const Arguments arguments(reading, kind, where, std::move(parameters), state.attributesOf(Target::light), state.space);
    if (arguments.has("filename") && arguments.has("L"))
        throw SceneError(arguments.whereOf("L"), "area light \"diffuse\" has either \"L\" or \"filename\", not both");
    AreaLight light;
    if (const std::optional<std::string> path = arguments.file("filename")) {
        ImageFile file{*path};
        file.wrap = WrapMode::clamp;
        file.where = arguments.whereOf("filename");
        light.image = textures.image(file);
    }
    light.where = where;
    light.L = arguments.spectrum("L", whiteOf(arguments));
    light.scale = arguments.number("scale");
    light.twoSided = arguments.flag("twosided");
    if (const double power = arguments.number("power"); power > 0) light.power = power;
    reading.scene.areaLights.push_back(std::move(light));
    return static_cast<int>(reading.scene.areaLights.size()) - 1;
}

}  // namespace eikonal::pbrt
