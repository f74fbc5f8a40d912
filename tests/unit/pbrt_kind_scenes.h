#pragma once
// A small scene for every kind that the pbrt reader knows, in which the kind's parameters can be given; values of all types for them.

#include "read/pbrt/kinds.h"

#include <string>
#include <vector>

namespace eikonal::pbrt {

/// A kind of one of the reader's tables, and the directive that takes it.
struct KindInPlace {
    const Kind* kind;
    std::string directive;  ///< all before the parameters: `Texture "t" "float" "bilerp"`
    std::string before;     ///< what the scene has before the directive, complete lines
    std::string after;      ///< what uses it
    /// The scene with these parameters, which stand for those of the same name that the kind cannot do without. The directive stands on a
    /// line of its own, which begins with it; `given` follows it after a blank.
    std::string scene(const std::string& given) const;
    /// The number of that line.
    int line() const;
};

/// All kinds of all tables.
std::vector<KindInPlace> allKinds();

/// Declarations with values other than the default, of which at least one must make a difference: "float radius" 0.3.
std::vector<std::string> otherValues(const KindInPlace& place, const Rule& rule, const std::string& name);

/// What else must be given for a parameter to have an effect; empty: nothing.
std::string companionOf(const KindInPlace& place, const std::string& name);

/// A declaration of this type, with some value.
std::string anyValue(ParameterType type, const std::string& name);

/// Writes the files that the scenes name.
void writeFilesOfScenes(const std::string& folder);

}  // namespace eikonal::pbrt
