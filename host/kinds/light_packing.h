#pragma once
// What kinds of lights share when they are packed.

#include "kinds/light_kind.h"
#include "pack/light_tree.h"
#include "pack/packer.h"

namespace eikonal {

/// A light, and its luminance times solid angle (infinite: and the scene's area), which the light sampler goes by.
struct PackedLight { light l; double power; };

/// One element of a shape that emits. `sceneFromObject` takes its object space to scene space.
struct AreaElement {
    const SceneTables& tables;
    const Shape& description;
    const shape& packed;
    size_t element;
    const glm::dmat4& sceneFromObject;
};

/// A light of no place and no direction. Straight-line sampling computes every kind for every light: an image of one texel is harmless,
/// one of none is not.
light newLight(light_kind kind, const color& L);
/// A light at the origin of its light space, without an intensity yet.
light newPointLight(Packer&, const Light&, light_kind kind);

/// Intensities fall with the square of the distance, which is in scene units: a factor for them.
double intensityScale(const Packer&);
/// In world units; 1 for an empty scene.
double sceneRadius(const Packer&);
/// Light space to scene space, without what stretches.
glm::dmat3 rotationOf(const Light&);
inline glm::dvec3 toGlm(vec3 v) { return {v.x, v.y, v.z}; }

/// The image of a light.
const ImageData& imageOf(const Packer&, const Light&);
/// An image over the sphere of directions. Throws SceneError unless it is square.
const ImageData& sphereImage(const Packer&, const Light&);
/// The texel of column x and row y; nothing is negative.
glm::dvec3 texelOf(const ImageData&, int x, int y);
/// The mean of R, G and B.
double greyOf(glm::dvec3 rgb);
/// The number of the texel that packTexels adds next to `environment_texels`.
uint nextTexel(const Packer&);
/// The first of an image's texels in `environment_texels`. Lights with the same image share them.
uint packLightImage(Packer&, int image, bool inGrey);
/// Illuminance of a surface that faces +z of an image over the sphere of directions, as pbrt-v4 measures it: pbrt-v4 takes the square for
/// the hemisphere alone, so this is half of what arrives, and a scene with an "illuminance" is twice as bright as it says.
double upwardIlluminance(const ImageData&);

/// The normal on whose side a flat element emits: its geometric one, n, on the side of its vertex normals if it has any.
glm::dvec3 emittingNormal(const AreaElement&, glm::dvec3 n, const uint* corners, int count);
/// What phiMax, in degrees, is of the whole circle.
double shareOfCircle(double phiMax);
/// In x, on which side a round light emits: 1 where the product of its tangents points outwards in the scene as it does in object space.
vec3 sideOf(const AreaElement&);

/// Bounds of what shines into all directions.
void boundAllDirections(LightBounds& bounds);
/// The same from a point.
void boundPoint(const light& l, double power, LightBounds& bounds);

}  // namespace eikonal
