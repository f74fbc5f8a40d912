#pragma once
// The hierarchies over a scene's shapes: listed while the tables are filled, built afterwards.

#include "diagnostics.h"
#include "pack/group.h"
#include "pack/motion.h"
#include "pack/tables.h"

#include <optional>
#include <vector>

namespace eikonal {

/// A transform, and if it moves, the transform at the end of the motion.
struct Place {
    glm::dmat4 start{1};
    std::optional<glm::dmat4> end{};
    Motion motion() const { return {start, end.value_or(start)}; }
};

/// A group in the world. There may be millions.
struct PlacedGroup {
    uint group, id;
    glm::dmat4 worldFromGroup{1};   ///< if it stands still
    std::vector<Place> motion{};    ///< if it moves: nested transforms, outermost first
};

/// The elements of all hierarchies, by their indices in the tables of a scene.
struct Hierarchies {
    Group world;
    std::vector<Group> groups;
    std::vector<PlacedGroup> placed;
    TimeSpan seen{};   ///< while the shutter is open

    /// Fills the tables `nodes`, `triangle_lines`, `leaf_elements`, `instances` and `motions`, and notes depth and time.
    void build(GeometryTables& tables, SceneCounts& counts, Diagnostics& diagnostics) const;
};

}  // namespace eikonal
