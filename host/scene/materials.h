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

/// How light leaves a body that it has entered: in the medium's own steps, or by a profile.
enum class SubsurfaceMethod { randomWalk, diffusion };
constexpr std::pair<const char*, SubsurfaceMethod> subsurfaceMethodNames[] = {{"randomwalk", SubsurfaceMethod::randomWalk}, {"diffusion", SubsurfaceMethod::diffusion}};

/// How much light leaves a body how far from where it has entered, by normalised diffusion (kernels/shade/diffusion.clh).
struct DiffusionProfile {
    Spectrum albedo;    ///< share of the light that enters, in [0, 1]
    Spectrum length;    ///< d, world units; with a texture: the mean free path, scattering reduced, or what pathTexture is multiplied by
    int albedoTexture = none;   ///< in Scene::textures: the albedo where light enters
    int pathTexture = none;     ///< the mean free path there
    std::shared_ptr<const DiffusionProfile> atWavelengths{};   ///< what counts there instead; null: this
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
    std::string name;                       ///< empty for an unnamed one
    std::map<std::string, Input> inputs;
    bool remapRoughness = true;             ///< roughness r gives microfacet width sqrt(r); otherwise r itself
    std::array<int, 2> mixed{none, none};   ///< mix: in Scene::materials
    std::shared_ptr<const Medium> interior; ///< subsurface: what light wanders in, homogeneous
    std::shared_ptr<const DiffusionProfile> diffusion;   ///< subsurface: what comes of that
    SubsurfaceMethod method = SubsurfaceMethod::diffusion;
    std::string file;                       ///< measured: as it can be opened from here
    int displacement = none;                ///< in Scene::textures: bump map
    int normalMap = none;                   ///< in Scene::images
    SourceLocation where;
};

}  // namespace eikonal
