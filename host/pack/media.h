#pragma once
// Participating media, in the scene and inside of bodies.

#include "pack/colors.h"

#include <map>
#include <memory>
#include <string>

namespace eikonal {

class MediumPacker {
public:
    MediumPacker(const PackContext& context, MediumTables& tables, ColorPacker& colors)
        : context_(context), tables_(tables), colors_(colors) {}

    /// The media of the scene, if a ray can be inside one.
    void pack();
    /// Packs the interior medium of a material: its index in `media`.
    uint interior(const std::shared_ptr<const Medium>&, const std::string& why);
    /// The point lights that rays through homogeneous media are sampled towards; after the lights.
    void packEquiangularLights(const Table<light>& lights);

private:
    const PackContext& context_;
    MediumTables& tables_;
    ColorPacker& colors_;
    std::map<const Medium*, uint> interiors_;  ///< -> `media`
};

}  // namespace eikonal
