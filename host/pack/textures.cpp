// Textures as programs, and the images that they read.

#include "pack/packer.h"

#include "color/luminance.h"
#include "overloaded.h"
#include "pack/colors.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <utility>

namespace eikonal {

static uint packBytes(Table<uint>& table, const std::vector<std::uint8_t>& bytes) {
    const size_t first = table.size() * 4;
    table.resize(table.size() + (bytes.size() + 3) / 4);
    if (!bytes.empty()) std::memcpy(reinterpret_cast<std::uint8_t*>(table.data()) + first, bytes.data(), bytes.size());
    return static_cast<uint>(first);
}

uint packImage(Packer& packer, int index, bool asFloat) {
    const auto [found, isNew] = packer.packedImages.try_emplace({index, asFloat}, 0);
    if (!isNew) return found->second;
    SceneTables& tables = packer.packed.tables;
    const ImageFile& file = packer.scene.images[static_cast<size_t>(index)];
    const ImageData& original = *packer.images[static_cast<size_t>(index)];
    const ImageData& data = asFloat && original.channels > 1 ? scalarImage(original) : original;

    image im{};
    im.width = static_cast<uint>(data.width);
    im.height = static_cast<uint>(data.height);
    im.channels = static_cast<uint>(data.channels);
    im.format = data.format == TexelFormat::srgb8 ? format_srgb8 : data.format == TexelFormat::linear8 ? format_linear8 : format_float;
    im.wrap = file.wrap == WrapMode::repeat  ? wrap_repeat
              : file.wrap == WrapMode::black ? wrap_black
              : file.wrap == WrapMode::clamp ? wrap_clamp
                                             : wrap_octahedral;
    im.filter = file.filter == FilterMode::nearest ? filter_nearest : filter_bilinear;
    if (data.format == TexelFormat::float32) {
        im.first = static_cast<uint>(tables.float_texels.size());
        tables.float_texels.insert(tables.float_texels.end(), data.floats.begin(), data.floats.end());
    } else im.first = packBytes(tables.byte_texels, data.bytes);
    if (im.format == format_srgb8 && tables.srgb_levels.empty()) tables.srgb_levels = srgbLevels();
    found->second = static_cast<uint>(tables.images.size());
    tables.images.push_back(im);
    return found->second;
}

/// Textures that are used twice are worked out twice, so a few of them can ask for more work than anyone can wait for.
constexpr size_t mostInstructions = 65536;

/// Makes the instructions of one program.
class ProgramWriter {
public:
    ProgramWriter(Packer& packer, bool isFloat) : packer_(packer), isFloat_(isFloat) {}

    void input(const Input& in) {
        if (in.texture != none) { texture(in.texture); return; }
        texture_instruction i = instruction(kind_constant_texture, Feature::TEXTURE_CONSTANT, in.where);
        const bool isNumber = isFloat_ || in.value.isConstant();
        i.value = isNumber     ? packConstant(packer_, in.value.value())
                  : unbounded_ ? packCoefficient(packer_, in.value)
                               : packReflectance(packer_, in.value);
        i.flags = isNumber ? static_cast<uint>(texture_number) : 0u;
        push(i);
        const glm::dvec3 value = isNumber ? glm::dvec3(in.value.value()) : in.value.albedo();
        if (std::min({value.x, value.y, value.z}) < 0 || std::max({value.x, value.y, value.z}) > 1) leavesUnit_ = true;
    }

    void texture(int index) { texture(packer_.scene.textures[static_cast<size_t>(index)]); }
    void texture(const Texture& t) {
        if (code_.size() > mostInstructions)
            throw SceneError(
                t.where,
                fmt::format("this texture is part of one that takes more than {} steps, where one that is used twice counts twice. "
                            "Make an image of what is used often.",
                            mostInstructions));
        const bool outer = isFloat_;
        isFloat_ = t.isFloat;
        std::visit(Overloaded{[&](const ConstantTexture& k) { input(k.value); }, [&](const ImagemapTexture& k) { imagemap(k, t); },
                              [&](const ScaleTexture& k) {
                                  input(k.texture);
                                  input(k.scale);
                                  pop(instruction(kind_scale_texture, Feature::TEXTURE_SCALE, t.where), 2);
                              },
                              [&](const MixTexture& k) {
                                  input(k.a);
                                  input(k.b);
                                  input(k.amount);
                                  pop(instruction(kind_mix_texture, Feature::TEXTURE_MIX, t.where), 3);
                              },
                              [&](const CheckerboardTexture& k) { checkerboard(k, t); },
                              [&](const AbsorptionTexture& k) {
                                  input(k.color);
                                  input(k.betaN);
                                  pop(instruction(kind_absorption_texture, Feature::TEXTURE_ABSORPTION, t.where), 2);
                              },
                              [&](const DiffuseAlbedoTexture& k) {
                                  texture_instruction i = instruction(kind_diffusealbedo_texture, Feature::TEXTURE_DIFFUSEALBEDO, t.where);
                                  i.image = packImage(packer_, k.albedos, false);
                                  ofCoefficients(k, i);
                              },
                              [&](const FreePathTexture& k) {
                                  ofCoefficients(k, instruction(kind_freepath_texture, Feature::TEXTURE_FREEPATH, t.where));
                              },
                              [&](const BilerpTexture& k) { bilerp(k, t); }, [&](const DotsTexture& k) { dots(k, t); },
                              [&](const DirectionMixTexture& k) { directionMix(k, t); }, [&](const NoiseTexture& k) { noise(k, t); }},
                   t.kind);
        isFloat_ = outer;
    }

    /// Colours of what follows are no reflectances: they may be larger than 1, and are made spectra as such. Returns whether they were
    /// before.
    bool setUnbounded(bool unbounded) { return std::exchange(unbounded_, unbounded); }

    void use(TextureUse use) {
        if (use == TextureUse::reflectance && leavesUnit_) pop(instruction(kind_clamp_texture, Feature::TEXTURE_CLAMP, {}), 1);
        if (use == TextureUse::roughness || use == TextureUse::regularRoughness)
            pop(instruction(kind_sqrt_texture, Feature::TEXTURE_SQRT, {}), 1);
        if (use == TextureUse::regularWidth || use == TextureUse::regularRoughness)
            pop(instruction(kind_regular_texture, Feature::TEXTURE_REGULAR, {}), 1);
        if (use == TextureUse::metal) pop(instruction(kind_metal_texture, Feature::TEXTURE_METAL, {}), 1);
        if (use == TextureUse::displacement && packer_.space.scale != 1) {
            input({Spectrum::constant(packer_.space.scale)});
            pop(instruction(kind_scale_texture, Feature::TEXTURE_SCALE, {}), 2);
        }
    }

    uint finish(const SourceLocation& where) {
        if (deepest_ > TEXTURE_STACK)
            throw SceneError(where, "this texture holds " + std::to_string(deepest_) + " values at once; at most " +
                                        std::to_string(TEXTURE_STACK) +
                                        " are possible. Nest mixes in their first input rather than in their last.");
        SceneTables& tables = packer_.packed.tables;
        tables.programs.push_back({static_cast<uint>(tables.instructions.size()), static_cast<uint>(code_.size())});
        tables.instructions.insert(tables.instructions.end(), code_.begin(), code_.end());
        return static_cast<uint>(tables.programs.size() - 1);
    }

private:
    static float f(double x) { return static_cast<float>(x); }

    texture_instruction instruction(texture_kind kind, Feature feature, const SourceLocation& where) {
        packer_.packed.require(feature, where.toString());
        texture_instruction i{};
        i.kind = kind;
        i.image = NONE;
        return i;
    }

    void push(const texture_instruction& i) {
        code_.push_back(i);
        deepest_ = std::max(deepest_, ++depth_);
    }
    void pop(const texture_instruction& i, int operands) {
        code_.push_back(i);
        depth_ -= operands - 1;
    }

    void map(texture_instruction& i, const Mapping& m) {
        const glm::dmat4 textureFromScene = glm::inverse(m.worldFromTexture) * packer_.space.worldFromScene();
        switch (m.kind) {
            case TextureMapping::uv:
                i.mapping = mapping_uv;
                i.texture_from_scene.xx = f(m.uScale); i.texture_from_scene.xw = f(m.uOffset);
                i.texture_from_scene.yy = f(m.vScale); i.texture_from_scene.yw = f(m.vOffset);
                return;
            case TextureMapping::spherical: i.mapping = mapping_spherical; i.texture_from_scene = toAffine(textureFromScene); return;
            case TextureMapping::cylindrical: i.mapping = mapping_cylindrical; i.texture_from_scene = toAffine(textureFromScene); return;
            case TextureMapping::planar: {
                glm::dmat4 plane(1);
                for (int axis = 0; axis < 3; ++axis) { plane[axis][0] = m.planeU[axis]; plane[axis][1] = m.planeV[axis]; }
                plane[3][0] = m.uOffset; plane[3][1] = m.vOffset;
                i.mapping = mapping_planar;
                i.texture_from_scene = toAffine(plane * textureFromScene);
                return;
            }
        }
    }

    /// Coefficients, and an instruction that makes something else of them: their range is not that of the result.
    template <class Kind> void ofCoefficients(const Kind& k, texture_instruction i) {
        const bool unbounded = setUnbounded(true), leavesUnit = leavesUnit_;
        input(k.sigmaA);
        input(k.sigmaS);
        i.value = packNumber(k.g);
        pop(i, 2);
        leavesUnit_ = leavesUnit;
        setUnbounded(unbounded);
    }

    void imagemap(const ImagemapTexture& k, const Texture& t) {
        texture_instruction i = instruction(kind_imagemap_texture, Feature::TEXTURE_IMAGEMAP, t.where);
        i.image = packImage(packer_, k.image, t.isFloat);
        if (packer_.spectral && !t.isFloat) packUplift(packer_);
        i.value = packNumber(k.scale);
        i.flags = (k.invert ? static_cast<uint>(texture_invert) : 0u) | (t.isFloat    ? static_cast<uint>(texture_number)
                                                                         : unbounded_ ? static_cast<uint>(texture_unbounded)
                                                                                      : 0u);
        map(i, k.mapping);
        push(i);
        if (k.scale < 0 || k.scale > 1 || packer_.packed.tables.images[i.image].format == format_float) leavesUnit_ = true;
    }

    void checkerboard(const CheckerboardTexture& k, const Texture& t) {
        input(k.a);
        input(k.b);
        texture_instruction i = instruction(kind_checkerboard_texture, Feature::TEXTURE_CHECKERBOARD, t.where);
        if (k.dimensions == 3) {
            i.mapping = mapping_point;
            i.texture_from_scene = toAffine(glm::inverse(k.mapping.worldFromTexture) * packer_.space.worldFromScene());
        } else map(i, k.mapping);
        pop(i, 2);
    }

    void bilerp(const BilerpTexture& k, const Texture& t) {
        for (const Input* corner : {&k.v00, &k.v01, &k.v10, &k.v11}) input(*corner);
        texture_instruction i = instruction(kind_bilerp_texture, Feature::TEXTURE_BILERP, t.where);
        map(i, k.mapping);
        pop(i, 4);
        leavesUnit_ = true;
    }

    void dots(const DotsTexture& k, const Texture& t) {
        input(k.inside);
        input(k.outside);
        texture_instruction i = instruction(kind_dots_texture, Feature::TEXTURE_DOTS, t.where);
        map(i, k.mapping);
        pop(i, 2);
    }

    void directionMix(const DirectionMixTexture& k, const Texture& t) {
        input(k.a);
        input(k.b);
        texture_instruction i = instruction(kind_directionmix_texture, Feature::TEXTURE_DIRECTIONMIX, t.where);
        i.direction = toVec3(k.direction);
        pop(i, 2);
    }

    void noise(const NoiseTexture& k, const Texture& t) {
        struct Form { texture_kind kind; Feature feature; };
        constexpr Form forms[] = {{kind_fbm_texture, Feature::TEXTURE_FBM}, {kind_wrinkled_texture, Feature::TEXTURE_WRINKLED},
                                  {kind_windy_texture, Feature::TEXTURE_WINDY}, {kind_marble_texture, Feature::TEXTURE_MARBLE}};
        const Form& form = forms[static_cast<size_t>(k.pattern)];
        texture_instruction i = instruction(form.kind, form.feature, t.where);
        i.octaves = static_cast<uint>(k.octaves);
        i.roughness = f(k.roughness);
        i.variation = f(k.variation);
        const glm::dmat4 scale(glm::dmat3(k.scale));
        i.texture_from_scene = toAffine(scale * glm::inverse(k.worldFromTexture) * packer_.space.worldFromScene());
        push(i);
        if (k.pattern != NoisePattern::marble) leavesUnit_ = true;
        else if (packer_.spectral) packUplift(packer_);
    }

    Packer& packer_;
    bool isFloat_;
    bool leavesUnit_ = false;   ///< whether some value may lie outside of [0, 1]
    bool unbounded_ = false;    ///< setUnbounded
    std::vector<texture_instruction> code_;
    int depth_ = 0, deepest_ = 0;
};

uint packTexture(Packer& packer, int texture, TextureUse use) {
    const auto [found, isNew] = packer.packedPrograms.try_emplace({texture, static_cast<int>(use)}, NONE);
    if (!isNew) return found->second;
    const Texture& t = packer.scene.textures[static_cast<size_t>(texture)];
    ProgramWriter writer(packer, t.isFloat);
    writer.setUnbounded(use == TextureUse::coefficient);
    writer.texture(texture);
    writer.use(use);
    return found->second = writer.finish(t.where);
}

double meanLuminance(Packer& packer, int index) {
    const auto [found, isNew] = packer.meanLuminances.try_emplace(index, 0);
    if (!isNew) return found->second;
    const ImageData& image = *packer.images[static_cast<size_t>(index)];
    glm::dvec3 sum(0);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < 3; ++c) sum[c] += std::max(image.at(x, y, image.channels == 1 ? 0 : c), 0.0f);
    return found->second = luminance(sum) / (static_cast<double>(image.width) * image.height);
}

uint packEmissionImage(Packer& packer, const AreaLight& light) {
    const double mean = meanLuminance(packer, light.image);
    Texture t;
    t.kind = ImagemapTexture{light.image, light.imageMapping, mean > 0 ? 1 / mean : 1};
    t.where = light.where;
    ProgramWriter writer(packer, false);
    writer.setUnbounded(true);
    writer.texture(t);
    return writer.finish(t.where);
}

uint packColorInput(Packer& packer, const Input& input, TextureUse use) {
    if (input.texture != none) return packTexture(packer, input.texture, use);
    ProgramWriter writer(packer, false);
    writer.input(input);
    writer.use(use);
    return writer.finish(input.where);
}

uint packInput(Packer& packer, const Input& input) {
    if (input.texture != none) return packTexture(packer, input.texture);
    ProgramWriter writer(packer, true);
    writer.input(input);
    return writer.finish(input.where);
}

}  // namespace eikonal
