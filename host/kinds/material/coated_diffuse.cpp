// A diffuse surface under a dielectric coat, with a medium in between (Pharr et al. 2023, section 14.3).

#include "kinds/material_packing.h"

namespace eikonal {

static const MaterialDirective directives[] = {
    {"coateddiffuse",
     "colormap reflectance = 0.5; floatmap uroughness | roughness = 0 clamped to [0, inf); floatmap vroughness | roughness = 0 clamped to "
     "[0, inf);"
     "floatmap thickness = 0.01 clamped to [0, inf);"
     "index eta = 1.5 in [0, inf); floatmap g = 0 clamped to [-1, 1]; colormap albedo = 0; integer maxdepth = 10 clamped to [0, inf);"
     "integer nsamples = 1 in [1, inf); bool remaproughness = true -> -"},
};

static next_queue pack(InputWriter& in) {
    in.spectrum(slot_coated_diffuse::reflectance, "reflectance");
    in.index(slot_coated_diffuse::eta, "eta");
    in.widths(slot_coated_diffuse::alpha_x, slot_coated_diffuse::alpha_y);
    in.number(slot_coated_diffuse::thickness, "thickness");
    in.layerMedium(slot_coated_diffuse::albedo);
    in.number(slot_coated_diffuse::g, "g");
    in.count(slot_coated_diffuse::max_depth, "maxdepth");
    in.count(slot_coated_diffuse::samples, "nsamples");
    in.vertexKey(slot_coated_diffuse::key);
    return next_coated_diffuse;
}

const MaterialKind coated_diffuse_material{.directives = directives, .pack = pack};

}  // namespace eikonal
