#pragma once
// Textures made by hand, and their values on the device.

#include "eikonal/textures.h"
#include "device_function.h"
#include "pack/colors.h"

#include <vector>

namespace eikonal {

struct TextureResult { spectrum value; vec3 bumped, mapped, leaning; };

/// Values of programs at points: program[i] at uv[i], p[i]; and the plane z = 0 with dpdu = 2 x, dpdv = 3 y bumped by the program,
/// and turned by the normal map in image 0. leaning: bumped where the interpolated normal is (0.6, 0, 0.8).
std::vector<TextureResult> evaluate(const PackedScene& scene, const std::vector<uint>& program, const std::vector<vec2>& uv,
                                    const std::vector<vec3>& p);

/// Tables of textures, filled by hand.
struct Textures {
    PackedScene scene;
    Textures() { scene.tables.frame.resize(1); }

    uint program(std::vector<texture_instruction> code, float bumpStepUv = 0.0005f, float bumpStep = 1e30f) {
        SceneTables& t = scene.tables;
        t.programs.push_back({static_cast<uint>(t.instructions.size()), static_cast<uint>(code.size()), bumpStepUv, bumpStep});
        t.instructions.insert(t.instructions.end(), code.begin(), code.end());
        return static_cast<uint>(t.programs.size() - 1);
    }
    static texture_instruction instruction(texture_kind kind, float value = 1) {
        texture_instruction i{};
        i.kind = kind;
        i.mapping = mapping_uv;
        i.image = NONE;
        i.value = packNumber(value);
        i.texture_from_scene.xx = i.texture_from_scene.yy = i.texture_from_scene.zz = 1;
        return i;
    }
    static texture_instruction constant(spectrum s) {
        texture_instruction i = instruction(kind_constant_texture);
        i.value = packRgb({s.r, s.g, s.b});
        return i;
    }
    texture_instruction lookup(uint image) { texture_instruction i = instruction(kind_imagemap_texture); i.image = image; return i; }

    /// An image of given texels (in [0, 1]; 8-bit formats keep 255 levels), channels interleaved.
    uint image(uint width, uint height, uint channels, image_format format, image_wrap wrap, image_filter filter,
               const std::vector<float>& texels);
};

}  // namespace eikonal
