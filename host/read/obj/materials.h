#pragma once
// Converts the materials of a .mtl file. docs/obj.md describes the mapping for users.

#include "diagnostics.h"
#include "read/formats/loose_files.h"
#include "read/obj/mtl.h"
#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace eikonal {

/// Finds files that an OBJ or MTL file names. Collects missing files, so that all are reported at once.
class ObjFiles {
public:
    explicit ObjFiles(MissingFiles missing = MissingFiles::error) : allowsMissing_(missing == MissingFiles::magenta) {}
    /// Whether an image that is missing becomes magenta.
    bool allowsMissing() const { return allowsMissing_; }

    /// Looks for `name` relative to the folder of `beside`, then for its last component in that folder, then for what is probably meant
    /// (read/formats/loose_files.h). Empty if there is none.
    static std::string find(const std::string& name, const std::filesystem::path& beside);

    /// Same as find, but notes an error at `where` if the file does not exist.
    std::string require(const std::string& name, const SourceLocation& where);

    /// Throws one Error that lists all missing files, if there are any.
    void throwMissing() const;

private:
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
