// The physically based material of MTL files; not in pbrt. Inputs: base metallic eta uroughness vroughness coat coatroughness sheen.

#include "kinds/material_packing.h"

namespace eikonal {

static next_queue pack(InputWriter& in) {
    in.spectrum(slot_principled::base, "base");
    in.number(slot_principled::metallic, "metallic");
    in.number(slot_principled::eta, "eta");
    in.widths(slot_principled::alpha_x, slot_principled::alpha_y);
    in.number(slot_principled::coat, "coat");
    in.width(slot_principled::coat_alpha, "coatroughness");
    in.number(slot_principled::sheen, "sheen");
    return next_principled;
}

const MaterialKind principled_material{.pack = pack};

}  // namespace eikonal
