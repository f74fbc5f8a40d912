// Diffuse reflection and diffuse transmission.

#include "kinds/material_packing.h"
#include "kinds/material_reading.h"

namespace eikonal {

static const MaterialDirective directives[] = {
    {"diffusetransmission", "colormap reflectance = 0.25; colormap transmittance = 0.25; float scale = 1 clamped to [0, inf) -> -"},
};

static void read(const pbrt::MaterialReading& in, Material& material) {
    const double scale = in.arguments.number("scale");
    for (auto& [name, input] : material.inputs) input = in.textures.scaled(input, scale);
}

static next_queue pack(InputWriter& in) {
    in.transmit();
    in.spectrum(slot_diffuse_transmission::reflectance, "reflectance");
    in.spectrum(slot_diffuse_transmission::transmittance, "transmittance");
    return next_diffuse_transmission;
}

const MaterialKind diffuse_transmission_material{.directives = directives, .read = read, .pack = pack};

}  // namespace eikonal
