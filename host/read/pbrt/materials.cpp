#include "read/pbrt/materials.h"

#include "read/pbrt/hair.h"
#include "read/pbrt/subsurface.h"

#include <algorithm>
#include <utility>

namespace eikonal::pbrt {
namespace {

constexpr int kindOf(MaterialKind kind) { return static_cast<int>(kind); }

}  // namespace

// The common parameters of all materials are appended to each row. "-> name" gives a parameter another name in the scene; "-> -" omits it
// from the scene.
const KindTable& materialKinds() {
    static const KindTable table("material", "floatmap displacement -> -; file normalmap -> -; bool remaproughness = true -> -; string type -> -", {
        {"diffuse", kindOf(MaterialKind::diffuse), "colormap reflectance = 0.5"},
        {"coateddiffuse", kindOf(MaterialKind::coatedDiffuse),
         "colormap reflectance = 0.5; floatmap uroughness | roughness = 0 clamped to [0, inf); floatmap vroughness | roughness = 0 clamped to [0, inf);"
         "floatmap thickness = 0.01 clamped to [0, inf);"
         "index eta = 1.5 in [0, inf); floatmap g = 0 clamped to [-1, 1]; colormap albedo = 0; integer maxdepth = 10 clamped to [0, inf);"
         "integer nsamples = 1 in [1, inf)"},
        {"conductor", kindOf(MaterialKind::conductor),
         "spectrummap eta = metal-Cu-eta; spectrummap k = metal-Cu-k; colormap reflectance;"
         "floatmap uroughness | roughness = 0 clamped to [0, inf); floatmap vroughness | roughness = 0 clamped to [0, inf)"},
        {"dielectric", kindOf(MaterialKind::dielectric),
         "index eta = 1.5 in [0, inf); floatmap uroughness | roughness = 0 clamped to [0, inf); floatmap vroughness | roughness = 0 clamped to [0, inf)"},
        {"thindielectric", kindOf(MaterialKind::thinDielectric), "index eta = 1.5 in [0, inf)"},
        {"diffusetransmission", kindOf(MaterialKind::diffuseTransmission),
         "colormap reflectance = 0.25; colormap transmittance = 0.25; float scale = 1 clamped to [0, inf) -> -"},
        {"mix", kindOf(MaterialKind::mix), "strings materials -> -; floatmap amount = 0.5"},
        {"interface", kindOf(MaterialKind::interface), ""},
        {"none", kindOf(MaterialKind::interface), ""},
        {"", kindOf(MaterialKind::interface), ""},
        {"coatedconductor", kindOf(MaterialKind::coatedConductor),
         "spectrummap conductor.eta = metal-Cu-eta -> metal_eta; spectrummap conductor.k = metal-Cu-k -> metal_k; colormap reflectance;"
         "floatmap conductor.uroughness | conductor.roughness = 0 clamped to [0, inf) -> metal_uroughness;"
         "floatmap conductor.vroughness | conductor.roughness = 0 clamped to [0, inf) -> metal_vroughness;"
         "floatmap interface.uroughness | interface.roughness = 0 clamped to [0, inf) -> uroughness;"
         "floatmap interface.vroughness | interface.roughness = 0 clamped to [0, inf) -> vroughness;"
         "index interface.eta = 1.5 in [0, inf) -> eta; floatmap thickness = 0.01 clamped to [0, inf); floatmap g = 0 clamped to [-1, 1]; colormap albedo = 0;"
         "integer maxdepth = 10 clamped to [0, inf); integer nsamples = 1 in [1, inf)"},
        {"subsurface", kindOf(MaterialKind::subsurface),
         "floatmap uroughness | roughness = 0 clamped to [0, inf); floatmap vroughness | roughness = 0 clamped to [0, inf); index eta = 1.33 in [0, inf);"
         "string name -> -; spectrummap sigma_a -> -; spectrummap sigma_s -> -; colormap reflectance -> -; spectrummap mfp -> -;"
         "string method = diffusion -> -; float scale = 1 in [0, inf) -> -; float g = 0 clamped to [-1, 1] -> -"},
        {"hair", kindOf(MaterialKind::hair),
         "spectrummap sigma_a; colormap reflectance | color -> -; floatmap eumelanin = 0 clamped to [0, inf) -> -;"
         "floatmap pheomelanin = 0 clamped to [0, inf) -> -; floatmap eta = 1.55 in (0, inf);"
         "floatmap beta_m = 0.3 clamped to [0, 1]; floatmap beta_n = 0.3 clamped to [0, 1]; floatmap alpha = 2"},
        {"measured", kindOf(MaterialKind::measured), "file filename -> -"},
    });
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
    auto arguments = std::make_unique<Arguments>(reading_, kind, where, std::move(parameters), state.attributesOf(Target::material), state.space);
    if (kindName == "none" || kindName.empty())
        reading_.diagnostics.warnOnce("material none", where, kind.title() + " is deprecated; \"interface\" is its name in pbrt-v4");
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
    if (entry.index != none) return entry.index;
    if (!entry.arguments) {
        if (std::exchange(entry.missed, true)) return none;
        std::vector<std::string> names;
        for (const Entry& other : entries_)
            if (other.arguments && !other.name.empty()) names.push_back(other.name);
        const std::string near = nearestWord(entry.name, names);
        reading_.problems.add(where, "there is no material \"" + entry.name + "\"" + (near.empty() ? "" : "; did you mean \"" + near + "\"?"));
        return none;
    }
    if (entry.beingBuilt) throw SceneError(where, "the material \"" + entry.name + "\" is a mix of itself");

    Material material;
    material.name = entry.name;
    material.where = entry.arguments->where();
    material.kind = static_cast<MaterialKind>(entry.arguments->kind().value);
    entry.beingBuilt = true;
    reading_.problems.guard([&] { build(entry, material); });
    entry.beingBuilt = false;
    reading_.scene.materials.push_back(std::move(material));
    return entry.index = static_cast<int>(reading_.scene.materials.size()) - 1;
}

void MaterialRegistry::finish() {
    for (size_t number = 0; number < entries_.size(); ++number)
        if (entries_[number].arguments) resolve(static_cast<int>(number), entries_[number].arguments->where());
}

void MaterialRegistry::build(Entry& entry, Material& material) {
    const Arguments& arguments = *entry.arguments;
    readInputs(arguments, material);
    material.remapRoughness = arguments.flag("remaproughness");
    material.displacement = textures_.textureOf(arguments, "displacement");
    material.normalMap = normalMap(arguments);

    if (material.kind == MaterialKind::mix) readMix(arguments, material);
    if (material.kind == MaterialKind::diffuseTransmission) {
        const double scale = arguments.number("scale");
        for (auto& [name, input] : material.inputs) input = textures_.scaled(input, scale);
    }
    if (material.kind == MaterialKind::conductor) preferReflectance(arguments, material, {"eta", "k"});
    if (material.kind == MaterialKind::coatedConductor) preferReflectance(arguments, material, {"metal_eta", "metal_k"});
    if (material.kind == MaterialKind::measured) readMeasured(arguments, material);
    if (material.kind == MaterialKind::subsurface) readInterior(reading_, arguments, material, textures_);
    if (material.kind == MaterialKind::hair) readHair(reading_, textures_, arguments, material);
}

void MaterialRegistry::preferReflectance(const Arguments& arguments, Material& material, const std::array<std::string, 2>& indices) {
    if (!arguments.has("reflectance")) return;
    for (const Rule& rule : arguments.kind().rules)
        if (std::ranges::count(indices, rule.as) && arguments.has(rule.name))
            throw SceneError(arguments.whereOf(rule.name), arguments.kind().title() + " has either \"reflectance\" or \"" + rule.name + "\", not both");
    for (const std::string& index : indices) material.inputs.erase(index);
}

void MaterialRegistry::readInputs(const Arguments& arguments, Material& material) {
    for (const Rule& rule : arguments.kind().rules) {
        if (rule.as == "-" || (rule.fallback.empty() && !arguments.has(rule.name))) continue;
        Input input;
        if (rule.wanted == Wanted::integer) input = {Spectrum::constant(arguments.integer(rule.name)), none, arguments.whereOf(rule.name)};
        else input = textures_.input(arguments, rule.name);
        if (const Parameter* given = arguments.given(rule.name); rule.wanted == Wanted::index && given && given->type == ParameterType::number &&
                                                                  std::get<std::vector<double>>(given->values).front() == 0) {
            reading_.diagnostics.warnOnce("index of 0", input.where, arguments.kind().title() + ": \"" + given->declaration() + "\" is 0; it counts as 1, as in pbrt-v4");
            input.value = Spectrum::constant(1);
        }
        material.inputs[rule.as] = std::move(input);
    }
}

void MaterialRegistry::readMix(const Arguments& arguments, Material& material) {
    const std::vector<std::string> names = arguments.texts("materials");
    const SourceLocation& where = arguments.whereOf("materials");
    if (names.size() != 2) throw SceneError(where, "material \"mix\" needs the names of two materials in \"string materials\"");
    for (int i = 0; i < 2; ++i) {
        material.mixed[i] = resolve(numberOf(names[i]), where);
        if (material.mixed[i] != none && reading_.scene.materials[material.mixed[i]].kind == MaterialKind::interface)
            throw SceneError(where, "\"" + names[i] + "\" is an interface, which cannot be part of a mix");
    }
}

void MaterialRegistry::readMeasured(const Arguments& arguments, Material& material) {
    const std::optional<std::string> path = arguments.file("filename");
    if (!path && !arguments.has("filename")) throw SceneError(arguments.where(), "material \"measured\" needs a \"string filename\": a .bsdf file of the RGL material database");
    material.file = path.value_or("");  // if missing, that is already noted
    material.where = arguments.whereOf("filename");
}

int MaterialRegistry::normalMap(const Arguments& arguments) {
    const std::optional<std::string> path = arguments.file("normalmap");
    if (!path) return none;
    ImageFile file{*path};
    file.encoding = ColorEncoding::linear;
    file.where = arguments.whereOf("normalmap");
    return textures_.image(file);
}

}  // namespace eikonal::pbrt
