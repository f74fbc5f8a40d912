// A measured BSDF of the RGL database.

#include "kinds/material_packing.h"
#include "kinds/material_reading.h"

namespace eikonal {

static const MaterialDirective directives[] = {
    {"measured", "file filename -> -"},
};

static void read(const pbrt::MaterialReading& in, Material& material) {
    const pbrt::Arguments& arguments = in.arguments;
    const std::optional<std::string> path = arguments.file("filename");
    if (!path && !arguments.has("filename"))
        throw SceneError(arguments.where(), "material \"measured\" needs a \"string filename\": a .bsdf file of the RGL material database");
    material.file = path.value_or("");  // if missing, that is already noted
    material.where = arguments.whereOf("filename");
}

static next_queue pack(InputWriter& in) {
    in.file(slot_measured::file);
    in.require(Feature::ANISOTROPY);
    return next_measured;
}

const MaterialKind measured_material{.directives = directives, .read = read, .pack = pack};

}  // namespace eikonal
