#pragma once
// Builds a scene from directives: keeps the graphics state, and passes descriptions to the registries.

#include "diagnostics.h"
#include "error.h"
#include "read/pbrt/parameters.h"
#include "scene/scene.h"
#include "read/pbrt/materials.h"
#include "read/pbrt/media.h"
#include "read/pbrt/reading.h"
#include "read/pbrt/settings.h"
#include "read/pbrt/shapes.h"
#include "read/pbrt/state.h"
#include "read/pbrt/textures.h"

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace eikonal::pbrt {

struct Builder {
    explicit Builder(Diagnostics& diagnostics, const std::string& folder) : reading(diagnostics, folder) {}

    Reading reading;
    TextureRegistry textures{reading};
    MaterialRegistry materials{reading, textures};
    MediumRegistry media{reading};
    ShapeRegistry shapes{reading, textures, materials, media};
    Settings settings{reading};
    GraphicsState state;
    bool inWorld = false;

    // Transforms. Each throws SceneError if it is invalid.
    void concatenate(const Transform& transform);                       ///< multiplied onto the active transforms
    void setTransform(const Transform& transform);
    void rotate(double degrees, glm::dvec3 axis, const SourceLocation& where);
    void lookAt(glm::dvec3 eye, glm::dvec3 at, glm::dvec3 up, const SourceLocation& where);
    void nameCoordinateSystem(const std::string& name) { coordinateSystems_[name] = state.transform; }
    void nameCameraSystem();                                            ///< "camera": world from camera
    void useCoordinateSystem(const std::string& name, const SourceLocation& where);

    // Blocks.
    void beginWorld();
    void beginAttributes(const SourceLocation& where);
    void endAttributes(const SourceLocation& where);
    void beginObject(const std::string& name, const SourceLocation& where);
    void endObject(const SourceLocation& where);

    /// Parameters for all later directives of a target, with lower priority than their own.
    void addAttributes(const std::string& target, ParameterList parameters, const SourceLocation& where);

    /// Calls `body`, which reads another file, with a copy of the state. Blocks that it leaves open are closed, and noted as problems.
    template <class Body> void importing(Body&& body) {
        const GraphicsState saved = state;
        const auto savedSystems = coordinateSystems_;
        std::vector<Block> outer;
        std::swap(outer, blocks_);
        body();
        closeBlocks();
        std::swap(outer, blocks_);
        state = saved;
        coordinateSystems_ = savedSystems;
    }

    /// Builds everything that had to wait for the end of the file, and returns the scene. Throws SceneError with all problems.
    Scene finish(const SourceLocation& end);

private:
    struct Block { GraphicsState saved; SourceLocation where; bool isObject; };
    void closeBlocks();

    std::vector<Block> blocks_;
    std::map<std::string, Motion> coordinateSystems_;
};

}  // namespace eikonal::pbrt
