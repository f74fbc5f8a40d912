#pragma once
// What is inside of a body of material "subsurface", from the four ways in which a scene may say it.

#include "scene/pbrt/arguments.h"

#include <memory>

namespace eikonal::pbrt {

/// The homogeneous medium of material "subsurface", whose parameters are `arguments`: "name", or "sigma_a" and "sigma_s", or "reflectance" with
/// "mfp" (scene/diffuse_albedo.h), or, given none of them, pbrt-v4's default; "scale" multiplies coefficients or the mean free path. eta: the index inside over
/// that outside. Warns of parameters that something else overrides. Throws SceneError if there is one sigma only, or no substance of that name. Textures have no say here.
std::shared_ptr<const Medium> interiorOf(Reading& reading, const Arguments& arguments, double eta);

}  // namespace eikonal::pbrt
