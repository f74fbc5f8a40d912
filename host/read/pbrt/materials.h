#pragma once
// Materials, named or not.

#include "read/pbrt/arguments.h"
#include "read/pbrt/state.h"
#include "read/pbrt/textures.h"

#include <array>
#include <deque>
#include <map>
#include <memory>
#include <string>

namespace eikonal::pbrt {

const KindTable& materialKinds();

/// The materials of a scene. Named ones may be used before they are made, and their textures too, so a material is a number of
/// this book at first, which becomes an index of Scene::materials at the end.
class MaterialRegistry {
public:
    MaterialRegistry(Reading& reading, TextureRegistry& textures) : reading_(reading), textures_(textures) {}

    /// The number of a named material.
    int numberOf(const std::string& name);

    /// Notes a material: a named one, or with an empty name an unnamed one. Returns its number. Throws SceneError.
    int define(const std::string& name, const std::string& kind, const GraphicsState& state, ParameterList parameters, const SourceLocation& where);

    /// The index in Scene::materials of a number (none stays none). Notes a problem, once for each, if it was never made.
    int resolve(int number, const SourceLocation& where);

    /// Builds those that nothing has used.
    void finish();

private:
    struct Entry {
        std::string name;
        std::unique_ptr<Arguments> arguments;  ///< null: not made (yet)
        int index = none;                      ///< in Scene::materials, once it is built
        bool beingBuilt = false, missed = false;
    };

    void build(Entry& entry, Material& material);
    void readInputs(const Arguments& arguments, Material& material);
    /// A metal is given by what it reflects or by its indices. Throws SceneError if it is by both.
    void preferReflectance(const Arguments& arguments, Material& material, const std::array<std::string, 2>& indices);
    void readMeasured(const Arguments& arguments, Material& material);
    void readMix(const Arguments& arguments, Material& material);
    int normalMap(const Arguments& arguments);

    Reading& reading_;
    TextureRegistry& textures_;
    std::map<std::string, int> numbers_;
    std::deque<Entry> entries_;  ///< by number; never moved, since building one may add another
};

}  // namespace eikonal::pbrt
