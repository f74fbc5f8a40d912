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

struct MaterialKind;   // kinds/material_kind.h

/// How light moves inside a body: by a random walk through its medium, or by a diffusion profile.
enum class SubsurfaceMethod { randomWalk, diffusion };
constexpr std::pair<const char*, SubsurfaceMethod> subsurfaceMethodNames[] = {{"randomwalk", SubsurfaceMethod::randomWalk},
                                                                              {"diffusion", SubsurfaceMethod::diffusion}};

/// Normalised diffusion profile: how much light leaves a body at which distance from where it entered (kernels/shade/diffusion.clh).
struct DiffusionProfile {
    Spectrum albedo;    ///< fraction of the entering light that leaves again, in [0, 1]
    Spectrum length;    ///< d, world units; with a texture: the mean free path of reduced scattering, or the factor of pathTexture
    int albedoTexture = none;   ///< in Scene::textures: albedo where light enters
    int pathTexture = none;     ///< in Scene::textures: mean free path where light enters
    std::shared_ptr<const DiffusionProfile> atWavelengths{};   ///< replaces this profile in spectral rendering; null: none does
    bool isTextured() const { return albedoTexture != none || pathTexture != none; }
};

/// A material. `inputs` has every parameter of its kind under pbrt-v4's name, defaults filled in by the reader; host/kinds/material/ lists
/// them.
struct Material {
    const MaterialKind* kind = nullptr;     ///< never null in a scene
    std::string name;                       ///< empty for an unnamed material
    std::map<std::string, Input> inputs;    ///< "scale" is multiplied in
    bool remapRoughness = true;             ///< roughness r gives microfacet width sqrt(r); otherwise r itself
    bool compensatesEnergy = false;         ///< light that microfacets scatter more than once is not lost
    std::array<int, 2> mixed{none, none};   ///< mix: in Scene::materials
    std::shared_ptr<const Medium> interior; ///< subsurface: the homogeneous medium inside the body
    std::shared_ptr<const DiffusionProfile> diffusion;   ///< subsurface: the profile of that medium
    SubsurfaceMethod method = SubsurfaceMethod::diffusion;
    /// Whether random walks go through the inside.
    bool isWalked() const { return interior && method == SubsurfaceMethod::randomWalk; }
    std::string file;                       ///< measured: a path that can be opened from the working directory
    int displacement = none;                ///< in Scene::textures: bump map
    int normalMap = none;                   ///< in Scene::images
    SourceLocation where;
};

}  // namespace eikonal
