#pragma once
// The text of every stage's kernel: that of a stage over `each_bsdf` once for each BSDF.

#include "render/stage_table.h"

#include <string>
#include <vector>

namespace eikonal {

/// A row of STAGES or SURVEYS as it is built.
struct StageProgram {
    const StageRow* row;         ///< its name is that of the kernel
    uint over;                   ///< as in the row; of a BSDF: its next_queue
    Requirement bsdf;            ///< that the scene has this BSDF
    std::string name;            ///< for people and profiles: "shade_hits diffuse", otherwise as in the row
    std::string text;

    bool isRequired(const Features& features, const SceneConstants& constants) const {
        return row->requirement.isMet(features, constants) && bsdf.isMet(features, constants);
    }
};

/// All of them: STAGES in their order, then SURVEYS.
const std::vector<StageProgram>& stagePrograms();
/// Throws std::out_of_range for a name that none has.
const StageProgram& stageProgram(const std::string& name);

}  // namespace eikonal
