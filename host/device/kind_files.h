#pragma once
// Generates the includes of a family's kinds: `#include "light/kinds.clh"` expands to one #include per line of LIGHTS.

#include <optional>
#include <string>

namespace eikonal {

/// The text of "<family>/kinds.clh": includes kernels/<family>/<kind>.clh for each kind of the family's list (include/eikonal), in its
/// order, and mentions their features, so that a program is built with them. Nothing if no family has a list of that name.
std::optional<std::string> kindFiles(const std::string& name);

}  // namespace eikonal
