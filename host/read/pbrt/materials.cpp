#include "read/pbrt/materials.h"

#include "kinds/material_reading.h"

#include <algorithm>
#include <utility>

namespace eikonal::pbrt {
namespace {

/// The directives of all kinds, in the order of MATERIALS.
struct DirectiveOfKind { const MaterialKind* kind; const MaterialDirective* directive; };
const std::vector<DirectiveOfKind>& directiveList() {
    static const std::vector<DirectiveOfKind> list = [] {
        std::vector<DirectiveOfKind> directives;
        for (const MaterialKind* kind : materialKindList())
            for (const MaterialDirective& d : kind->directives) directives.push_back({kind, &d});
        return directives;
    }();
    return list;
}

constexpr const char* commonParameters =
    "floatmap displacement -> -; file normalmap -> -; string type -> -";

}  // namespace

const KindTable& materialKinds() {
    static const KindTable table = [] {
        std::vector<Row> rows;
        for (const auto& [kind, directive] : directiveList())
            rows.push_back({directive->name, static_cast<int>(rows.size()), directive->parameters});
        return KindTable("material", commonParameters, rows);
    }();
    return table;
}

int MaterialRegistry::numberOf(const std::string& name) {
    const auto [place, isNew] = numbers_.try_emplace(name, static_cast<int>(entries_.size()));
    if (isNew) entries_.push_back({name});
    return place->second;
}

int MaterialRegistry::define(const std::string& name, const std::string& kindName, const GraphicsState& state, ParameterList parameters,
                         const SourceLocation& where) {
    const Kind& kind = materialKinds().find(kindName, where);
    auto arguments =
        std::make_unique<Arguments>(reading_, kind, where, std::move(parameters), state.attributesOf(Target::material), state.space);
    if (kindName == "none" || kindName.empty())
        reading_.diagnostics.warnOnce("material none", where, kind.title() + " is deprecated; use \"interface\", its name in pbrt-v4");
    if (name.empty()) {
        entries_.push_back({"", std::move(arguments)});
        return static_cast<int>(entries_.size()) - 1;
    }
    const int number = numberOf(name);
    if (entries_[number].arguments)
        throw SceneError(where, "there is already a material \"" + name + "\", at " + entries_[number].arguments->where().toString());
    entries_[number].arguments = std::move(arguments);
    return number;
}

int MaterialRegistry::resolve(int number, const SourceLocation& where) {
    if (number == none) return none;
    Entry& entry = entries_[number];
    if (entry.index != none) {
        nesting_.meet(entry.height);
        return entry.index;
    }
    if (!entry.arguments) {
        if (std::exchange(entry.missed, true)) return none;
        std::vector<std::string> names;
        for (const Entry& other : entries_)
            if (other.arguments && !other.name.empty()) names.push_back(other.name);
        const std::string near = nearestWord(entry.name, names);
        reading_.problems.add(where,
                              "there is no material \"" + entry.name + "\"" + (near.empty() ? "" : "; did you mean \"" + near + "\"?"));
        return none;
    }
    if (entry.beingBuilt) throw SceneError(where, "the material \"" + entry.name + "\" is a mix of itself");

    Material material;
    material.name = entry.name;
    material.where = entry.arguments->where();
    material.kind = directiveList()[static_cast<size_t>(entry.arguments->kind().value)].kind;
    entry.height = nesting_.around(material.where, [&] {
        entry.beingBuilt = true;
        reading_.problems.guard([&] { build(entry, material); });
        entry.beingBuilt = false;
    });
    reading_.scene.materials.push_back(std::move(material));
    return entry.index = static_cast<int>(reading_.scene.materials.size()) - 1;
}

int MaterialRegistry::named(const std::string& name, const SourceLocation& where) { return resolve(numberOf(name), where); }

void MaterialRegistry::finish() {
    for (size_t number = 0; number < entries_.size(); ++number)
        if (entries_[number].arguments) resolve(static_cast<int>(number), entries_[number].arguments->where());
}

void MaterialRegistry::build(Entry& entry, Material& material) {
    const Arguments& arguments = *entry.arguments;
    readInputs(arguments, material);
    if (arguments.kind().rule("remaproughness")) material.remapRoughness = arguments.flag("remaproughness");
    if (material.kind->isSurface) {
        material.displacement = textures_.textureOf(arguments, "displacement");
        material.normalMap = normalMap(arguments);
        if (material.displacement != none && material.normalMap != none) {
            reading_.diagnostics.warn(arguments.whereOf("displacement"),
                                      "\"displacement\" is ignored, since there is a \"normalmap\" as well, as in pbrt-v4");
            material.displacement = none;
        }
    }

    if (material.kind->metalIndices[0]) preferReflectance(arguments, material);
    if (material.kind->read) material.kind->read({reading_, arguments, textures_, *this}, material);
    arguments.reportUnused();
}

void MaterialRegistry::preferReflectance(const Arguments& arguments, Material& material) {
    if (!arguments.has("reflectance")) return;
    const auto& indices = material.kind->metalIndices;
    for (const Rule& rule : arguments.kind().rules)
        if (std::ranges::count(indices, rule.as) && arguments.has(rule.name))
            throw SceneError(arguments.whereOf(rule.name),
                             arguments.kind().title() + " has either \"reflectance\" or \"" + rule.name + "\", not both");
    for (const char* index : indices) material.inputs.erase(index);
}

void MaterialRegistry::readInputs(const Arguments& arguments, Material& material) {
    for (const Rule& rule : arguments.kind().rules) {
        if (rule.as == "-" || (rule.fallback.empty() && !arguments.has(rule.name))) continue;
        Input input;
        if (rule.wanted == Wanted::integer) input = {Spectrum::constant(arguments.integer(rule.name)), none, arguments.whereOf(rule.name)};
        else input = textures_.input(arguments, rule.name);
        if (const Parameter* given = arguments.given(rule.name); rule.wanted == Wanted::index && given &&
                                                                 given->type == ParameterType::number &&
                                                                 std::get<std::vector<double>>(given->values).front() == 0) {
            reading_.diagnostics.warnOnce(
                "index of 0", input.where,
                arguments.kind().title() + ": \"" + given->declaration() + "\" is 0; it counts as 1, as in pbrt-v4");
            input.value = Spectrum::constant(1);
        }
        material.inputs[rule.as] = std::move(input);
    }
}

int MaterialRegistry::normalMap(const Arguments& arguments) {
    const std::optional<std::string> path = arguments.file("normalmap", "the surface has no normal map");
    if (!path) return none;
    ImageFile file{*path};
    file.encoding = ColorEncoding::linear;
    file.where = arguments.whereOf("normalmap");
    return textures_.image(file);
}

}  // namespace eikonal::pbrt
