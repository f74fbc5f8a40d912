#pragma once
// The source of every stage's kernel. A stage over `each_bsdf` has one kernel per BSDF.

#include "render/stage_table.h"

#include <string>
#include <vector>

namespace eikonal {

/// A kernel to build for a row of STAGES or SURVEYS.
struct StageProgram {
    const StageRow* row;         ///< row->name is the kernel's name
    uint over;                   ///< as in the row; for a BSDF, its next_queue
    Requirement bsdf;            ///< the scene must have this BSDF
    std::string name;            ///< in messages and profiles: "shade_hits diffuse", otherwise as in the row
    std::string text;

    bool isRequired(const Features& features, const SceneConstants& constants) const {
        return row->requirement.isMet(features, constants) && bsdf.isMet(features, constants);
    }
};

/// All programs: STAGES in their order, then SURVEYS.
const std::vector<StageProgram>& stagePrograms();
/// Throws std::out_of_range for an unknown name.
const StageProgram& stageProgram(const std::string& name);

}  // namespace eikonal
