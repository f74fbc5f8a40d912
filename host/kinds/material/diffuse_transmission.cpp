// Diffuse reflection and diffuse transmission.

#include "kinds/material_packing.h"
#include "kinds/material_reading.h"

#include <functional>

namespace eikonal {

static const MaterialDirective directives[] = {
    {"diffusetransmission", "colormap reflectance = 0.25; colormap transmittance = 0.25; float scale = 1 clamped to [0, inf) -> -"},
};

static void read(const pbrt::MaterialReading& in, Material& material) {
    const double scale = in.arguments.number("scale");
    for (auto& [name, input] : material.inputs) input = in.textures.scaled(input, scale);
    const Input &reflectance = material.inputs.at("reflectance"), &transmittance = material.inputs.at("transmittance");
    if (reflectance.texture != none || transmittance.texture != none) return;
    const Spectrum sum = combineSpectra(std::plus<>(), reflectance.value.clampedToUnit(), transmittance.value.clampedToUnit());
    constexpr double withinRounding = 1 - 1e-3;  // spectra that add up to 1 may have an sRGB a little above
    if (!(sum * withinRounding).isReflectance())
        in.reading.diagnostics.warn(in.arguments.where(), "\"reflectance\" and \"transmittance\" add up to more than 1: as in pbrt-v4, the "
                                                          "material sends out more light than it receives");
}

static next_queue pack(InputWriter& in) {
    in.transmit();
    in.spectrum(slot_diffuse_transmission::reflectance, "reflectance");
    in.spectrum(slot_diffuse_transmission::transmittance, "transmittance");
    return next_diffuse_transmission;
}

const MaterialKind diffuse_transmission_material{.directives = directives, .read = read, .pack = pack};

}  // namespace eikonal
