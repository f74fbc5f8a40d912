// Null interface: only separates media.

#include "kinds/material_packing.h"

namespace eikonal {

static const MaterialDirective directives[] = {
    {"interface", ""},
    {"none", ""},
    {"", ""},
};

static next_queue pack(InputWriter& in) {
    in.beClear();
    return next_crossing;
}

const MaterialKind interface_material{.directives = directives, .pack = pack, .isSurface = false};

}  // namespace eikonal
