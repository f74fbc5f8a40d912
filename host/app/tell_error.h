#pragma once
// Errors that end a command, or one render of several.

#include <string>

namespace eikonal {

/// Tells the exception that is being handled, and returns the exit status that it stands for. Called in a catch clause. Errors in scenes
/// and files already begin with file:line:column, so they get no prefix. scene: what was not rendered, if others may have been.
int tellError(const std::string& scene = {});

}  // namespace eikonal
