#include "read/pbrt/textures.h"

#include "kinds/texture_reading.h"
#include "read/formats/image.h"

#include <algorithm>
#include <list>
#include <string_view>
#include <utility>

namespace eikonal::pbrt {
namespace {

/// A row of TextureTraits, in which "map" and "value" stand for the types of float or of spectrum textures.
std::string rowOf(const TextureTraits& traits, bool isFloat) {
    std::string row;
    for (const char* part : traits.parameters)
        if (part) row += std::string(row.empty() ? "" : "; ") + part;
    for (const auto& [word, type] : {std::pair("map ", isFloat ? "floatmap " : "colormap "), {"value ", isFloat ? "float " : "spectrum "}})
        for (size_t at = 0; (at = row.find(word, at)) != std::string::npos; ++at)
            if (at == 0 || row.compare(at - 2, 2, "; ") == 0) row.replace(at, std::string_view(word).size(), type);
    return row;
}

bool mayBe(TextureTypes types, bool isFloat) {
    return types == TextureTypes::floatAndSpectrum || types == (isFloat ? TextureTypes::floatOnly : TextureTypes::spectrumOnly);
}

/// The kinds of float or spectrum textures.
KindTable makeTable(bool isFloat) {
    std::vector<Row> rows;
    std::list<std::string> parameters;   // of each row
    for (const TextureKind& kind : textureKindList())
        if (mayBe(kind.traits.types, isFloat))
            rows.push_back({kind.name, kind.value, parameters.emplace_back(rowOf(kind.traits, isFloat)).c_str()});
    // Not rendered; a number replaces it.
    rows.push_back({"ptex", kind_constant_texture, "file filename; string encoding; float scale = 1", "0.5"});
    return KindTable("texture", "", rows);
}

}  // namespace

const KindTable& textureKinds(bool isFloat) {
    static const KindTable tables[] = {makeTable(false), makeTable(true)};
    return tables[isFloat];
}

std::string textureStandIn(const Kind& kind) {
    return (kind.rule(kind.standIn) ? "its \"" + std::string(kind.standIn) + "\"" : "a constant " + std::string(kind.standIn)) +
           " stands in for it";
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
    if (state.moves())
        reading_.unsupported("moving texture", where,
                             "a moving texture is not rendered yet; it stays where its motion starts");
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
        throw SceneError(parameter.where,
                         "\"" + parameter.declaration() + "\" names " + std::to_string(names.size()) + " textures; one is expected");
    return find(names.front(), isFloat, parameter.where);
}

int TextureRegistry::image(const ImageFile& file) {
    return addImage(reading_.scene, file);
}

Input TextureRegistry::scaled(const Input& input, double factor) {
    if (input.texture == none) return {input.value * factor, none, input.where};
    if (factor == 1) return input;
    return derive(kind_scale_texture, {input, {Spectrum::constant(factor)}}, input.where);
}

Input TextureRegistry::derive(texture_kind kind, std::vector<Input> operands, const SourceLocation& where) {
    Texture texture;
    texture.kind = &kindOf(kind);
    texture.operands = std::move(operands);
    texture.where = where;
    return derive(std::move(texture));
}

Input TextureRegistry::derive(Texture texture) {
    const SourceLocation where = texture.where;
    reading_.scene.textures.push_back(std::move(texture));
    return {Spectrum(), static_cast<int>(reading_.scene.textures.size()) - 1, where};
}

void TextureRegistry::finish() {
    for (const Key& key : order_) build(key, definitions_.at(key));
}

int TextureRegistry::build(const Key& key, Definition& definition) {
    if (definition.index != none) {
        nesting_.meet(definition.height);
        return definition.index;
    }
    Texture texture;
    texture.name = key.first;
    texture.isFloat = key.second;
    texture.where = definition.arguments.where();
    definition.height = nesting_.around(texture.where, [&] {
        definition.beingBuilt = true;
        reading_.problems.guard([&] { read(definition, texture); });
        definition.beingBuilt = false;
    });
    if (!texture.kind) {   // it could not be read, which has been reported
        texture.kind = &kindOf(kind_constant_texture);
        texture.operands = {Input{}};
    }
    reading_.scene.textures.push_back(std::move(texture));
    return definition.index = static_cast<int>(reading_.scene.textures.size()) - 1;
}

void TextureRegistry::read(const Definition& definition, Texture& texture) {
    const Arguments& arguments = definition.arguments;
    const TextureKind& kind = kindOf(static_cast<texture_kind>(arguments.kind().value));
    texture.mapping.worldFromTexture = definition.worldFromTexture;
    bool isComplete = true;
    if (arguments.kind().standIn) texture.operands = {standIn(arguments)};
    else if (kind.traits.read) isComplete = kind.traits.read({reading_, *this, arguments}, texture);
    if (!isComplete) return;
    texture.kind = &kind;
    if (!arguments.kind().standIn) arguments.reportUnused();
}

Input TextureRegistry::standIn(const Arguments& arguments) {
    const Kind& kind = arguments.kind();
    reading_.unsupported(kind.title(), arguments.where(), kind.title() + " is not rendered yet; " + textureStandIn(kind));
    return kind.rule(kind.standIn) ? input(arguments, kind.standIn) : Input{Spectrum::constant(std::stod(kind.standIn))};
}

}  // namespace eikonal::pbrt
