#pragma once
// Shapes, objects and instances.

#include "error.h"
#include "read/pbrt/kinds.h"
#include "read/pbrt/parameters.h"
#include "read/pbrt/reading.h"
#include "scene/basics.h"
#include "scene/shapes.h"
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

/// A shape whose material, media, textures and file are yet to be resolved.
struct PendingShape {
    Shape shape;
    int plyFile = none;               ///< number of the PLY file with its mesh
    int object = none;                ///< in Scene::objects; none: not in an object
    int material, inside, outside;    ///< numbers in the registries
    std::optional<Parameter> alpha, displacement;
};

/// The shapes of a scene. Their materials, media, alpha textures and PLY files are resolved at the end.
class ShapeRegistry {
public:
    ShapeRegistry(Reading& reading, TextureRegistry& textures, MaterialRegistry& materials, MediumRegistry& media)
        : reading_(reading), textures_(textures), materials_(materials), media_(media), plyFiles_(reading) {}

    /// Adds a shape, to the open object if there is one. Throws SceneError.
    void add(const std::string& kind, const GraphicsState& state, ParameterList parameters, const SourceLocation& where);

    /// Begins and ends an object, which gets the shapes in between. Throws SceneError if an object is already open, none is open, or the
    /// name is taken.
    void beginObject(const std::string& name, const SourceLocation& where);
    void endObject(const SourceLocation& where);
    bool objectIsOpen() const { return openObject_ != none; }
    /// Shapes and instances so far.
    size_t placedCount() const { return pending_.size() + reading_.scene.instances.size(); }

    /// Adds an instance of an object, which may be defined later. Throws SceneError inside an object.
    void addInstance(const std::string& name, const GraphicsState& state, const SourceLocation& where);

    /// Fills Scene::shapes, objects and instances.
    void finish();

private:
    Input alphaOf(const Parameter& given);
    void place(PendingShape pending);
    int objectNamed(const std::string& name);

    Reading& reading_;
    TextureRegistry& textures_;
    MaterialRegistry& materials_;
    MediumRegistry& media_;
    PlyFiles plyFiles_;
    std::vector<PendingShape> pending_;
    std::map<std::string, int> objectNumbers_;
    std::vector<bool> objectIsMade_;
    int openObject_ = none;
};

}  // namespace eikonal::pbrt
