// Textures as programs, and the images that they read.

#include "kind_features.h"
#include "color/luminance.h"
#include "kinds/texture_packing.h"
#include "pack/colors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

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
    ProgramWriter(Packer& packer, bool isFloat) : packer_(packer), into_{packer}, isFloat_(isFloat) {}

    void input(const Input& in) {
        if (in.texture != none) { texture(in.texture); return; }
        texture_instruction i = instruction(kind_constant_texture, KindFeature::TEXTURE_CONSTANT, in.where);
        const bool isNumber = isFloat_ || in.value.isConstant();
        i.value = isNumber     ? packConstant(packer_, in.value.value())
                  : into_.unbounded ? packCoefficient(packer_, in.value)
                               : packReflectance(packer_, in.value);
        i.flags = isNumber ? static_cast<uint>(texture_number) : 0u;
        apply(i, 0);
        const glm::dvec3 value = isNumber ? glm::dvec3(in.value.value()) : in.value.albedo();
        if (std::min({value.x, value.y, value.z}) < 0 || std::max({value.x, value.y, value.z}) > 1) into_.leavesUnit = true;
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
        if (t.kind->traits.isItsOperand) input(t.operands.front());
        else operation(t);
        isFloat_ = outer;
    }

    /// Colours of what follows may be greater than 1 (TexturePacking::unbounded).
    void allowUnbounded() { into_.unbounded = true; }

    void use(TextureUse use) {
        if (use == TextureUse::reflectance && into_.leavesUnit) apply(instruction(kind_clamp_texture, KindFeature::TEXTURE_CLAMP, {}), 1);
        if (use == TextureUse::roughness || use == TextureUse::regularRoughness)
            apply(instruction(kind_sqrt_texture, KindFeature::TEXTURE_SQRT, {}), 1);
        if (use == TextureUse::regularWidth || use == TextureUse::regularRoughness)
            apply(instruction(kind_regular_texture, KindFeature::TEXTURE_REGULAR, {}), 1);
        if (use == TextureUse::metal) apply(instruction(kind_metal_texture, KindFeature::TEXTURE_METAL, {}), 1);
        if (use == TextureUse::displacement && packer_.space.scale != 1) {
            input({Spectrum::constant(packer_.space.scale)});
            apply(instruction(kind_scale_texture, KindFeature::TEXTURE_SCALE, {}), 2);
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
    texture_instruction instruction(texture_kind kind, Feature feature, const SourceLocation& where) {
        packer_.packed.require(feature, where.toString());
        texture_instruction i{};
        i.kind = kind;
        i.image = NONE;
        return i;
    }

    /// Appends an instruction that pops so many operands and pushes one value.
    void apply(const texture_instruction& i, int operands) {
        code_.push_back(i);
        depth_ += 1 - operands;
        deepest_ = std::max(deepest_, depth_);
    }

    /// A texture's operands, and the instruction that takes them.
    void operation(const Texture& t) {
        const TextureTraits& traits = t.kind->traits;
        const bool unbounded = into_.unbounded, leavesUnit = into_.leavesUnit;
        if (traits.takesCoefficients) into_.unbounded = true;
        for (const Input& operand : t.operands) input(operand);
        if (traits.takesCoefficients) {
            into_.unbounded = unbounded;
            into_.leavesUnit = leavesUnit;
        }
        texture_instruction i = instruction(t.kind->value, t.kind->feature, t.where);
        if (traits.pack) traits.pack(into_, t, i);
        apply(i, t.kind->operands);
    }

    Packer& packer_;
    TexturePacking into_;
    bool isFloat_;
    std::vector<texture_instruction> code_;
    int depth_ = 0, deepest_ = 0;
};

uint packTexture(Packer& packer, int texture, TextureUse use) {
    const auto [found, isNew] = packer.packedPrograms.try_emplace({texture, static_cast<int>(use)}, NONE);
    if (!isNew) return found->second;
    const Texture& t = packer.scene.textures[static_cast<size_t>(texture)];
    ProgramWriter writer(packer, t.isFloat);
    if (use == TextureUse::coefficient) writer.allowUnbounded();
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
    t.kind = &kindOf(kind_imagemap_texture);
    t.image = light.image;
    t.mapping = light.imageMapping;
    if (mean > 0) t.scale = 1 / mean;
    t.where = light.where;
    ProgramWriter writer(packer, false);
    writer.allowUnbounded();
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
