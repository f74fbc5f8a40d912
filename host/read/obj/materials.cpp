#include "read/obj/materials.h"

#include "kinds/material_kind.h"
#include "read/formats/image.h"
#include "read/obj/mtl_inputs.h"
#include "read/obj/mtl_ranges.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace eikonal {
namespace {

double maximum(const glm::dvec3& c) { return std::max({c.x, c.y, c.z}); }
double mean(const glm::dvec3& c) { return (c.x + c.y + c.z) / 3; }

/// The GGX alpha whose highlight matches a Blinn-Phong exponent: Walter et al. 2007.
double widthOfExponent(double exponent) { return std::sqrt(2 / (exponent + 2)); }

/// The index of refraction with a reflectance of 8 % times the specular colour: the convention of Disney's "specular", which exporters
/// follow.
double indexOfSpecular(double specular) {
    const double root = std::sqrt(0.08 * specular);
    return (1 + root) / (1 - root);
}

/// Builds the textures and materials of one MTL material.
class Builder : MtlInputs {
public:
    Builder(Scene& scene, const MtlMaterial& mtl, double textureSize, ObjFiles& files, Diagnostics& diagnostics)
        : MtlInputs(scene, mtl, files, diagnostics), textureSize_(textureSize) {}

    ObjMaterial build() {
        reportUnknown();
        ObjMaterial result;
        const int surface = chooseSurface();
        addBumpOrNormalMap(surface);
        result.material = surface;
        result.alpha = opacity();
        result.areaLight = light();
        result.usesUvs = usesUvs_;
        return result;
    }

private:
    // ---- surfaces -----------------------------------------------------------------------------------------------------------

    int add(const MaterialKind& kind, std::map<std::string, Input> inputs, bool remapRoughness = false) {
        Material material;
        material.kind = &kind;
        material.name = mtl_.name;
        material.inputs = std::move(inputs);
        material.remapRoughness = remapRoughness;
        material.where = mtl_.where;
        scene_.materials.push_back(std::move(material));
        return static_cast<int>(scene_.materials.size()) - 1;
    }

    int diffuse(const Input& reflectance) { return add(diffuse_material, {{"reflectance", reflectance}}); }

    struct Widths { Input u, v; };

    int conductor(const Input& reflectance, const Widths& widths) {
        return add(conductor_material, {{"reflectance", reflectance}, {"uroughness", widths.u}, {"vroughness", widths.v}});
    }

    int coated(const Input& reflectance, double eta, const Widths& widths) {
        return add(coated_diffuse_material,
                   {{"reflectance", reflectance}, {"uroughness", widths.u}, {"vroughness", widths.v}, {"eta", constant(eta, "ni")},
                    {"thickness", {Spectrum::constant(0.01)}}, {"g", {Spectrum::constant(0)}}, {"albedo", {Spectrum::constant(0)}},
                    {"maxdepth", {Spectrum::constant(10)}}, {"nsamples", {Spectrum::constant(1)}}});
    }

    int mix(int a, int b, const Input& amount) {
        const int index = add(mix_material, {{"amount", amount}});
        scene_.materials[static_cast<std::size_t>(index)].mixed = {a, b};
        return index;
    }

    glm::dvec3 specular() const { return mtl_.color("ks").value_or(glm::dvec3(0)); }

    /// Kd, times map_Kd. Without both: black if other statements describe the surface, else grey.
    Input diffuseColor() {
        const bool isOtherwise = mtl_.has("ks") || mtl_.has("ke") || mtl_.has("map_ke") || mtl_.has("tf") || mtl_.has("map_ks");
        const glm::dvec3 kd = mtl_.color("kd").value_or(glm::dvec3(mtl_.has("map_kd") ? 1 : isOtherwise ? 0 : 0.5));
        const auto map = texture("map_kd", false);
        if (!map) return color(kd, "kd");
        if (kd == glm::dvec3(1) || kd == glm::dvec3(0)) return *map;  // Exporters write a factor of 0 to mean the map alone
        return product(*map, color(kd, "kd"), false);
    }

    bool isBlack(const std::string& keyword, const std::string& map) const {
        return maximum(mtl_.color(keyword).value_or(glm::dvec3(0))) <= 0.05 && !mtl_.has(map);
    }

    int illumination() const { return static_cast<int>(mtl_.number("illum").value_or(2)); }

    bool isRefractive() const {
        const int illum = illumination();
        if (illum == 6 || illum == 7) return true;
        const bool isSeeThrough = illum == 4 || illum == 9 || dissolve() < 1;
        return isSeeThrough && mtl_.number("ni").value_or(1) > 1 && isBlack("kd", "map_kd");
    }

    int chooseSurface() {
        if (isRefractive()) return refractive();
        for (const char* keyword : {"pr", "map_pr", "pm", "map_pm", "pc", "ps", "map_ps"})
            if (mtl_.has(keyword)) return physicallyBased();
        const int illum = illumination();
        if (illum <= 1 || isBlack("ks", "map_ks")) return diffuse(diffuseColor());

        const bool isMirror = illum == 3 || illum == 5 || illum == 8;
        const double width = isMirror ? 0 : widthOfExponent(mtl_.number("ns").value_or(10));
        const Widths widths{constant(width, "ns"), constant(width, "ns")};
        if (isBlack("kd", "map_kd")) return conductor(specularColor(), widths);
        if (isMirror) {
            const double amount = mean(specular()) / (mean(specular()) + mean(mtl_.color("kd").value_or(glm::dvec3(1))));
            return mix(diffuse(diffuseColor()), conductor(specularColor(), widths), constant(amount, "ks"));
        }
        const Input base = diffuseColor();
        const int plastic = coated(base, indexOfSpecular(mtl_.has("ks") ? mean(specular()) : 0.5), widths);
        const auto map = texture("map_ks", true);
        return map ? mix(diffuse(base), plastic, *map) : plastic;
    }

    Input specularColor() {
        const auto map = texture("map_ks", false);
        const glm::dvec3 ks = mtl_.has("ks") ? specular() : glm::dvec3(1);
        if (!map) return color(ks, "ks");
        return ks == glm::dvec3(1) || ks == glm::dvec3(0) ? *map : product(*map, color(ks, "ks"), false);
    }

    int refractive() {
        const double eta = mtl_.number("ni").value_or(1.5), width = std::pow(mtl_.number("pr").value_or(0), 2);
        const glm::dvec3 filter = mtl_.color("tf").value_or(glm::dvec3(1));
        if (maximum(filter) - std::min({filter.x, filter.y, filter.z}) > 0.05)
            diagnostics_.unsupported("mtl tf", mtl_.whereIs("tf"), "colored transmission (\"Tf\") is not rendered; the glass is clear");
        return add(dielectric_material,
                   {{"eta", constant(eta, "ni")}, {"uroughness", constant(width, "pr")}, {"vroughness", constant(width, "pr")}});
    }

    /// Pr Pm Ps Pc Pcr aniso: a mix of plastic and metal under a clear coat, with sheen.
    int physicallyBased() {
        if (mtl_.number("anisor").value_or(0) != 0)
            diagnostics_.unsupported("mtl anisor", mtl_.whereIs("anisor"),
                                     "\"anisor\" is not rendered: stretched highlights follow the texture coordinates");
        const Input base = diffuseColor(), metallic = portion("pm", "map_pm"), sheen = portion("ps", "map_ps");
        const double coat = mtl_.number("pc").value_or(0), coatRoughness = mtl_.number("pcr").value_or(0);
        const Widths widths = roughness();
        if (metallic.texture == none && metallic.value.value() == 1 && coat == 0) return conductor(base, widths);
        const double eta = mtl_.number("ni").value_or(1) > 1 ? *mtl_.number("ni") : 1.5;
        return add(principled_material, {{"base", base},
                                         {"metallic", metallic},
                                         {"eta", constant(eta, "ni")},
                                         {"uroughness", widths.u},
                                         {"vroughness", widths.v},
                                         {"coat", constant(coat, "pc")},
                                         {"coatroughness", constant(coatRoughness * coatRoughness, "pcr")},
                                         {"sheen", sheen}});
    }

    /// A number in [0, 1], times its map; without a number, the map alone.
    Input portion(const std::string& keyword, const std::string& map) {
        const double value = mtl_.number(keyword).value_or(mtl_.has(map) ? 1 : 0);
        const auto image = value > 0 ? texture(map, true, value) : std::nullopt;
        return image ? *image : constant(value, keyword);
    }

    /// Microfacet widths are the square of the roughness, stretched by aniso: Burley 2012.
    Widths roughness() {
        const double pr = mtl_.number("pr").value_or(mtl_.has("map_pr") ? 1 : 0.5);
        if (auto map = texture("map_pr", true, pr)) {
            const Input width = product(*map, *map, true);
            return {width, width};
        }
        const double aspect = std::sqrt(1 - 0.9 * mtl_.number("aniso").value_or(0));
        return {constant(pr * pr / aspect, "pr"), constant(pr * pr * aspect, "pr")};
    }

    // ---- bump and normal maps, opacity, light -------------------------------------------------------------------------------

    /// Many exporters write a normal map as map_Bump. Recognises one by its colours, which are bluish on average.
    static bool isNormalMap(const ImageData& image) {
        if (image.channels < 3) return false;
        glm::dvec3 sum(0);
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) sum += glm::dvec3(image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2));
        const glm::dvec3 average = sum / (double(image.width) * image.height);
        return std::abs(average.x - 0.5) < 0.15 && std::abs(average.y - 0.5) < 0.15 && average.z > 0.7;
    }

    void addBumpOrNormalMap(int material) {
        if (auto normals = image("norm", ColorEncoding::linear)) setNormalMap(material, normals->second);
        for (const char* keyword : {"map_bump", "bump", "map_disp", "disp"}) {
            const auto found = image(keyword, ColorEncoding::linear);
            if (!found) continue;
            if (isNormalMap(*loadImage(found->second))) {
                setNormalMap(material, found->second);
                return;
            }
            if (std::string(keyword).find("disp") != std::string::npos)
                diagnostics_.unsupported("mtl disp", found->first.where,
                                         fmt::format("\"{}\" is rendered as a bump map", mtl_.asWritten(keyword)));
            constexpr double heightOfWhite = 0.02;
            setDisplacement(material, texture(keyword, true, heightOfWhite * textureSize_ * found->first.bumpMultiplier)->texture);
            return;
        }
    }

    /// Applies bump and normal maps to the surface, or to both parts of a mix.
    template <class Set> void onSurfaces(int material, const Set& set) {
        Material& target = scene_.materials[static_cast<std::size_t>(material)];
        set(target);
        if (target.kind == &mix_material)
            for (const int part : target.mixed) onSurfaces(part, set);
    }
    void setNormalMap(int material, const ImageFile& file) {
        const int image = addImage(scene_, file);
        onSurfaces(material, [&](Material& target) { target.normalMap = image; });
    }
    void setDisplacement(int material, int texture) {
        onSurfaces(material, [&](Material& target) { target.displacement = texture; });
    }

    /// d, or 1 - Tr if there is no d.
    double dissolve() const {
        if (const auto d = mtl_.number("d")) return *d;
        return 1 - mtl_.number("tr").value_or(0);
    }

    Input opacity() {
        if (isRefractive()) return constant(1, "d");
        const std::string keyword = mtl_.has("d") ? "d" : "tr";
        // Exporters write d = 0 next to a map to mean the map alone.
        const double d = mtl_.has("map_d") && dissolve() == 0 ? 1 : dissolve();
        const auto map = texture("map_d", true, d);
        return map ? *map : constant(d, keyword);
    }

    int light() {
        const glm::dvec3 Le = mtl_.color("ke").value_or(glm::dvec3(mtl_.has("map_ke") ? 1 : 0));
        AreaLight light;
        if (const auto map = maximum(Le) > 0 ? image("map_ke", ColorEncoding::automatic) : std::nullopt) {
            const auto& [options, file] = *map;
            light.image = addImage(scene_, file);
            light.imageMapping = {
                .uScale = options.scale.x, .vScale = options.scale.y, .uOffset = options.offset.x, .vOffset = options.offset.y};
            if (options.base != 0 || options.gain != 1)
                diagnostics_.unsupported("mtl map_ke -mm", options.where, "the option \"-mm\" of \"map_Ke\" is not supported");
        }
        if (maximum(Le) <= 0) return none;
        light.L = Spectrum::rgb(Le);
        light.where = mtl_.whereIs("ke");
        light.group = mtl_.name;
        std::ranges::replace_if(light.group, [](unsigned char c) { return !std::isalnum(c) && c != '-'; }, '_');
        scene_.areaLights.push_back(std::move(light));
        return static_cast<int>(scene_.areaLights.size()) - 1;
    }

    void reportUnknown() {
        static const std::set<std::string> known{"ka",       "kd",    "ks",        "ke",     "ns",       "ni",     "tf",     "d",
                                                 "tr",       "illum", "sharpness", "map_ka", "map_kd",   "map_ks", "map_ke", "map_d",
                                                 "map_bump", "bump",  "norm",      "disp",   "map_disp", "pr",     "pm",     "ps",
                                                 "pc",       "pcr",   "aniso",     "anisor", "map_pr",   "map_pm", "map_ps", "map_aat"};
        for (const auto& [keyword, statement] : mtl_.statements)
            if (!known.contains(keyword))
                diagnostics_.unsupported("mtl " + keyword, statement.where, fmt::format("\"{}\" is not supported", statement.keyword));
    }

    double textureSize_;
};

}  // namespace

ObjMaterial addMaterial(Scene& scene, const MtlMaterial& mtl, double textureSize, ObjFiles& files, Diagnostics& diagnostics) {
    const MtlMaterial meant = withinRanges(mtl, diagnostics);
    return Builder(scene, meant, textureSize, files, diagnostics).build();
}

ObjMaterial addDefaultMaterial(Scene& scene) {
    Material material;
    material.kind = &diffuse_material;
    material.inputs = {{"reflectance", {Spectrum::constant(0.5)}}};
    scene.materials.push_back(std::move(material));
    return {.material = static_cast<int>(scene.materials.size()) - 1};
}

}  // namespace eikonal
