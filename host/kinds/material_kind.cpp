#include "kinds/material_kind.h"

namespace eikonal {

std::span<const MaterialKind* const> materialKindList() {
#define ADD_ENTRY(name) &name##_material,
    static constexpr const MaterialKind* entries[] = {MATERIALS(ADD_ENTRY)};
#undef ADD_ENTRY
    return entries;
}

}  // namespace eikonal
