#pragma once
// Lights whose directions are an image's texels.

#include "pack/packer.h"

namespace eikonal {

/// A light of no place and no direction. Straight-line sampling computes every kind for every light: an image of one texel is harmless,
/// one of none is not.
light newLight(light_kind kind, const color& L);

/// An image over the sphere of directions. Throws SceneError unless it is square.
const ImageData& sphereImage(const Packer&, const Light&, int image);
/// The texel of column x and row y; nothing is negative.
glm::dvec3 texelOf(const ImageData&, int x, int y);
/// The number of the texel that packTexels adds next to `environment_texels`.
uint nextTexel(const Packer&);
/// Illuminance of a surface that faces +z of an image over the sphere of directions, as pbrt-v4 measures it: it takes the square for the
/// hemisphere alone, so that this is half of what arrives, and a scene with an "illuminance" twice as bright as it says.
double upwardIlluminance(const ImageData&);

/// A light, and its luminance times solid angle (infinite: and the scene's area), which the light sampler goes by.
struct PackedLight { light l; double power; };

/// Their texels go to `environment_texels`. The mean of R, G and B is the image of a goniometric light, as in pbrt-v4.
PackedLight packImageLight(Packer&, const Light&, const GoniometricLight&);
PackedLight packImageLight(Packer&, const Light&, const ProjectionLight&);
PackedLight packImageLight(Packer&, const Light&, const PortalInfiniteLight&);

}  // namespace eikonal
