#include "pack/textures.h"

#include "kind_features.h"
#include "kinds/texture_packing.h"

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace eikonal {

/// A texture that is used twice is evaluated twice, so nested textures can grow exponentially.
constexpr size_t mostInstructions = 65536;

/// Writes the instructions of one program.
class ProgramWriter {
public:
    ProgramWriter(const TexturePacking& in, TextureTables& tables, bool isFloat) : into_(in), tables_(tables), isFloat_(isFloat) {}

    void input(const Input& in) {
        if (in.texture != none) { texture(in.texture); return; }
        texture_instruction i = instruction(kind_constant_texture, KindFeature::TEXTURE_CONSTANT, in.where);
        const bool isNumber = isFloat_ || in.value.isConstant();
        i.value = isNumber     ? into_.colors.constant(in.value.value())
                  : into_.unbounded ? into_.colors.coefficient(in.value)
                                    : into_.colors.textureColor(in.value);
        i.flags = isNumber ? static_cast<uint>(texture_number) : 0u;
        apply(i, 0);
        if (!(isNumber ? Spectrum::constant(in.value.value()) : in.value).isReflectance()) into_.leavesUnit = true;
    }

    void texture(int index) { texture(into_.context.scene.textures[static_cast<size_t>(index)]); }
    void texture(const Texture& t) {
        if (code_.size() > mostInstructions)
            throw SceneError(t.where, fmt::format("the nested textures take more than {} steps, since a texture that is used twice is "
                                                  "evaluated twice; bake textures that are used often into an image",
                                                  mostInstructions));
        const bool outer = isFloat_;
        isFloat_ = t.isFloat;
        if (t.kind->traits.isItsOperand) input(t.operands.front());
        else operation(t);
        isFloat_ = outer;
    }

    /// Allows colours above 1 from here on (TexturePacking::unbounded).
    void allowUnbounded() { into_.unbounded = true; }

    void use(TextureUse use) {
        if (use == TextureUse::reflectance && into_.leavesUnit) apply(instruction(kind_clamp_texture, KindFeature::TEXTURE_CLAMP, {}), 1);
        if (use == TextureUse::roughness || use == TextureUse::regularRoughness)
            apply(instruction(kind_sqrt_texture, KindFeature::TEXTURE_SQRT, {}), 1);
        if (use == TextureUse::regularWidth || use == TextureUse::regularRoughness)
            apply(instruction(kind_regular_texture, KindFeature::TEXTURE_REGULAR, {}), 1);
        if (use == TextureUse::metal) apply(instruction(kind_metal_texture, KindFeature::TEXTURE_METAL, {}), 1);
        if (use == TextureUse::displacement && into_.context.space.scale != 1) {
            input({Spectrum::constant(into_.context.space.scale)});
            apply(instruction(kind_scale_texture, KindFeature::TEXTURE_SCALE, {}), 2);
        }
    }

    uint finish(const SourceLocation& where) {
        if (deepest_ > TEXTURE_STACK)
            throw SceneError(where, fmt::format("this texture needs {} values at once; at most {} are possible. Nest mixes in their first "
                                                "input rather than in their last", deepest_, TEXTURE_STACK));
        /* Slopes of bumps: between texels, and within the shortest waves of noise */
        constexpr double longest = 0.0005, shortestUv = 0x1p-18, shortest = 0x1p-15;
        tables_.programs.push_back({static_cast<uint>(tables_.instructions.size()), static_cast<uint>(code_.size()),
                                    static_cast<float>(std::clamp(into_.detail.uv / 2, shortestUv, longest)),
                                    static_cast<float>(std::clamp(into_.detail.distance / 8, shortest, 1e30))});
        tables_.instructions.insert(tables_.instructions.end(), code_.begin(), code_.end());
        return static_cast<uint>(tables_.programs.size() - 1);
    }

private:
    texture_instruction instruction(texture_kind kind, Feature feature, const SourceLocation& where) {
        into_.context.require(feature, where.toString());
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

    TexturePacking into_;
    TextureTables& tables_;
    bool isFloat_;
    std::vector<texture_instruction> code_;
    int depth_ = 0, deepest_ = 0;
};

TexturePacking TexturePacker::inScene() { return {context_, colors_, *this, context_.space.worldFromScene()}; }

uint TexturePacker::texture(int texture, TextureUse use) {
    const auto [found, isNew] = programs_.try_emplace({texture, use}, NONE);
    if (!isNew) return found->second;
    const Texture& t = context_.scene.textures[static_cast<size_t>(texture)];
    ProgramWriter writer(inScene(), tables_, t.isFloat);
    if (use == TextureUse::coefficient) writer.allowUnbounded();
    writer.texture(texture);
    writer.use(use);
    return found->second = writer.finish(t.where);
}

uint TexturePacker::emissionImage(const AreaLight& light) {
    const double mean = meanLuminance(light.image);
    Texture t;
    t.kind = &kindOf(kind_imagemap_texture);
    t.image = light.image;
    t.mapping = light.imageMapping;
    if (mean > 0) t.scale = 1 / mean;
    t.where = light.where;
    ProgramWriter writer(inScene(), tables_, false);
    writer.allowUnbounded();
    writer.texture(t);
    return writer.finish(t.where);
}

uint TexturePacker::colorInput(const Input& input, TextureUse use) {
    if (input.texture != none) return texture(input.texture, use);
    ProgramWriter writer(inScene(), tables_, false);
    writer.input(input);
    writer.use(use);
    return writer.finish(input.where);
}

uint TexturePacker::alpha(const Input& input, const glm::dmat4& worldFromPoint) {
    if (input.texture == none || worldFromPoint == context_.space.worldFromScene()) return this->input(input);
    std::array<double, 16> key;
    std::copy_n(glm::value_ptr(worldFromPoint), key.size(), key.begin());
    const auto [found, isNew] = alphas_.try_emplace({input.texture, key}, NONE);
    if (!isNew) return found->second;
    ProgramWriter writer({context_, colors_, *this, worldFromPoint}, tables_, true);
    writer.texture(input.texture);
    return found->second = writer.finish(input.where);
}

uint TexturePacker::input(const Input& input) {
    if (input.texture != none) return texture(input.texture);
    ProgramWriter writer(inScene(), tables_, true);
    writer.input(input);
    return writer.finish(input.where);
}

}  // namespace eikonal
