#pragma once
// What a material of a .mtl file becomes. The mapping is described for users in docs/obj.md.

#include "diagnostics.h"
#include "read/obj/mtl.h"
#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace eikonal {

/// Finds files that an OBJ or MTL file names. Keeps what was not found, so that all of it can be reported at once.
class ObjFiles {
public:
    /// Files are looked for as named (relative to the folder of `beside`), and then by their last part alone in that folder.
    /// Empty if there is none.
    static std::string find(const std::string& name, const std::filesystem::path& beside);

    /// As find; but if there is none, notes an error at that place.
    std::string require(const std::string& name, const SourceLocation& where);

    /// Throws one Error with all that was not found, if there was anything.
    void throwMissing() const;

private:
    std::vector<std::string> missing_;
};

/// What the shapes with one material have in common.
struct ObjMaterial {
    int material = none;                        ///< in Scene::materials
    Input alpha{Spectrum::constant(1)};
    int areaLight = none;                       ///< in Scene::areaLights; one-sided, see ObjReader
    bool usesUvs = false;                       ///< some texture needs texture coordinates
};

/// Adds the material, its textures, images and light to the scene. textureSize: how long a side of the texture is on the surfaces that have
/// the material, in world units (bump maps are relative to it).
ObjMaterial addMaterial(Scene& scene, const MtlMaterial& mtl, double textureSize, ObjFiles& files, Diagnostics& diagnostics);

/// The grey of faces without a material: diffuse, 0.5.
ObjMaterial addDefaultMaterial(Scene& scene);

}  // namespace eikonal
