#include "read/obj/mtl_inputs.h"

#include "kinds/texture_kind.h"
#include "read/formats/image.h"

#include <fmt/format.h>

#include <algorithm>

namespace eikonal {

Input MtlInputs::addTexture(Texture texture) {
    texture.where = texture.where.file ? texture.where : mtl_.where;
    scene_.textures.push_back(std::move(texture));
    return {Spectrum::constant(0), static_cast<int>(scene_.textures.size()) - 1, scene_.textures.back().where};
}

Input MtlInputs::product(const Input& a, const Input& b, bool isFloat) {
    return addTexture({.kind = &kindOf(kind_scale_texture), .name = {}, .isFloat = isFloat, .where = a.where, .operands = {a, b}});
}

std::optional<std::pair<MtlTexture, ImageFile>> MtlInputs::image(const std::string& keyword, ColorEncoding encoding) {
    auto texture = mtl_.texture(keyword);
    if (!texture) return {};
    for (const auto& [option, where] : texture->ignored)
        diagnostics_.unsupported("mtl " + option.substr(0, option.find(' ')), where,
                                 fmt::format("the option \"{}\" is not supported", option));
    const std::string path = files_.allowsMissing() ? files_.find(texture->file, texture->where)
                                                    : files_.require(texture->file, texture->where);
    ImageFile file{.path = path, .encoding = encoding};
    if (path.empty()) {
        if (!files_.allowsMissing()) return {};
        /* Numbers, as of bumps, have no colour that would be seen */
        const bool isColor = encoding == ColorEncoding::automatic;
        diagnostics_.warnOnce("missing file " + texture->file, texture->where,
                              fmt::format("there is no image \"{}\"; {}", texture->file,
                                          isColor ? "the texture is magenta" : "the map is left out"));
        if (!isColor) return {};
        file = magentaImage(texture->file);
    }
    usesUvs_ = true;
    file.wrap = texture->clamp ? wrap_clamp : wrap_repeat;
    file.where = texture->where;
    return std::pair{std::move(*texture), std::move(file)};
}

std::optional<Input> MtlInputs::texture(const std::string& keyword, bool isFloat, double factor) {
    auto found = image(keyword, isFloat ? ColorEncoding::linear : ColorEncoding::automatic);
    if (!found) return {};
    const auto& [options, file] = *found;
    const Mapping mapping{.uScale = options.scale.x, .vScale = options.scale.y, .uOffset = options.offset.x, .vOffset = options.offset.y};
    const auto add = [&](double scale) {
        return addTexture({.kind = &kindOf(kind_imagemap_texture), .name = file.path, .isFloat = isFloat, .where = options.where,
                           .mapping = mapping, .scale = scale, .image = addImage(scene_, file)});
    };
    if (options.base == 0) return add(factor * options.gain);
    // base at 0, base + gain at 1.
    const Input low = constant(factor * options.base, keyword), high = constant(factor * (options.base + options.gain), keyword);
    return addTexture({.kind = &kindOf(kind_mix_texture), .name = file.path, .isFloat = isFloat, .where = options.where,
                       .operands = {low, high, add(1)}});
}

}  // namespace eikonal
