// Homogeneous medium (kernels/medium/homogeneous.clh).

#include "kinds/medium_packing.h"
#include "kinds/medium_reading.h"
#include "read/pbrt/medium_presets.h"

namespace eikonal {

/// Reads the coefficients of a preset, or those that are given.
static void readPresetOrCoefficients(const pbrt::MediumReading& in, Medium& medium) {
    const std::string preset = in.arguments.text("preset");
    if (const pbrt::MediumPreset* measured = pbrt::mediumPreset(preset)) {
        medium.sigmaA = Spectrum::rgb(measured->sigmaA);
        medium.sigmaS = Spectrum::rgb(measured->reducedSigmaS);
        return;
    }
    readCoefficients(in.arguments, medium);
    if (preset.empty()) return;
    const std::string near = nearestWord(preset, pbrt::mediumPresetNames());
    in.reading.unsupported("preset " + preset, in.arguments.whereOf("preset"),
                           "there is no preset \"" + preset + "\"" + (near.empty() ? "" : "; did you mean \"" + near + "\"?") +
                               " (sigma_a and sigma_s are used instead)");
}

static bool read(const pbrt::MediumReading& in, Medium& medium) {
    readPresetOrCoefficients(in, medium);
    pbrt::scaleCoefficients(medium, in.arguments.number("scale"));
    medium.Le = in.arguments.spectrum("Le") * in.arguments.number("Lescale");
    return true;
}

static MediumEmission emission(const Medium& d) {
    return d.Le.illuminant() != glm::dvec3(0) ? MediumEmission::spectrum : MediumEmission::none;
}

const MediumTraits homogeneous_medium{
    .parameters = {"string preset", pbrt::coefficientParameters,
                   "float scale = 1 in [0, inf); spectrum Le = 0; float Lescale = 1 in [0, inf)", pbrt::phaseParameters},
    .read = read, .pack = newMedium, .emission = emission};

}  // namespace eikonal
