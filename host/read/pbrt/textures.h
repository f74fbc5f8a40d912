#pragma once
// Named textures, and the parameters that may be one.

#include "read/pbrt/arguments.h"
#include "read/pbrt/state.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace eikonal::pbrt {

/// The kinds of float or of spectrum textures.
const KindTable& textureKinds(bool isFloat);
/// What happens instead of a texture that is not rendered: the row's standIn, a parameter or a number, as a clause for a message.
std::string textureStandIn(const Kind& kind);

/// The textures of a scene. They may be used before they are defined, so they are built at the end, each when it is first used.
class TextureRegistry {
public:
    explicit TextureRegistry(Reading& reading) : reading_(reading) {}

    /// Notes a texture. Throws SceneError if there is one of that name and type, or no such kind.
    void define(const std::string& name, bool isFloat, const std::string& kind, const GraphicsState& state, ParameterList parameters,
                const SourceLocation& where);

    /// A texture's index in Scene::textures. Throws SceneError if there is none of that name and type, or if it is made of itself.
    int find(const std::string& name, bool isFloat, const SourceLocation& where);

    /// The value or texture of a parameter wanted as one. With neither given nor a default: `fallback`.
    Input input(const Arguments& arguments, const std::string& name, const Spectrum& fallback = Spectrum());
    /// The texture that a parameter names; none if it gives a number, or is not given.
    int textureOf(const Arguments& arguments, const std::string& name);
    /// The texture that a parameter of type texture names.
    int textureOf(const Parameter& parameter, bool isFloat);

    /// The index in Scene::images of an image file, which is added if it is not there.
    int image(const ImageFile& file);

    /// A texture that the program makes for itself, of spectra.
    Input derive(decltype(Texture::kind) kind, const SourceLocation& where);
    /// The input times a factor.
    Input scaled(const Input& input, double factor);

    /// Builds those that nobody has used.
    void finish();

private:
    using Key = std::pair<std::string, bool>;  ///< name, whether it is float
    struct Definition {
        Arguments arguments;
        Transform worldFromTexture;
        int index = none;        ///< in Scene::textures, once it is built
        bool beingBuilt = false;
    };

    int build(const Key& key, Definition& definition);
    decltype(Texture::kind) makeKind(const Definition& definition);
    decltype(Texture::kind) makeImagemap(const Definition& definition);
    Input standIn(const Arguments& arguments);

    Reading& reading_;
    std::map<Key, Definition> definitions_;
    std::vector<Key> order_;
};

}  // namespace eikonal::pbrt
