#pragma once
// Named textures, and parameters that may be textures.

#include "eikonal/textures.h"
#include "read/pbrt/arguments.h"
#include "read/pbrt/nesting.h"
#include "read/pbrt/state.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace eikonal::pbrt {

/// The kinds of float or of spectrum textures.
const KindTable& textureKinds(bool isFloat);
/// What replaces a texture that is not rendered, as a clause for a message: a parameter or a number, from the row's standIn.
std::string textureStandIn(const Kind& kind);

/// The textures of a scene. They may be used before their definition, so each is built at its first use after the file is read.
class TextureRegistry {
public:
    explicit TextureRegistry(Reading& reading) : reading_(reading), nesting_(reading.problems, "textures") {}

    /// Defines a texture. Throws SceneError if the name and type are taken, or for an unknown kind.
    void define(const std::string& name, bool isFloat, const std::string& kind, const GraphicsState& state, ParameterList parameters,
                const SourceLocation& where);

    /// The index of a texture in Scene::textures. Throws SceneError if there is none of that name and type, or if it refers to itself.
    int find(const std::string& name, bool isFloat, const SourceLocation& where);

    /// The value or texture of a parameter; `fallback` if it is not given and has no default.
    Input input(const Arguments& arguments, const std::string& name, const Spectrum& fallback = Spectrum());
    /// The texture that a parameter names; none if it is a number or not given.
    int textureOf(const Arguments& arguments, const std::string& name);
    /// The texture that a parameter of type texture names.
    int textureOf(const Parameter& parameter, bool isFloat);

    /// The index of an image file in Scene::images, where it is added once.
    int image(const ImageFile& file);

    /// Adds a spectrum texture that the reader makes.
    Input derive(Texture texture);
    Input derive(texture_kind kind, std::vector<Input> operands, const SourceLocation& where);
    /// The input times a factor.
    Input scaled(const Input& input, double factor);

    /// Builds the textures that are not used.
    void finish();

private:
    using Key = std::pair<std::string, bool>;  ///< name, whether float
    struct Definition {
        Arguments arguments;
        Transform worldFromTexture;
        int index = none;        ///< in Scene::textures, once it is built
        int height = 0;          ///< as Nesting counts it, once it is built
        bool beingBuilt = false;
    };

    int build(const Key& key, Definition& definition);
    /// Sets the kind and what it reads. Throws SceneError.
    void read(const Definition& definition, Texture& texture);
    Input standIn(const Arguments& arguments);

    Reading& reading_;
    Nesting nesting_;
    std::map<Key, Definition> definitions_;
    std::vector<Key> order_;
};

}  // namespace eikonal::pbrt
