#include "read/pbrt/subsurface.h"

#include "eikonal/formulas.h"
#include "kinds/texture_kind.h"
#include "color/diffuse_albedo.h"
#include "kinds/medium_kind.h"
#include "image/image_data.h"
#include "read/pbrt/medium_presets.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>

namespace eikonal::pbrt {

/// Diffuse albedos for a phase function and an index, as a table and as an image of one row.
struct AlbedoTable {
    DiffuseAlbedoTable table;
    std::shared_ptr<const ImageData> row;
};

namespace {

const AlbedoTable& albedoTable(Reading& reading, double g, double eta) {
    std::shared_ptr<const AlbedoTable>& kept = reading.albedoTables[{g, eta}];
    if (kept) return *kept;
    const DiffuseAlbedoTable table(g, eta);
    auto row = std::make_shared<ImageData>();
    row->width = static_cast<int>(table.albedos().size());
    row->height = 1;
    row->floats.assign(table.albedos().begin(), table.albedos().end());
    kept = std::make_shared<AlbedoTable>(AlbedoTable{table, row});
    return *kept;
}

void warnOfIgnored(Reading& reading, const Arguments& arguments, std::initializer_list<const char*> names, const std::string& since) {
    for (const char* name : names)
        if (arguments.has(name))
            reading.diagnostics.warn(arguments.whereOf(name), "\"" + std::string(name) + "\" is ignored, since there is " + since);
}

DiffusionProfile profileOf(const Spectrum& albedo, const Medium& medium, double eta) {
    const Spectrum reduced = combineSpectra([&](double s, double a) { return a + s * (1 - medium.g); }, medium.sigmaS, medium.sigmaA);
    const double stretch = std::max(eta * eta, 1.0) - 1;
    const auto length = [&](double A, double sigma) {
        return profile_length(1 / std::max(sigma, 1e-9), std::clamp(A, 0.0, 1.0), stretch);
    };
    return {albedo, combineSpectra(length, albedo, reduced)};
}

/// The profile of a body with given coefficients. Spectral rendering converts colours to spectra first, as pbrt-v4 does, because albedo is
/// far from linear in the coefficients.
DiffusionProfile profileOf(Medium medium, const DiffuseAlbedoTable& table, double eta) {
    const auto profile = [&] {
        const auto diffuse = [&](double s, double a) { return table.diffuse(s / std::max(s + a, 1e-30)); };
        return profileOf(combineSpectra(diffuse, medium.sigmaS, medium.sigmaA), medium, eta);
    };
    DiffusionProfile result = profile();
    if (medium.sigmaA.kind() != Spectrum::Kind::rgb || medium.sigmaS.kind() != Spectrum::Kind::rgb ||
        (medium.sigmaA.isFlat() && medium.sigmaS.isFlat()))
        return result;
    medium.sigmaA = Spectrum::sampled(medium.sigmaA.dense());
    medium.sigmaS = Spectrum::sampled(medium.sigmaS.dense());
    result.atWavelengths = std::make_shared<DiffusionProfile>(profile());
    return result;
}

/// The profile of a body whose albedo or mean free path is a texture. The mean free path is reduced with the scattering of an albedo of
/// 0.5.
DiffusionProfile texturedProfile(const Input& albedo, const Input& path, const DiffuseAlbedoTable& table, double g, double scale) {
    const double reduced = 1 - g * table.singleScattering(0.5);
    return {albedo.texture == none ? albedo.value : Spectrum::constant(1),
            (path.texture == none ? path.value : Spectrum::constant(1)) * (scale / reduced), albedo.texture, path.texture};
}

/// The profile of a body whose coefficients are textures.
DiffusionProfile texturedProfile(TextureRegistry& textures, const Input& sigmaA, const Input& sigmaS, const AlbedoTable& albedos,
                                 double g) {
    const SourceLocation& where = (sigmaA.texture == none ? sigmaS : sigmaA).where;
    Texture albedo{.kind = &kindOf(kind_diffusealbedo_texture), .where = where, .operands = {sigmaA, sigmaS}, .g = g}, path = albedo;
    albedo.image = textures.image({.path = {}, .pixels = albedos.row, .where = where});
    path.kind = &kindOf(kind_freepath_texture);
    const int albedoTexture = textures.derive(albedo).texture;
    return {Spectrum::constant(1), Spectrum::constant(1), albedoTexture, textures.derive(path).texture};
}

}  // namespace

void readInterior(Reading& reading, const Arguments& arguments, Material& material, TextureRegistry& textures) {
    const double eta = material.inputs.at("eta").value.value();
    for (const auto& [name, method] : subsurfaceMethodNames)
        if (arguments.text("method") == name) material.method = method;

    std::optional<Spectrum> albedo;
    auto medium = std::make_shared<Medium>();
    medium->kind = &kindOf(kind_homogeneous_medium);
    medium->where = arguments.where();
    medium->g = arguments.number("g");
    const double scale = arguments.number("scale");
    const bool hasA = arguments.has("sigma_a"), hasS = arguments.has("sigma_s");
    if (const std::string name = arguments.text("name"); !name.empty()) {
        const MediumPreset* measured = mediumPreset(name);
        if (!measured) {
            const std::string near = nearestWord(name, mediumPresetNames());
            throw SceneError(arguments.whereOf("name"),
                             "there is no substance \"" + name + "\"" + (near.empty() ? "" : "; did you mean \"" + near + "\"?"));
        }
        warnOfIgnored(reading, arguments, {"sigma_a", "sigma_s", "reflectance", "mfp"}, "a \"name\"");
        if (medium->g != 0) warnOfIgnored(reading, arguments, {"g"}, "a \"name\", whose substance has reduced scattering coefficients");
        medium->g = 0;
        medium->sigmaA = Spectrum::rgb(measured->sigmaA) * scale;
        medium->sigmaS = Spectrum::rgb(measured->reducedSigmaS) * scale;
    } else if (hasA || hasS) {
        if (!hasA || !hasS)
            throw SceneError(
                arguments.whereOf(hasA ? "sigma_a" : "sigma_s"),
                std::string("\"") + (hasA ? "sigma_a" : "sigma_s") + "\" needs a \"" + (hasA ? "sigma_s" : "sigma_a") + "\" as well");
        warnOfIgnored(reading, arguments, {"reflectance", "mfp"}, "a \"sigma_a\"");
        const Input sigmaA = textures.scaled(textures.input(arguments, "sigma_a"), scale),
                    sigmaS = textures.scaled(textures.input(arguments, "sigma_s"), scale);
        if (sigmaA.texture != none || sigmaS.texture != none) {
            material.diffusion = std::make_shared<DiffusionProfile>(
                texturedProfile(textures, sigmaA, sigmaS, albedoTable(reading, medium->g, eta), medium->g));
            return;
        }
        medium->sigmaA = sigmaA.value;
        medium->sigmaS = sigmaS.value;
    } else if (arguments.has("reflectance")) {
        const Input reflectance = textures.input(arguments, "reflectance"), mfp = textures.input(arguments, "mfp", Spectrum::constant(1));
        const DiffuseAlbedoTable& table = albedoTable(reading, medium->g, eta).table;
        if (reflectance.texture != none || mfp.texture != none) {
            material.diffusion = std::make_shared<DiffusionProfile>(texturedProfile(reflectance, mfp, table, medium->g, scale));
            return;
        }
        /* The share rho of 1 / mfp is scattering, the rest absorption */
        const auto all = [&](double length) { return 1 / std::max(length * scale, 1e-9); };
        albedo = reflectance.value;
        const auto absorbed = [&](double A, double length) { return (1 - table.singleScattering(A)) * all(length); };
        const auto scattered = [&](double A, double length) { return table.singleScattering(A) * all(length); };
        medium->sigmaA = combineSpectra(absorbed, *albedo, mfp.value);
        medium->sigmaS = combineSpectra(scattered, *albedo, mfp.value);
    } else {
        warnOfIgnored(reading, arguments, {"mfp"}, "no \"reflectance\"");
        medium->sigmaA = Spectrum::rgb({0.0011, 0.0024, 0.014}) * scale;   // pbrt-v4's default: whole milk
        medium->sigmaS = Spectrum::rgb({2.55, 3.21, 3.77}) * scale;
    }
    material.interior = medium;
    material.diffusion = std::make_shared<DiffusionProfile>(albedo ? profileOf(*albedo, *medium, eta)
                                                                   : profileOf(*medium, albedoTable(reading, medium->g, eta).table, eta));
}

}  // namespace eikonal::pbrt
