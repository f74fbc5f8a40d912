#pragma once
// Measured BSDFs.

#include "pack/colors.h"

#include <map>
#include <string>

namespace eikonal {

class MeasuredPacker {
public:
    MeasuredPacker(const PackContext& context, BsdfTables& tables, SceneConstants& constants, ColorPacker& colors)
        : context_(context), tables_(tables), constants_(constants), colors_(colors) {}

    /// The index in `measured_files` of a file. Throws SceneError if it is not one of a measured BSDF.
    uint file(const std::string& path, const SourceLocation& where);

private:
    const PackContext& context_;
    BsdfTables& tables_;
    SceneConstants& constants_;
    ColorPacker& colors_;
    std::map<std::string, uint> files_;  ///< path -> `measured_files`
};

}  // namespace eikonal
