// Absorption of hair from its colour and azimuthal roughness; made for the material "hair".

#include "kinds/texture_kind.h"

namespace eikonal {

const TextureTraits absorption_texture{.types = TextureTypes::none};

}  // namespace eikonal
