#pragma once
// What the host knows of each kind of texture: one file of host/kinds/texture/ for each line of TEXTURES (include/eikonal/textures.h).

#include "eikonal/textures.h"
#include "feature_set.h"

#include <span>

namespace eikonal {

struct Texture;
struct TexturePacking;
namespace pbrt { struct TextureReading; }

/// Which textures of a scene may be of a kind.
enum class TextureTypes { floatAndSpectrum, floatOnly, spectrumOnly, none /* the program alone makes them */ };

/// What a kind's file defines.
struct TextureTraits {
    TextureTypes types = TextureTypes::floatAndSpectrum;
    /// The parameters of a `Texture "name" "type" "kind"`: a row of read/pbrt/kinds.h, in parts. The type "map" stands for a value or
    /// texture of the texture's own type, "value" for a value of that type.
    const char* parameters[3] = {};
    /// Reads the operands and the fields that the kind uses; name, type and worldFromTexture are filled in. Returns false for a texture to
    /// be left out, since its file is missing, which has been noted. Throws SceneError.
    bool (*read)(const pbrt::TextureReading&, Texture&) = nullptr;

    /// Fills in the instruction, but its kind. Null: there is nothing more to say.
    void (*pack)(TexturePacking&, const Texture&, texture_instruction&) = nullptr;
    /// Whether its operands are coefficients, which may be greater than 1, and its values other quantities.
    bool takesCoefficients = false;
    /// Whether its value is its operand, so that it takes no instruction.
    bool isItsOperand = false;
};

/* Each kind's file defines one of them. */
#define DECLARE_KIND(name, FEATURE, OPERANDS) extern const TextureTraits name##_texture;
TEXTURES(DECLARE_KIND)
#undef DECLARE_KIND

/// A line of TEXTURES.
struct TextureKind {
    const char* name;
    texture_kind value;
    Feature feature;
    int operands;
    const TextureTraits& traits;
};

/// All kinds, by texture_kind, without TEXTURE_OPERATIONS.
std::span<const TextureKind> textureKindList();
inline const TextureKind& kindOf(texture_kind kind) { return textureKindList()[kind]; }

}  // namespace eikonal
