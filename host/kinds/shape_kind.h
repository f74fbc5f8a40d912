#pragma once
// What the host knows of each kind of shape: one file of host/kinds/shape/ for each line of SHAPES (include/eikonal/shapes.h).

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
    /// Reads the fields of the shape that its kind uses. Returns false for a shape to be left out, after a warning. Throws SceneError.
    bool (*read)(const pbrt::ShapeReading&, pbrt::PendingShape&);
};

/// What a kind's file defines.
struct ShapeTraits {
    std::span<const ShapeDirective> directives;

    /// Meshes: corners of a face. 0 for kinds without a mesh, whose transform must be invertible.
    int corners = 0;

    /// Bounds in the space that `m` takes its object space to.
    Box (*bound)(const Shape&, const glm::dmat4& m) = nullptr;

    /// Adds it to the tables, and its elements to the group. Returns how many elements it has; 0: it is left out.
    size_t (*pack)(const ShapePacking&) = nullptr;

    /// The kind of light that each of its elements is, if it emits, where `m` takes its object space to scene space. Null: it cannot emit,
    /// for the reason `cannotEmit`.
    light_kind (*lightKindOf)(const Shape&, const glm::dmat4& m) = nullptr;
    const char* cannotEmit = nullptr;
};

/* Each kind's file defines one of them. */
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

/// All kinds, by shape_kind.
std::span<const ShapeKind> shapeKindList();
inline const ShapeKind& kindOf(shape_kind kind) { return shapeKindList()[kind]; }

/// A mesh of triangles, or of bilinear patches.
Shape triangleMesh(std::shared_ptr<const Mesh> mesh);
Shape bilinearMesh(std::shared_ptr<const Mesh> mesh);

}  // namespace eikonal
