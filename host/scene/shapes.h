#pragma once
// Shapes of a scene, and objects that group them.

#include "eikonal/shape.h"
#include "error.h"
#include "scene/basics.h"
#include "scene/textures.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace eikonal {

struct Expression;  // read/formats/expression.h
struct ShapeKind;   // kinds/shape_kind.h

/// A mesh of triangles (3 indices per face) or bilinear patches (4 per face: corners (0,0) (1,0) (0,1) (1,1) in (u, v)).
struct Mesh {
    std::vector<glm::vec3> positions;    ///< relative to `origin`
    glm::dvec3 origin{0};                ///< object space; not zero where floats would lose details (read/mesh/origin.h)
    std::vector<glm::vec3> normals;      ///< one per position, or empty
    std::vector<glm::vec3> tangents;     ///< shading tangents of triangles; one per position, or empty: from the texture coordinates
    std::vector<glm::vec2> uvs;          ///< one per position, or empty
    std::vector<std::uint32_t> indices;
};

/// A cubic Bezier curve. Its width and, for ribbons, its normal are interpolated between the two ends.
struct CurveSegment {
    std::array<glm::vec3, 4> points;
    std::array<double, 2> width;
    std::array<glm::vec3, 2> normals;   ///< ribbons: not zero, not necessarily of unit length
};
struct Curve {
    curve_type type = curve_flat;
    glm::dvec3 origin{0};               ///< object space: added to all points of the segments
    std::vector<CurveSegment> segments;
    int splitDepth = 3;                 ///< a segment becomes 2^splitDepth elements, or more if it bends strongly
};

/// The zero set of F within a box in object space. F < 0 is inside.
struct ImplicitSurface { std::shared_ptr<const Expression> F; glm::dvec3 low, high; };

struct MediumInterface { int inside = none, outside = none; };  ///< in Scene::media; none: vacuum

/// Displacement of a triangle mesh's vertices along their normals, in object space, by a texture. Applied before the scene is packed
/// (render/displacement.h).
struct Displacement {
    int texture = none;      ///< a texture of numbers, in Scene::textures
    double edgeLength = 1;   ///< > 0: longer edges are split first, world space
    SourceLocation where;
};

/// A shape. Which of the fields up to `displacement` count depends on its kind (host/kinds/shape/); the others keep their defaults.
struct Shape {
    const ShapeKind* kind = nullptr;              ///< never null in a scene
    std::shared_ptr<const Mesh> mesh;             ///< triangle, bilinear
    double radius = 1, innerRadius = 0;           ///< sphere, disk, cylinder; innerRadius: disk
    double zMin = -1, zMax = 1, height = 0;       ///< zMin <= zMax: sphere, cylinder (open at both ends); height: disk
    double phiMax = 360;                          ///< sphere, disk, cylinder: degrees in [0, 360]
    std::shared_ptr<const Curve> curve;           ///< curve
    std::shared_ptr<const ImplicitSurface> implicit;   ///< implicit
    std::optional<Displacement> displacement;     ///< triangle
    Transform worldFromObject{1};
    std::optional<Transform> worldFromObjectAtEnd;  ///< set: the shape moves, and has this transform at Scene::motionEnd
    std::string name;                             ///< of the object that it is, for mattes; empty: none
    bool reverseOrientation = false;
    int material = none;                          ///< in Scene::materials; none: pbrt's default, diffuse 0.5
    Input alpha{Spectrum::constant(1)};           ///< probability that a ray hits the shape
    int areaLight = none;                         ///< in Scene::areaLights
    std::optional<MediumInterface> interface;     ///< if given; otherwise a ray keeps its medium
    SourceLocation where;
};

/// A named group of shapes that is visible only through instances. Transforms of its shapes are relative to the instance.
struct Object { std::string name; std::vector<Shape> shapes; SourceLocation where; };
struct Instance {
    int object = none;
    Transform worldFromObject{1};
    std::optional<Transform> worldFromObjectAtEnd;  ///< set: the instance moves, and has this transform at Scene::motionEnd
    SourceLocation where;
};

}  // namespace eikonal
