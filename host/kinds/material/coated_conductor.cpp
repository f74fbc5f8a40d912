// A conductor under a dielectric coat. The conductor's inputs begin with metal_.

#include "kinds/material_packing.h"

namespace eikonal {

static const MaterialDirective directives[] = {
    {"coatedconductor",
     "spectrummap conductor.eta = metal-Cu-eta -> metal_eta; spectrummap conductor.k = metal-Cu-k -> metal_k; colormap reflectance;"
     "floatmap conductor.uroughness | conductor.roughness = 0 clamped to [0, inf) -> metal_uroughness;"
     "floatmap conductor.vroughness | conductor.roughness = 0 clamped to [0, inf) -> metal_vroughness;"
     "floatmap interface.uroughness | interface.roughness = 0 clamped to [0, inf) -> uroughness;"
     "floatmap interface.vroughness | interface.roughness = 0 clamped to [0, inf) -> vroughness;"
     "index interface.eta = 1.5 in [0, inf) -> eta; floatmap thickness = 0.01 clamped to [0, inf); floatmap g = 0 clamped to [-1, 1]; "
     "colormap albedo = 0;"
     "integer maxdepth = 10 clamped to [0, inf); integer nsamples = 1 in [1, inf);"
     "bool remaproughness = true -> -"},
};

static next_queue pack(InputWriter& in) {
    const double index = in.get("eta").value.value();
    packMetal(in, slot_coated_conductor::metal_eta, slot_coated_conductor::metal_k, "metal_eta", "metal_k", index > 0 ? index : 1);
    in.widths(slot_coated_conductor::metal_alpha_x, slot_coated_conductor::metal_alpha_y, "metal_uroughness", "metal_vroughness");
    in.index(slot_coated_conductor::eta, "eta");
    in.widths(slot_coated_conductor::alpha_x, slot_coated_conductor::alpha_y);
    in.number(slot_coated_conductor::thickness, "thickness");
    in.layerMedium(slot_coated_conductor::albedo);
    in.number(slot_coated_conductor::g, "g");
    in.count(slot_coated_conductor::max_depth, "maxdepth");
    in.count(slot_coated_conductor::samples, "nsamples");
    in.vertexKey(slot_coated_conductor::key);
    return next_coated_conductor;
}

const MaterialKind coated_conductor_material{.directives = directives, .pack = pack, .metalIndices = {"metal_eta", "metal_k"}};

}  // namespace eikonal
