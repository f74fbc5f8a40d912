#pragma once
// The host's side of each kind of shape: one file in host/kinds/shape/ for each line of SHAPES (include/eikonal/shapes.h).

#include "scene/shapes.h"
#include "eikonal/lights.h"
#include "eikonal/shapes.h"
#include "feature_set.h"
#include "pack/space.h"

#include <span>

namespace eikonal {

struct ShapePacking;
namespace pbrt { struct PendingShape; struct ShapeReading; }

/// A directive `Shape "name"` of a pbrt scene.
struct ShapeDirective {
    const char* name;
    const char* parameters;   ///< a row of read/pbrt/kinds.h
    /// Reads the fields that the kind uses. Returns false, after a warning, if the shape is to be skipped. Throws SceneError.
    bool (*read)(const pbrt::ShapeReading&, pbrt::PendingShape&);
};

/// What a kind's file defines.
struct ShapeTraits {
    std::span<const ShapeDirective> directives;

    /// Meshes: corners per face. 0: not a mesh; its transform must then be invertible.
    int corners = 0;

    /// Bounds in the space that `m` maps object space to.
    Box (*bound)(const Shape&, const glm::dmat4& m) = nullptr;

    /// Adds the shape to the tables, and its elements to the group. Returns the number of elements; 0: the shape is skipped.
    size_t (*pack)(const ShapePacking&) = nullptr;

    /// The kind of light of each element, if the shape emits; `m` maps object space to scene space. Null: the shape cannot emit, and
    /// `cannotEmit` says why.
    light_kind (*lightKindOf)(const Shape&, const glm::dmat4& m) = nullptr;
    const char* cannotEmit = nullptr;
};

/* One for each kind, defined in the kind's file. */
#define DECLARE_KIND(name, FEATURE, SPACE) extern const ShapeTraits name##_shape;
SHAPES(DECLARE_KIND)
#undef DECLARE_KIND

/// A line of SHAPES.
struct ShapeKind {
    const char* name;
    shape_kind value;
    Feature feature;
    const ShapeTraits& traits;
};

/// All kinds, indexed by shape_kind.
std::span<const ShapeKind> shapeKindList();
inline const ShapeKind& kindOf(shape_kind kind) { return shapeKindList()[kind]; }

/// A mesh of triangles, or of bilinear patches.
Shape triangleMesh(std::shared_ptr<const Mesh> mesh);
Shape bilinearMesh(std::shared_ptr<const Mesh> mesh);

}  // namespace eikonal
