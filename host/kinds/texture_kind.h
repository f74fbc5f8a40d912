#pragma once
// The host's side of each kind of texture: one file in host/kinds/texture/ for each line of TEXTURES (include/eikonal/textures.h).

#include "color/color_set.h"
#include "eikonal/texture.h"
#include "eikonal/textures.h"
#include "feature_set.h"

#include <span>

namespace eikonal {

struct Texture;
struct TexturePacking;
namespace pbrt { struct TextureReading; }

/// The texture types that a scene may declare with a kind.
enum class TextureTypes { floatAndSpectrum, floatOnly, spectrumOnly, none /* only the program makes such textures */ };

/// What a kind's file defines.
struct TextureTraits {
    TextureTypes types = TextureTypes::floatAndSpectrum;
    /// The parameters of a `Texture "name" "type" "kind"`: a row of read/pbrt/kinds.h, in parts. The type "map" stands for a value or
    /// texture of the texture's own type, "value" for a value of that type.
    const char* parameters[3] = {};
    /// Reads the operands and the fields that the kind uses; name, type and worldFromTexture are already set. Returns false to skip a
    /// texture whose file is missing (already reported). Throws SceneError.
    bool (*read)(const pbrt::TextureReading&, Texture&) = nullptr;

    /// Fills in the fields of the instruction other than its kind. Null: there are none.
    void (*pack)(TexturePacking&, const Texture&, texture_instruction&) = nullptr;
    /// Whether its operands are scattering coefficients, which may exceed 1, and its values another quantity.
    bool takesCoefficients = false;
    /// Whether its value equals its operand, so that it needs no instruction.
    bool isItsOperand = false;
    /// The colours that it has, from those of its operands; for predictions (pack/scene_colors.h). Null: those of its operands.
    ColorSet (*colors)(const Texture&, std::span<const ColorSet> operands) = nullptr;
};

/* One for each kind, defined in the kind's file. */
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

/// All kinds, indexed by texture_kind, without TEXTURE_OPERATIONS.
std::span<const TextureKind> textureKindList();
inline const TextureKind& kindOf(texture_kind kind) { return textureKindList()[kind]; }

}  // namespace eikonal
