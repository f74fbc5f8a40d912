// Hair (Chiang et al. 2016). h in [-1, 1] is the position across the fiber.

#include "kinds/material_packing.h"
#include "kinds/material_reading.h"
#include "read/pbrt/hair.h"

namespace eikonal {

static const MaterialDirective directives[] = {
    {"hair",
     "spectrummap sigma_a; colormap reflectance | color -> -; floatmap eumelanin = 0 clamped to [0, inf) -> -;"
     "floatmap pheomelanin = 0 clamped to [0, inf) -> -; floatmap eta = 1.55 in (0, inf);"
     "floatmap beta_m = 0.3 clamped to [0, 1]; floatmap beta_n = 0.3 clamped to [0, 1]; floatmap alpha = 2"},
};

static void read(const pbrt::MaterialReading& in, Material& material) { pbrt::readHair(in.reading, in.textures, in.arguments, material); }

static next_queue pack(InputWriter& in) {
    in.transmit();
    in.coefficient(slot_hair::sigma_a, "sigma_a");
    in.number(slot_hair::h, "h");
    in.number(slot_hair::eta, "eta");
    in.number(slot_hair::beta_m, "beta_m");
    in.number(slot_hair::beta_n, "beta_n");
    in.number(slot_hair::scale_tilt, "alpha");
    in.require(Feature::ANISOTROPY);
    return next_hair;
}

const MaterialKind hair_material{.directives = directives, .read = read, .pack = pack};

}  // namespace eikonal
