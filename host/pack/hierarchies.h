#pragma once
// The hierarchies over a scene's shapes: gathered while its tables are filled, built when nothing else of it is needed any more.

#include "diagnostics.h"
#include "pack/group.h"
#include "pack/motion.h"
#include "pack/tables.h"

#include <optional>
#include <vector>

namespace eikonal {

/// Where something is, and where it is when the motion ends, if it moves.
struct Place {
    glm::dmat4 start{1};
    std::optional<glm::dmat4> end{};
    Motion motion() const { return {start, end.value_or(start)}; }
};

/// A group in the world: places one inside of the other, the outermost first.
struct PlacedGroup { size_t group; std::vector<Place> places; uint id; };

/// The elements of every hierarchy, by their numbers in the tables of a scene.
struct Hierarchies {
    Group world;
    std::vector<Group> groups;
    std::vector<PlacedGroup> placed;
    TimeSpan seen{};   ///< when the camera looks

    /// Builds them into the tables `nodes`, `triangle_lines`, `leaf_elements`, `instances` and `motions`, and counts what that took.
    /// No other table changes.
    void build(GeometryTables& tables, SceneCounts& counts, Diagnostics& diagnostics) const;
};

}  // namespace eikonal
