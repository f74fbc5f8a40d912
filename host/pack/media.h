#pragma once
// Participating media of the scene, and interiors of subsurface bodies.

#include "pack/colors.h"

#include <map>
#include <memory>
#include <string>

namespace eikonal {

class MediumPacker {
public:
    MediumPacker(const PackContext& context, MediumTables& tables, ColorPacker& colors)
        : context_(context), tables_(tables), colors_(colors) {}

    /// Packs the media of the scene, if a ray can be inside one.
    void pack();
    /// Packs the interior medium of a material: its index in `media`.
    uint interior(const std::shared_ptr<const Medium>&, const std::string& why);
    /// Packs the point lights for equiangular sampling in homogeneous media. Comes after the lights.
    void packEquiangularLights(const Table<light>& lights);

private:
    const PackContext& context_;
    MediumTables& tables_;
    ColorPacker& colors_;
    std::map<const Medium*, uint> interiors_;  ///< -> `media`
};

}  // namespace eikonal
