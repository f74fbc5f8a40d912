// A dielectric boundary around a scattering body, rendered by random walks or by a diffusion profile.

#include "kinds/material_packing.h"
#include "kinds/material_reading.h"
#include "read/pbrt/subsurface.h"

namespace eikonal {

static const MaterialDirective directives[] = {
    {"subsurface",
     "floatmap uroughness | roughness = 0 clamped to [0, inf); floatmap vroughness | roughness = 0 clamped to [0, inf); index eta = 1.33 "
     "in [0, inf);"
     "string name -> -; spectrummap sigma_a -> -; spectrummap sigma_s -> -; colormap reflectance -> -; spectrummap mfp -> -;"
     "string method = diffusion in {diffusion, randomwalk} -> -; float scale = 1 in [0, inf) -> -; float g = 0 clamped to [-0.9999, "
     "0.9999] -> -;"
     "bool energycompensation = false -> -; bool remaproughness = true -> -"},
};

static void read(const pbrt::MaterialReading& in, Material& material) {
    pbrt::readEnergyCompensation(in, material);
    pbrt::readInterior(in.reading, in.arguments, material, in.textures);
}

static next_queue pack(InputWriter& in) { return dielectric_material.pack(in); }

const MaterialKind subsurface_material{.directives = directives, .read = read, .pack = pack, .hasMethods = true};

}  // namespace eikonal
