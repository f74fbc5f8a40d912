// One of two materials, chosen at random; `amount` is the probability of the second.

#include "kinds/material_packing.h"
#include "kinds/material_reading.h"

namespace eikonal {

static const MaterialDirective directives[] = {
    {"mix", "strings materials -> -; floatmap amount = 0.5 clamped to [0, 1]"},
};

static void read(const pbrt::MaterialReading& in, Material& material) {
    const std::vector<std::string> names = in.arguments.texts("materials");
    const SourceLocation& where = in.arguments.whereOf("materials");
    if (names.size() != 2) throw SceneError(where, "material \"mix\" needs the names of two materials in \"string materials\"");
    for (int i = 0; i < 2; ++i) {
        material.mixed[i] = in.materials.named(names[i], where);
        if (material.mixed[i] != none && in.reading.scene.materials[material.mixed[i]].kind == &interface_material)
            throw SceneError(where, "\"" + names[i] + "\" is an interface, which cannot be part of a mix");
    }
}

static next_queue pack(InputWriter&) { return next_mix; }

const MaterialKind mix_material{.directives = directives, .read = read, .pack = pack, .isSurface = false};

}  // namespace eikonal
