#include "scene/pbrt/subsurface.h"

#include "scene/diffuse_albedo.h"
#include "scene/pbrt/medium_presets.h"

#include <algorithm>
#include <initializer_list>

namespace eikonal::pbrt {
namespace {

void warnOfIgnored(Reading& reading, const Arguments& arguments, std::initializer_list<const char*> names, const std::string& since) {
    for (const char* name : names)
        if (arguments.has(name)) reading.diagnostics.warn(arguments.whereOf(name), "\"" + std::string(name) + "\" is ignored, since there is " + since);
}

/// Reflectance and mean free path to coefficients: rho / mfp scatters, the rest of 1 / mfp absorbs. Colours by their channels, spectra by wavelengths.
void convert(const DiffuseAlbedoTable& table, const Spectrum& reflectance, const Spectrum& mfp, double scale, Medium& medium) {
    const auto scattering = [&](double r, double length) { return table.singleScattering(r) / std::max(length * scale, 1e-9); };
    const auto absorption = [&](double r, double length) { return (1 - table.singleScattering(r)) / std::max(length * scale, 1e-9); };
    if (reflectance.kind() == Spectrum::Kind::rgb && mfp.kind() == Spectrum::Kind::rgb) {
        const glm::dvec3 r = reflectance.albedo(), length = mfp.albedo();
        glm::dvec3 sigmaA, sigmaS;
        for (int c = 0; c < 3; ++c) {
            sigmaA[c] = absorption(r[c], length[c]);
            sigmaS[c] = scattering(r[c], length[c]);
        }
        medium.sigmaA = Spectrum::rgb(sigmaA);
        medium.sigmaS = Spectrum::rgb(sigmaS);
        return;
    }
    const DenseCurve r = reflectance.dense(), length = mfp.dense();
    SampledCurve sigmaA, sigmaS;
    for (size_t i = 0; i < r.size(); ++i) {
        const double wavelength = shortestWavelength + static_cast<double>(i);
        sigmaA.wavelengths.push_back(wavelength);
        sigmaS.wavelengths.push_back(wavelength);
        sigmaA.values.push_back(absorption(r[i], length[i]));
        sigmaS.values.push_back(scattering(r[i], length[i]));
    }
    medium.sigmaA = Spectrum::sampled(std::move(sigmaA));
    medium.sigmaS = Spectrum::sampled(std::move(sigmaS));
}

}  // namespace

std::shared_ptr<const Medium> interiorOf(Reading& reading, const Arguments& arguments, double eta) {
    auto medium = std::make_shared<Medium>();
    medium->where = arguments.where();
    medium->g = std::clamp(arguments.number("g"), -0.99, 0.99);
    const double scale = arguments.number("scale");
    const bool hasA = arguments.has("sigma_a"), hasS = arguments.has("sigma_s");
    if (const std::string name = arguments.text("name"); !name.empty()) {
        const MediumPreset* measured = mediumPreset(name);
        if (!measured) {
            const std::string near = nearestWord(name, mediumPresetNames());
            throw SceneError(arguments.whereOf("name"), "there is no substance \"" + name + "\"" + (near.empty() ? "" : "; did you mean \"" + near + "\"?"));
        }
        warnOfIgnored(reading, arguments, {"sigma_a", "sigma_s", "reflectance", "mfp"}, "a \"name\"");
        if (medium->g != 0) warnOfIgnored(reading, arguments, {"g"}, "a \"name\": what is known of substances is their reduced scattering");
        medium->g = 0;
        medium->sigmaA = Spectrum::rgb(measured->sigmaA) * scale;
        medium->sigmaS = Spectrum::rgb(measured->reducedSigmaS) * scale;
    } else if (hasA || hasS) {
        if (!hasA || !hasS)
            throw SceneError(arguments.whereOf(hasA ? "sigma_a" : "sigma_s"), std::string("\"") + (hasA ? "sigma_a" : "sigma_s") + "\" needs a \"" + (hasA ? "sigma_s" : "sigma_a") + "\" as well");
        warnOfIgnored(reading, arguments, {"reflectance", "mfp"}, "a \"sigma_a\"");
        medium->sigmaA = arguments.spectrum("sigma_a") * scale;
        medium->sigmaS = arguments.spectrum("sigma_s") * scale;
    } else if (arguments.has("reflectance")) {
        convert(DiffuseAlbedoTable(medium->g, eta), arguments.spectrum("reflectance"), arguments.spectrum("mfp", Spectrum::constant(1)), scale, *medium);
    } else {
        warnOfIgnored(reading, arguments, {"mfp"}, "no \"reflectance\"");
        medium->sigmaA = Spectrum::rgb({0.0011, 0.0024, 0.014}) * scale;   // pbrt-v4's default: whole milk
        medium->sigmaS = Spectrum::rgb({2.55, 3.21, 3.77}) * scale;
    }
    return medium;
}

}  // namespace eikonal::pbrt
