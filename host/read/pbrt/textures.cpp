#include "read/pbrt/textures.h"

#include "eikonal/textures.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace eikonal::pbrt {
namespace {

enum TextureKind { constantKind, scaleKind, mixKind, imagemapKind, checkerboardKind, bilerpKind, dotsKind, directionMixKind, fbmKind, wrinkledKind, windyKind, marbleKind, ptexKind };

constexpr const char* mappingParameters =
    "string mapping = uv; float uscale = 1; float vscale = 1; float udelta = 0; float vdelta = 0; vector3 v1; vector3 v2";

/// The kinds of float or spectrum textures. map: a value or texture of that type; value: no texture.
KindTable makeTable(bool isFloat, const std::string& map, const std::string& value) {
    const auto floatOnly = [&](const char* name) { return isFloat ? name : nullptr; };
    const auto spectrumOnly = [&](const char* name) { return isFloat ? nullptr : name; };
    const auto maps = [&](const char* first, const char* second) { return map + " " + first + "; " + map + " " + second + "; "; };
    const std::string corners = value + " v00 = 0; " + value + " v01 = 1; " + value + " v10 = 0; " + value + " v11 = 1; ";
    const std::string imagemap = "file filename; string wrap = repeat; string filter = bilinear; float maxanisotropy = 8; float scale = 1; "
                                 "bool invert = false; string encoding; ";
    return KindTable("texture", "", {
        {"constant", constantKind, (value + " value = 1").c_str()},
        {"scale", scaleKind, (map + " tex = 1; floatmap scale = 1").c_str()},
        {"mix", mixKind, (maps("tex1 = 0", "tex2 = 1") + "floatmap amount = 0.5").c_str()},
        {"imagemap", imagemapKind, (imagemap + mappingParameters).c_str()},
        {"checkerboard", checkerboardKind, (maps("tex1 = 1", "tex2 = 0") + "integer dimension = 2; " + mappingParameters).c_str()},
        {"directionmix", directionMixKind, (maps("tex1 = 0", "tex2 = 1") + "vector3 dir").c_str()},
        {"bilerp", bilerpKind, (corners + mappingParameters).c_str()},
        {"dots", dotsKind, (maps("inside = 1", "outside = 0") + mappingParameters).c_str()},
        {floatOnly("fbm"), fbmKind, "integer octaves = 8; float roughness = 0.5"},
        {floatOnly("wrinkled"), wrinkledKind, "integer octaves = 8; float roughness = 0.5"},
        {floatOnly("windy"), windyKind, ""},
        {spectrumOnly("marble"), marbleKind, "integer octaves = 8; float roughness = 0.5; float scale = 1; float variation = 0.2"},
        // Not rendered; a number replaces it.
        {"ptex", ptexKind, "file filename; string encoding; float scale = 1", "0.5"},
    });
}

/// The index in `words` of a parameter's word. Throws SceneError for other words.
int choose(const Arguments& arguments, const std::string& name, std::initializer_list<const char*> words) {
    const std::string word = arguments.text(name);
    const auto found = std::ranges::find(words, word);
    if (found != words.end()) return static_cast<int>(found - words.begin());
    std::string list;
    for (const char* w : words) list += std::string(list.empty() ? "\"" : ", \"") + w + '"';
    throw SceneError(arguments.whereOf(name), "\"string " + name + "\" is \"" + word + "\"; it can be " + list);
}

/// "gamma 2.2", "sRGB" or "linear", which pbrt-v4 reads for PNG files only.
void readEncoding(const Arguments& arguments, ImageFile& file) {
    const std::string encoding = arguments.text("encoding");
    if (encoding.empty()) return;
    std::string ending = std::filesystem::path(file.path).extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
    const bool isPng = ending == ".png";
    if (encoding == "sRGB") {
        if (isPng) file.encoding = ColorEncoding::srgb;
    } else if (encoding == "linear") {
        if (isPng) file.encoding = ColorEncoding::linear;
    } else {
        const double gamma = encoding.starts_with("gamma ") ? std::atof(encoding.c_str() + 6) : 0;
        if (!(gamma > 0))
            throw SceneError(arguments.whereOf("encoding"), "\"string encoding\" is \"" + encoding + "\"; it can be \"sRGB\", \"linear\" or \"gamma 2.2\"");
        if (isPng) file.gamma = gamma;
    }
}

Mapping readMapping(const Arguments& arguments, const Transform& worldFromTexture) {
    constexpr TextureMapping mappings[] = {TextureMapping::uv, TextureMapping::spherical, TextureMapping::cylindrical, TextureMapping::planar};
    Mapping mapping;
    mapping.kind = mappings[choose(arguments, "mapping", {"uv", "spherical", "cylindrical", "planar"})];
    if (mapping.kind == TextureMapping::uv) {
        mapping.uScale = arguments.number("uscale");
        mapping.vScale = arguments.number("vscale");
    }
    if (mapping.kind == TextureMapping::uv || mapping.kind == TextureMapping::planar) {
        mapping.uOffset = arguments.number("udelta");
        mapping.vOffset = arguments.number("vdelta");
    }
    mapping.planeU = arguments.vector("v1", {1, 0, 0});
    mapping.planeV = arguments.vector("v2", {0, 1, 0});
    mapping.worldFromTexture = worldFromTexture;
    return mapping;
}

int readOctaves(const Arguments& arguments) {
    const int octaves = arguments.integer("octaves");
    if (octaves < 0 || octaves > MOST_OCTAVES)
        throw SceneError(arguments.whereOf("octaves"), "\"integer octaves\" is " + std::to_string(octaves) + "; it can be 0 to " + std::to_string(MOST_OCTAVES));
    return octaves;
}

NoiseTexture readNoise(const Arguments& arguments, NoisePattern pattern, const Transform& worldFromTexture) {
    NoiseTexture noise{.pattern = pattern, .worldFromTexture = worldFromTexture};
    if (pattern == NoisePattern::windy) return noise;
    noise.octaves = readOctaves(arguments);
    noise.roughness = arguments.number("roughness");
    if (pattern == NoisePattern::marble) {
        noise.scale = arguments.number("scale");
        noise.variation = arguments.number("variation");
    }
    return noise;
}

glm::dvec3 readDirection(const Arguments& arguments, const Transform& worldFromTexture) {
    const glm::dvec3 direction = glm::dmat3(worldFromTexture) * arguments.vector("dir", {0, 1, 0});
    if (!(glm::length(direction) > 0)) throw SceneError(arguments.whereOf("dir"), "\"vector3 dir\" has no length");
    return glm::normalize(direction);
}

}  // namespace

const KindTable& textureKinds(bool isFloat) {
    static const KindTable tables[] = {makeTable(false, "colormap", "spectrum"), makeTable(true, "floatmap", "float")};
    return tables[isFloat];
}

std::string textureStandIn(const Kind& kind) {
    return (kind.rule(kind.standIn) ? "its \"" + std::string(kind.standIn) + "\"" : "a constant " + std::string(kind.standIn)) + " stands in for it";
}

void TextureRegistry::define(const std::string& name, bool isFloat, const std::string& kindName, const GraphicsState& state,
                         ParameterList parameters, const SourceLocation& where) {
    const Kind& kind = textureKinds(isFloat).find(kindName, where);
    Arguments arguments(reading_, kind, where, std::move(parameters), state.attributesOf(Target::texture), state.space);
    const auto [place, isNew] = definitions_.try_emplace({name, isFloat}, Definition{std::move(arguments), state.transform[0]});
    if (!isNew)
        throw SceneError(where, std::string("there is already a ") + (isFloat ? "float" : "spectrum") + " texture \"" + name + "\", at " +
                                    place->second.arguments.where().toString());
    order_.push_back(place->first);
    if (state.transform[0] != state.transform[1])
        reading_.unsupported("moving texture", where, "a texture that moves is not rendered yet; it stays where it is when the shutter opens");
}

int TextureRegistry::find(const std::string& name, bool isFloat, const SourceLocation& where) {
    const auto found = definitions_.find({name, isFloat});
    if (found != definitions_.end()) {
        if (found->second.beingBuilt) throw SceneError(where, "the texture \"" + name + "\" refers to itself");
        return build(found->first, found->second);
    }
    const std::string wanted = std::string("there is no ") + (isFloat ? "float" : "spectrum") + " texture \"" + name + "\"";
    if (definitions_.contains({name, !isFloat}))
        throw SceneError(where, wanted + ": \"" + name + "\" is a " + (isFloat ? "spectrum" : "float") + " texture");
    std::vector<std::string> names;
    for (const auto& [key, definition] : definitions_)
        if (key.second == isFloat) names.push_back(key.first);
    const std::string near = nearestWord(name, names);
    throw SceneError(where, wanted + (near.empty() ? "" : "; did you mean \"" + near + "\"?"));
}

Input TextureRegistry::input(const Arguments& arguments, const std::string& name, const Spectrum& fallback) {
    const Parameter* parameter = arguments.given(name);
    if (!parameter) return {arguments.spectrum(name, fallback)};
    if (parameter->type != ParameterType::texture) return {arguments.spectrum(name), none, parameter->where};
    return {Spectrum(), textureOf(arguments, name), parameter->where};
}

int TextureRegistry::textureOf(const Arguments& arguments, const std::string& name) {
    const Parameter* parameter = arguments.given(name);
    if (!parameter || parameter->type != ParameterType::texture) return none;
    const Wanted wanted = arguments.kind().rule(name)->wanted;
    return textureOf(*parameter, wanted == Wanted::floatMap || wanted == Wanted::floatTexture);
}

int TextureRegistry::textureOf(const Parameter& parameter, bool isFloat) {
    const auto& names = std::get<std::vector<std::string>>(parameter.values);
    if (names.size() != 1)
        throw SceneError(parameter.where, "\"" + parameter.declaration() + "\" names " + std::to_string(names.size()) + " textures; one is expected");
    return find(names.front(), isFloat, parameter.where);
}

int TextureRegistry::image(const ImageFile& file) {
    const auto found = std::ranges::find(reading_.scene.images, file);
    if (found != reading_.scene.images.end()) return static_cast<int>(found - reading_.scene.images.begin());
    reading_.scene.images.push_back(file);
    return static_cast<int>(reading_.scene.images.size()) - 1;
}

Input TextureRegistry::scaled(const Input& input, double factor) {
    if (input.texture == none) return {input.value * factor, none, input.where};
    if (factor == 1) return input;
    return derive(ScaleTexture{input, {Spectrum::constant(factor)}}, input.where);
}

Input TextureRegistry::derive(decltype(Texture::kind) kind, const SourceLocation& where) {
    reading_.scene.textures.push_back({.name = {}, .isFloat = false, .kind = std::move(kind), .where = where});
    return {Spectrum(), static_cast<int>(reading_.scene.textures.size()) - 1, where};
}

void TextureRegistry::finish() {
    for (const Key& key : order_) build(key, definitions_.at(key));
}

int TextureRegistry::build(const Key& key, Definition& definition) {
    if (definition.index != none) return definition.index;
    Texture texture{key.first, key.second, ConstantTexture{}, definition.arguments.where()};
    definition.beingBuilt = true;
    reading_.problems.guard([&] { texture.kind = makeKind(definition); });
    definition.beingBuilt = false;
    reading_.scene.textures.push_back(std::move(texture));
    return definition.index = static_cast<int>(reading_.scene.textures.size()) - 1;
}

decltype(Texture::kind) TextureRegistry::makeKind(const Definition& definition) {
    const Arguments& arguments = definition.arguments;
    switch (arguments.kind().value) {
        case constantKind: return ConstantTexture{{arguments.spectrum("value"), none, arguments.whereOf("value")}};
        case scaleKind: return ScaleTexture{input(arguments, "tex"), input(arguments, "scale")};
        case mixKind: return MixTexture{input(arguments, "tex1"), input(arguments, "tex2"), input(arguments, "amount")};
        case imagemapKind: return makeImagemap(definition);
        case checkerboardKind: {
            const int dimensions = arguments.integer("dimension");
            if (dimensions != 2 && dimensions != 3)
                throw SceneError(arguments.whereOf("dimension"), "\"integer dimension\" is " + std::to_string(dimensions) + "; it can be 2 or 3");
            return CheckerboardTexture{input(arguments, "tex1"), input(arguments, "tex2"),
                                       readMapping(arguments, definition.worldFromTexture), dimensions};
        }
        case bilerpKind: {
            const auto corner = [&](const char* name) { return Input{arguments.spectrum(name), none, arguments.whereOf(name)}; };
            return BilerpTexture{corner("v00"), corner("v01"), corner("v10"), corner("v11"), readMapping(arguments, definition.worldFromTexture)};
        }
        case dotsKind:
            // pbrt-v4 passes these two in the wrong order: it paints the dots with "outside" and the gaps with "inside"
            return DotsTexture{input(arguments, "outside"), input(arguments, "inside"), readMapping(arguments, definition.worldFromTexture)};
        case directionMixKind:
            return DirectionMixTexture{input(arguments, "tex1"), input(arguments, "tex2"), readDirection(arguments, definition.worldFromTexture)};
        case fbmKind: return readNoise(arguments, NoisePattern::fbm, definition.worldFromTexture);
        case wrinkledKind: return readNoise(arguments, NoisePattern::wrinkled, definition.worldFromTexture);
        case windyKind: return readNoise(arguments, NoisePattern::windy, definition.worldFromTexture);
        case marbleKind: return readNoise(arguments, NoisePattern::marble, definition.worldFromTexture);
        default: return ConstantTexture{standIn(arguments)};
    }
}

decltype(Texture::kind) TextureRegistry::makeImagemap(const Definition& definition) {
    const Arguments& arguments = definition.arguments;
    if (!arguments.has("filename")) throw SceneError(arguments.where(), "texture \"imagemap\" needs a \"string filename\"");
    const std::optional<std::string> path = arguments.file("filename");
    if (!path) return ConstantTexture{};
    ImageFile file{*path};
    file.where = arguments.whereOf("filename");
    constexpr WrapMode wraps[] = {WrapMode::repeat, WrapMode::black, WrapMode::clamp, WrapMode::octahedral};
    file.wrap = wraps[choose(arguments, "wrap", {"repeat", "black", "clamp", "octahedralsphere"})];
    file.filter = choose(arguments, "filter", {"point", "bilinear", "trilinear", "ewa", "EWA"}) == 0 ? FilterMode::nearest : FilterMode::bilinear;
    readEncoding(arguments, file);
    return ImagemapTexture{image(file), readMapping(arguments, definition.worldFromTexture), arguments.number("scale"), arguments.flag("invert")};
}

Input TextureRegistry::standIn(const Arguments& arguments) {
    const Kind& kind = arguments.kind();
    reading_.unsupported(kind.title(), arguments.where(), kind.title() + " is not rendered yet; " + textureStandIn(kind));
    return kind.rule(kind.standIn) ? input(arguments, kind.standIn) : Input{Spectrum::constant(std::stod(kind.standIn))};
}

}  // namespace eikonal::pbrt
