#pragma once
// The materials of a scene, named or unnamed.

#include "read/pbrt/arguments.h"
#include "read/pbrt/state.h"
#include "read/pbrt/textures.h"

#include <deque>
#include <map>
#include <memory>
#include <string>

namespace eikonal::pbrt {

const KindTable& materialKinds();

/// The materials of a scene. Named materials and their textures may be used before their definition, so a material first has a number in
/// this registry; at the end the number becomes an index into Scene::materials.
class MaterialRegistry {
public:
    MaterialRegistry(Reading& reading, TextureRegistry& textures)
        : reading_(reading), nesting_(reading.problems, "materials"), textures_(textures) {}

    /// The number of a named material, defined or not.
    int numberOf(const std::string& name);

    /// Defines a material; an empty name makes it unnamed. Returns its number. Throws SceneError.
    int define(const std::string& name, const std::string& kind, const GraphicsState& state, ParameterList parameters,
               const SourceLocation& where);

    /// The index in Scene::materials of a number (none stays none). Notes a problem, once per material, if it was never defined.
    int resolve(int number, const SourceLocation& where);

    /// The same of a name.
    int named(const std::string& name, const SourceLocation& where);

    /// Builds the materials that are not used.
    void finish();

private:
    struct Entry {
        std::string name;
        std::unique_ptr<Arguments> arguments;  ///< null: not defined (yet)
        int index = none;                      ///< in Scene::materials, once it is built
        int height = 0;                        ///< as Nesting counts it, once it is built
        bool beingBuilt = false, missed = false;
    };

    void build(Entry& entry, Material& material);
    void readInputs(const Arguments& arguments, Material& material);
    /// A metal is given by its reflectance or by its indices. Throws SceneError if both are given.
    void preferReflectance(const Arguments& arguments, Material& material);
    int normalMap(const Arguments& arguments);

    Reading& reading_;
    Nesting nesting_;
    TextureRegistry& textures_;
    std::map<std::string, int> numbers_;
    std::deque<Entry> entries_;  ///< by number; a deque, because building an entry may add another and references must stay valid
};

}  // namespace eikonal::pbrt
