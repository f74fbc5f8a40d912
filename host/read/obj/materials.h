#pragma once
// Converts the materials of a .mtl file. docs/obj.md describes the mapping for users.

#include "diagnostics.h"
#include "read/formats/loose_files.h"
#include "read/obj/mtl.h"
#include "scene/scene.h"

#include <string>
#include <vector>

namespace eikonal {

/// Finds files that an OBJ or MTL file names. Collects missing files, so that all are reported at once.
class ObjFiles {
public:
    explicit ObjFiles(Diagnostics& diagnostics, MissingFiles missing = MissingFiles::error)
        : diagnostics_(diagnostics), allowsMissing_(missing == MissingFiles::magenta) {}
    /// Whether an image that is missing becomes magenta.
    bool allowsMissing() const { return allowsMissing_; }

    /// The path of the file that is called so at `where`: absolute, or relative to the folder of the file there; else, with a warning, of
    /// one that is probably meant (read/formats/loose_files.h). Empty if there is none. Throws a SceneError instead of that warning if the
    /// diagnostics are strict.
    std::string find(const std::string& name, const SourceLocation& where);

    /// Same as find, but notes an error at `where` if the file does not exist.
    std::string require(const std::string& name, const SourceLocation& where);

    /// Throws one Error that lists all missing files, if there are any.
    void throwMissing() const;

private:
    Diagnostics& diagnostics_;
    bool allowsMissing_;
    std::vector<std::string> missing_;
};

/// What all shapes with a material share.
struct ObjMaterial {
    int material = none;                        ///< in Scene::materials
    Input alpha{Spectrum::constant(1)};
    int areaLight = none;                       ///< in Scene::areaLights; one-sided, see obj.cpp
    bool usesUvs = false;                       ///< whether some texture needs texture coordinates
};

/// Adds the material, its textures, images and light to the scene. textureSize: the side length of the texture on the surfaces with this
/// material, in world units (bump maps are relative to it).
ObjMaterial addMaterial(Scene& scene, const MtlMaterial& mtl, double textureSize, ObjFiles& files, Diagnostics& diagnostics);

/// The material of faces without one: diffuse, 0.5.
ObjMaterial addDefaultMaterial(Scene& scene);

}  // namespace eikonal
