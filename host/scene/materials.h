#pragma once
// Materials of a scene.

#include "error.h"
#include "scene/media.h"
#include "scene/textures.h"

#include <array>
#include <map>
#include <memory>
#include <string>
#include <utility>

namespace eikonal {

enum class MaterialKind {
    diffuse, coatedDiffuse, coatedConductor, conductor, dielectric, thinDielectric, diffuseTransmission, hair, measured, principled, subsurface, interface, mix
};

/// How light moves inside a body: by a random walk through its medium, or by a diffusion profile.
enum class SubsurfaceMethod { randomWalk, diffusion };
constexpr std::pair<const char*, SubsurfaceMethod> subsurfaceMethodNames[] = {{"randomwalk", SubsurfaceMethod::randomWalk}, {"diffusion", SubsurfaceMethod::diffusion}};

/// Normalised diffusion profile: how much light leaves a body at which distance from where it entered (kernels/shade/diffusion.clh).
struct DiffusionProfile {
    Spectrum albedo;    ///< share of the entering light that leaves again, in [0, 1]
    Spectrum length;    ///< d, world units; with a texture: the mean free path of reduced scattering, or the factor of pathTexture
    int albedoTexture = none;   ///< in Scene::textures: albedo where light enters
    int pathTexture = none;     ///< in Scene::textures: mean free path where light enters
    std::shared_ptr<const DiffusionProfile> atWavelengths{};   ///< replaces this profile in spectral rendering; null: none does
    bool isTextured() const { return albedoTexture != none || pathTexture != none; }
};

/// A material. `inputs` has every parameter of its kind under pbrt-v4's name, defaults filled in by the reader:
///   diffuse              reflectance
///   coatedDiffuse        reflectance uroughness vroughness thickness eta g albedo maxdepth nsamples
///   coatedConductor      uroughness vroughness thickness eta g albedo maxdepth nsamples (the coat's), metal_uroughness metal_vroughness,
///                        and either reflectance or both metal_eta and metal_k
///   conductor            uroughness vroughness, and either reflectance or both eta and k
///   dielectric           uroughness vroughness eta
///   thinDielectric       eta
///   diffuseTransmission  reflectance transmittance     ("scale" multiplied in)
///   hair                 sigma_a eta beta_m beta_n alpha h (-1 to 1 across the fiber)
///   measured             (`file`)
///   principled           base metallic eta uroughness vroughness coat coatroughness sheen  (no pbrt material: OBJ's)
///   subsurface           uroughness vroughness eta     (and `interior`, `diffusion`, `method`)
///   mix                  amount                        (the weight of mixed[1])
struct Material {
    MaterialKind kind = MaterialKind::diffuse;
    std::string name;                       ///< empty for an unnamed material
    std::map<std::string, Input> inputs;
    bool remapRoughness = true;             ///< roughness r gives microfacet width sqrt(r); otherwise r itself
    std::array<int, 2> mixed{none, none};   ///< mix: in Scene::materials
    std::shared_ptr<const Medium> interior; ///< subsurface: the homogeneous medium inside the body
    std::shared_ptr<const DiffusionProfile> diffusion;   ///< subsurface: the profile of that medium
    SubsurfaceMethod method = SubsurfaceMethod::diffusion;
    std::string file;                       ///< measured: a path that can be opened from the working directory
    int displacement = none;                ///< in Scene::textures: bump map
    int normalMap = none;                   ///< in Scene::images
    SourceLocation where;
};

}  // namespace eikonal
