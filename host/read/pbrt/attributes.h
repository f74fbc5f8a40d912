#pragma once
// Parameters of Attribute directives, which apply to all kinds of a target that have them.

#include "read/pbrt/reading.h"
#include "read/pbrt/state.h"

namespace eikonal::pbrt {

/// Reports a parameter that no kind of the target has. Throws SceneError if kinds have it with other types only.
void checkAttribute(Reading& reading, Target target, const Parameter& parameter);

}  // namespace eikonal::pbrt
