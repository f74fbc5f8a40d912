#pragma once
// Shapes of a scene, and objects made of them.

#include "error.h"
#include "scene/basics.h"
#include "scene/textures.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace eikonal {

struct Expression;  // scene/expression.h

/// A mesh of triangles (3 indices a face) or bilinear patches (4: corners (0,0) (1,0) (0,1) (1,1) in (u, v)).
struct Mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;      ///< one a position, or empty
    std::vector<glm::vec3> tangents;     ///< of triangles: where u grows, as shading sees it; one a position, or empty: the texture coordinates say
    std::vector<glm::vec2> uvs;          ///< one a position, or empty
    std::vector<std::uint32_t> indices;
};

struct TriangleMesh { std::shared_ptr<const Mesh> mesh; };
struct BilinearMesh { std::shared_ptr<const Mesh> mesh; };
struct Sphere { double radius = 1, zMin = -1, zMax = 1, phiMax = 360; };
struct Disk { double radius = 1, innerRadius = 0, height = 0, phiMax = 360; };
struct Cylinder { double radius = 1, zMin = -1, zMax = 1, phiMax = 360; };  ///< without caps

enum class CurveKind { flat, cylinder, ribbon };
/// A cubic Bezier curve. Its width and, on ribbons, its normal go from one end's to the other's.
struct CurveSegment {
    std::array<glm::vec3, 4> points;
    std::array<double, 2> width;
    std::array<glm::vec3, 2> normals;   ///< ribbons: of any length but zero
};
struct Curve {
    CurveKind kind = CurveKind::flat;
    std::vector<CurveSegment> segments;
    int splitDepth = 3;                 ///< each segment is 2^splitDepth elements, or more if it bends
};
struct CurveShape { std::shared_ptr<const Curve> curve; };

/// Where F is 0, within a box in object space. Inside is where F < 0.
struct ImplicitSurface { std::shared_ptr<const Expression> F; glm::dvec3 low, high; };

struct MediumInterface { int inside = none, outside = none; };  ///< in Scene::media; none: vacuum

/// How a texture moves the vertices of a mesh of triangles along their normals, in object space: done before the scene is packed
/// (render/displacement.h).
struct Displacement {
    int texture = none;      ///< in Scene::textures, of numbers
    double edgeLength = 1;   ///< > 0: longer edges are cut before, world space
    SourceLocation where;
};

struct Shape {
    std::variant<TriangleMesh, BilinearMesh, Sphere, Disk, Cylinder, CurveShape, ImplicitSurface> kind;
    std::optional<Displacement> displacement;     ///< of a TriangleMesh
    Transform worldFromObject{1};
    std::optional<Transform> worldFromObjectAtEnd;  ///< set: it moves, and is there at Scene::motionEnd
    bool reverseOrientation = false;
    int material = none;                          ///< in Scene::materials; none: pbrt's default, diffuse 0.5
    Input alpha{Spectrum::constant(1)};           ///< probability that a ray meets the shape at all
    int areaLight = none;                         ///< in Scene::areaLights
    std::optional<MediumInterface> interface;     ///< given explicitly; otherwise a ray keeps its medium
    SourceLocation where;
};

/// A named group of shapes that is only seen where it is instanced. Its shapes' transforms are relative to the instance.
struct Object { std::string name; std::vector<Shape> shapes; SourceLocation where; };
struct Instance {
    int object = none;
    Transform worldFromObject{1};
    std::optional<Transform> worldFromObjectAtEnd;  ///< set: it moves, and is there at Scene::motionEnd
    SourceLocation where;
};

}  // namespace eikonal
