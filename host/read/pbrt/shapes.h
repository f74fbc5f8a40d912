#pragma once
// Shapes, and the objects and instances that they are gathered in.

#include "read/pbrt/arguments.h"
#include "read/pbrt/materials.h"
#include "read/pbrt/media.h"
#include "read/pbrt/meshes.h"
#include "read/pbrt/state.h"
#include "read/pbrt/textures.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace eikonal::pbrt {

const KindTable& shapeKinds();

/// The shapes of a scene. What they refer to (materials, media, alpha textures, PLY files) is known at the end.
class ShapeRegistry {
public:
    ShapeRegistry(Reading& reading, TextureRegistry& textures, MaterialRegistry& materials, MediumRegistry& media)
        : reading_(reading), textures_(textures), materials_(materials), media_(media), plyFiles_(reading) {}

    /// Notes a shape, in the object that is open if there is one. Throws SceneError.
    void add(const std::string& kind, const GraphicsState& state, ParameterList parameters, const SourceLocation& where);

    /// Opens and closes an object: shapes in between are its own. Throws SceneError: one is open already, none is open, or the
    /// name is taken.
    void beginObject(const std::string& name, const SourceLocation& where);
    void endObject(const SourceLocation& where);
    bool objectIsOpen() const { return openObject_ != none; }

    /// Places an object, which may be made later. Throws SceneError inside of an object.
    void addInstance(const std::string& name, const GraphicsState& state, const SourceLocation& where);

    /// Fills Scene::shapes, objects and instances.
    void finish();

private:
    struct Pending {
        Shape shape;
        int plyFile = none;               ///< its kind is in this file
        int object = none;                ///< in Scene::objects; none: seen as it is
        int material, inside, outside;    ///< numbers of the books
        std::optional<Parameter> alpha, displacement;
    };

    bool readKind(const Arguments& arguments, Pending& pending);
    void place(Pending pending);
    int objectNamed(const std::string& name);

    Reading& reading_;
    TextureRegistry& textures_;
    MaterialRegistry& materials_;
    MediumRegistry& media_;
    PlyFiles plyFiles_;
    std::vector<Pending> pending_;
    std::map<std::string, int> objectNumbers_;
    std::vector<bool> objectIsMade_;
    int openObject_ = none;
};

}  // namespace eikonal::pbrt
