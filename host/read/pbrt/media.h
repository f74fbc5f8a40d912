#pragma once
// The named media of a scene.

#include "error.h"
#include "read/pbrt/kinds.h"
#include "read/pbrt/parameters.h"
#include "read/pbrt/reading.h"
#include "scene/basics.h"
#include "read/pbrt/state.h"

#include <map>
#include <string>
#include <vector>

namespace eikonal::pbrt {

const KindTable& mediumKinds();

/// The media of a scene. They may be used before their definition, so a medium first has a number in this registry; at the end the number
/// becomes an index into Scene::media.
class MediumRegistry {
public:
    explicit MediumRegistry(Reading& reading) : reading_(reading) {}

    /// The number of a medium, defined or not; none for the empty name, which means vacuum.
    int numberOf(const std::string& name);

    /// Defines a medium in Scene::media. Throws SceneError.
    void define(const std::string& name, const GraphicsState& state, ParameterList parameters, const SourceLocation& where);

    /// The index in Scene::media of a number (none stays none; none for a medium that is not rendered). Notes a problem, once per medium,
    /// if it was never defined; `where` is the use.
    int resolve(int number, const SourceLocation& where);

private:
    struct Entry { std::string name; bool made = false, missed = false; int index = none; SourceLocation where; };

    Reading& reading_;
    std::map<std::string, int> numbers_;
    std::vector<Entry> entries_;
};

}  // namespace eikonal::pbrt
