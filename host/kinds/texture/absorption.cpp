// Absorption of hair from its colour and azimuthal roughness. Only the material "hair" makes such textures.

#include "kinds/texture_kind.h"

namespace eikonal {

const TextureTraits absorption_texture{.types = TextureTypes::none};

}  // namespace eikonal
