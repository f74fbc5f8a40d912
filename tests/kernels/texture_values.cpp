#include "texture_values.h"

#include "color/transfer.h"

#include <cmath>

namespace eikonal {

std::vector<TextureResult> evaluate(const PackedScene& scene, const std::vector<uint>& program, const std::vector<vec2>& uv,
                                    const std::vector<vec3>& p) {
    static const DeviceFunction<TextureResult> function(
        {.include = "texture/bump.clh",
         .type = "texture_result",
         .body = R"(
        texture_tables tables = BIND_TEXTURES;
        color_tables colors = BIND_COLORS;
        surface at;
        at.p = p; at.uv = uv;
        at.error = at.dndu = at.dndv = make_vec3(0.0f, 0.0f, 0.0f);
        at.ng = at.ns = make_vec3(0.0f, 0.0f, 1.0f);
        at.dpdu = make_vec3(2.0f, 0.0f, 0.0f);
        at.dpdv = make_vec3(0.0f, 3.0f, 0.0f);
        texture_point here = textured_point(at);
        result.value = eval_texture(tables, path_wavelengths(colors, 0u, 0u), program, &here);
        result.bumped = displace_normal(tables, program, at).ns;
        result.mapped = map_normal(tables, 0u, at).ns;
        at.ns = make_vec3(0.6f, 0.0f, 0.8f);
        result.leaning = displace_normal(tables, program, at).ns;)",
         .inputs = {"uint program", "vec2 uv", "vec3 p"},
         .declarations = "typedef struct { spectrum value; vec3 bumped, mapped, leaning; } texture_result;",
         .tables = "TEXTURE_TABLES(TABLE) COLOR_TABLES(TABLE)"});
    const DeviceScene onDevice(testContext(), scene);
    return function.with(onDevice, program, uv, p);
}

uint Textures::image(uint width, uint height, uint channels, image_format format, image_wrap wrap, image_filter filter,
                     const std::vector<float>& texels) {
    eikonal::image im{width, height, channels, static_cast<uint>(format), static_cast<uint>(wrap), static_cast<uint>(filter), 0};
    SceneTables& t = scene.tables;
    if (format == format_float) {
        im.first = static_cast<uint>(t.float_texels.size());
        t.float_texels.insert(t.float_texels.end(), texels.begin(), texels.end());
    } else {
        im.first = static_cast<uint>(t.byte_texels.size() * 4);
        t.byte_texels.resize(t.byte_texels.size() + (texels.size() + 3) / 4);
        for (size_t i = 0; i < texels.size(); ++i)
            t.byte_texels[im.first / 4 + i / 4] |= static_cast<uint>(std::lround(texels[i] * 255)) << (8 * (i % 4));
    }
    t.srgb_levels.assign(linearFromSrgbByte().begin(), linearFromSrgbByte().end());
    t.images.push_back(im);
    return static_cast<uint>(t.images.size() - 1);
}

}  // namespace eikonal
