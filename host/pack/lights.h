#pragma once
// Lights, and how one is chosen to be sampled.

#include "kinds/light_packing.h"
#include "pack/light_media.h"
#include "pack/textures.h"

#include <optional>
#include <string>
#include <vector>

namespace eikonal {

class LightPacker {
public:
    /// groups: gets the names of the light groups.
    LightPacker(const PackContext& context, LightTables& tables, settings& frame, ColorPacker& colors, TexturePacker& textures,
                std::vector<std::string>& groups)
        : context_(context), tables_(tables), frame_(frame), colors_(colors), textures_(textures), groups_(groups) {}

    /// Adds the lights of a shape that emits, one for each of its elements; sets its first_light. `m` maps its object space to scene space.
    void addShape(const Shape&, shape& packed, const GeometryTables&, const glm::dmat4& m, size_t elements);
    /// Adds the lights without a shape, after all others, then makes the light sampler.
    void pack();
    /// With light paths: how likely they begin at each light. After pack().
    void packEmission();

private:
    bool isLeftToBsdfs(const LightKind&) const;
    bool isInfinite(const LightKind&) const;
    void add(const LightPacking& in, const Light& description);
    void packGuide();
    void placeInMedia();
    std::optional<int> mediumAround(const LightMedia& media, const light& l, const Shape* shape) const;
    uint groupNumber(const std::string& name);

    const PackContext& context_;
    LightTables& tables_;
    settings& frame_;
    ColorPacker& colors_;
    TexturePacker& textures_;
    std::vector<std::string>& groups_;
    std::vector<double> powers_;  ///< powers of `lights`, for the light sampler
    /// A light where light paths may begin.
    struct Emission {
        double power;        ///< 0: none do
        const Shape* shape;  ///< of an area; null: none
    };
    std::vector<Emission> emitted_;   ///< of `lights`
};

}  // namespace eikonal
