#pragma once
// Shared code for packing lights.

#include "kinds/light_kind.h"
#include "pack/light_tree.h"
#include "pack/colors.h"

#include <array>
#include <map>
#include <utility>
#include <vector>

namespace eikonal {

/// (image of the scene, in grey?) -> its first texel in `environment_texels`
using LightImages = std::map<std::pair<int, bool>, uint>;

/// What kinds of lights write.
struct LightPacking {
    const PackContext& context;
    LightTables& tables;
    ColorPacker& colors;
    LightImages& images;
};

/// A light and its power for the light sampler: luminance times solid angle, for infinite lights also times the scene's area.
struct PackedLight { light l; double power; };

/// One element of a shape that emits. `sceneFromObject` maps its object space to scene space.
struct AreaElement {
    const GeometryTables& tables;
    const Shape& description;
    const shape& packed;
    size_t element;
    const glm::dmat4& sceneFromObject;
};

/// A light without position and direction. Straight-line kernels evaluate every kind for every light, so it has an image of one texel,
/// which keeps texel indices valid.
light newLight(light_kind kind, const color& L);
/// A light at the origin of its light space. The caller sets its intensity.
light newPointLight(const LightPacking&, const Light&, light_kind kind);

/// The factor of intensities: they are divided by squared distances, which are in scene units on the device.
double intensityScale(const PackContext&);
/// In world units; 1 for an empty scene.
double sceneRadius(const PackContext&);
/// The rotation from light space to scene space, with a reflection if there is one, but without scale. Warns of unequal scales and of
/// shear.
glm::dmat3 rotationOf(const PackContext&, const Light&);
inline glm::dvec3 toGlm(vec3 v) { return {v.x, v.y, v.z}; }

/// An image over the sphere of directions. Throws SceneError unless it is square.
const ImageData& sphereImage(const PackContext&, const Light&);
/// The texel in column x and row y, negative values clamped to 0.
glm::dvec3 texelOf(const ImageData&, int x, int y);
/// The mean of R, G and B.
double greyOf(glm::dvec3 rgb);
/// Adds texels to `environment_texels` and returns the index of the first.
uint packTexels(const LightPacking&, const std::vector<glm::vec3>&);
/// Adds an image to `environment_texels` and returns the index of its first texel. Lights with the same image share texels.
uint packLightImage(const LightPacking&, int image, bool inGrey);
/// Illuminance of a surface that faces +z of an equal-area image of the sphere. Too small by a factor of 2, as in pbrt-v4, which uses the
/// hemisphere's solid angle for the whole square; a scene with "illuminance" is therefore twice as bright as specified.
double upwardIlluminance(const ImageData&);

/// A point of an element of a mesh: the cross product of its tangents, and the weights of the element's vertex normals.
struct MeshPoint { glm::dvec3 across; std::array<double, 4> weights{}; };
/// The side on which an element of a mesh emits: 1 that of the cross product, -1 the other, in all of the points; 0: not in all the same,
/// since vertex normals decide (as in pbrt-v4); light::two_sided of such an element is 1.
int emittingSide(const AreaElement&, const uint* corners, const std::vector<MeshPoint>& points);
/// The fraction of the circle that phiMax (degrees) covers.
double shareOfCircle(double phiMax);
/// In x, the sign of the side on which a sphere, cylinder or disk emits: 1 if the cross product of its tangents points outwards in the
/// scene, as it does in object space, else -1.
vec3 sideOf(const AreaElement&);

/// Bounds of a light that emits in all directions.
void boundAllDirections(LightBounds& bounds);
/// The same for a light that is a sphere, or within one: centre l.p, radius l.radius. A convex body shows a quarter of its surface, on
/// average (Cauchy).
void boundSphere(const light& l, double power, LightBounds& bounds);
/// The same for a point light.
void boundPoint(const light& l, double power, LightBounds& bounds);

}  // namespace eikonal
