#pragma once
// What the parts of packing share. One function for each group of tables, in the order in which they depend on each other.

#include "diagnostics.h"
#include "eikonal/stages.h"
#include "pack/colors.h"
#include "pack/space.h"
#include "pack/tables.h"
#include "read/formats/image.h"
#include "scene/scene.h"

#include <memory>
#include <set>
#include <unordered_map>
#include <vector>

namespace eikonal {

struct Hierarchies;   // pack/hierarchies.h

struct Packer {
    const Scene& scene;
    Diagnostics& diagnostics;
    PackedScene& packed;
    SceneSpace space;
    Box bounds;              ///< of all that is placed in the scene, world space
    bool hasMedia = false;   ///< whether anything can ever be inside a medium
    bool spectral = false;   ///< rendering at wavelengths, not in RGB
    ColorPacker colors{};    ///< what packing colours remembers

    std::vector<std::shared_ptr<const ImageData>> images{};   ///< of scene.images
    std::map<std::pair<int, bool>, uint> packedImages{};      ///< (scene image, as a float texture?) -> `images`
    std::map<std::pair<int, bool>, uint> lightTexels{};       ///< (scene image, in grey?) -> `environment_texels`
    std::map<int, double> meanLuminances{};                   ///< of scene.images, where asked for
    std::map<std::pair<int, int>, uint> packedPrograms{};     ///< (texture, TextureUse) -> `programs`
    std::vector<uint> materialIndices{};                      ///< scene.materials -> `materials`
    std::map<const Medium*, uint> interiors{};                ///< of bodies that light wanders in -> `media`
    std::map<const DiffusionProfile*, uint> profiles{};       ///< -> `profiles`
    std::map<std::string, uint> measuredFiles{};              ///< path -> `measured_files`
    uint defaultMaterial = NONE;
    std::vector<double> areaPowers{};                         ///< of the lights that geometry brought: what the light sampler goes by
};

/// Which parts of a scene an integrator looks at.
bool countsMedia(const IntegratorDescription&);
bool countsMaterials(const IntegratorDescription&);   ///< and lights
bool samplesLights(const IntegratorDescription&);
/// Whether paths scatter as BSDFs do from every surface, so that they find by themselves what shines from everywhere.
bool followsBsdfs(const IntegratorDescription&);

/// The integrator's numbers; warns of what it stands for, and of media that it leaves out.
void packIntegrator(Packer&, bool hasUnusedMedia);
void packCamera(Packer&);
void packMedia(Packer&);
/// What fills bodies of a material.
uint packInterior(Packer&, const std::shared_ptr<const Medium>&, const std::string& why);
void packMaterials(Packer&);
/// What the hierarchies over the shapes are to be built of.
Hierarchies packGeometry(Packer&);
/// Everything but area lights, which geometry brings; then the light sampler.
void packLights(Packer&);
/// Lights that are points, for media; after the lights.
void packEquiangularLights(Packer&);

/// What becomes of a texture's value.
enum class TextureUse {
    asItIs,
    coefficient /* colours are no reflectances, and may be larger than 1 */,
    reflectance /* brought into [0, 1] */,
    regularWidth /* a microfacet width, regularized */,
    regularRoughness /* the same of a roughness */,
    roughness /* its square root */,
    metal /* a reflectance to an index of refraction */,
    displacement /* world units to scene units */
};
/// The program of a texture, made when first asked for.
uint packTexture(Packer&, int texture, TextureUse use = TextureUse::asItIs);
/// The same of a texture or a plain number.
uint packInput(Packer&, const Input& input);
/// The program of an area light's image: radiance relative to the image's mean.
uint packEmissionImage(Packer&, const AreaLight&);
/// Mean luminance of an image.
double meanLuminance(Packer&, int image);
/// The same of a texture or a plain colour.
uint packColorInput(Packer&, const Input& input, TextureUse use);
/// An image as textures read it; asFloat: of one channel.
uint packImage(Packer&, int image, bool asFloat);
/// A measured BSDF. Throws SceneError if the file is not one.
uint packMeasured(Packer&, const std::string& path, const SourceLocation& where);
/// The material of a shape.
uint packedMaterial(Packer&, int material);

/// Whether a surface with this BSDF scatters light from behind it, or lets it through with another index of refraction.
bool transmits(next_queue h);

/// The lights of a shape that emits, one for each of its elements; sets its first_light. `m` takes its object space to scene space.
void packAreaLight(Packer&, const Shape&, shape& packed, const glm::dmat4& m, size_t elements);

}  // namespace eikonal
