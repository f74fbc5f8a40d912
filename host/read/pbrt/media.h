#pragma once
// Named media.

#include "read/pbrt/arguments.h"
#include "read/pbrt/state.h"

#include <map>
#include <string>
#include <vector>

namespace eikonal::pbrt {

const KindTable& mediumKinds();

/// The media of a scene. They may be named before they are made, so names become numbers of this book, and those become
/// indices of Scene::media at the end.
class MediumRegistry {
public:
    explicit MediumRegistry(Reading& reading) : reading_(reading) {}

    /// The number of a name; none for the empty one, which is vacuum.
    int numberOf(const std::string& name);

    /// Makes a medium, in Scene::media. Throws SceneError.
    void define(const std::string& name, const GraphicsState& state, ParameterList parameters, const SourceLocation& where);

    /// The index in Scene::media of a number (none stays none; so is a medium that is not rendered).
    /// Notes a problem, once for each, if it was never made: `where` uses it.
    int resolve(int number, const SourceLocation& where);

private:
    struct Entry { std::string name; bool made = false, missed = false; int index = none; SourceLocation where; };

    Reading& reading_;
    std::map<std::string, int> numbers_;
    std::vector<Entry> entries_;
};

}  // namespace eikonal::pbrt
