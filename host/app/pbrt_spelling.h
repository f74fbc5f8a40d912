#pragma once
// Spellings of command lines that people bring from pbrt and other programs.

#include <string>
#include <vector>

namespace eikonal {

/// The arguments of a command, in our spelling: each that begins with - or -- and a letter, and has the letters of one of `options`
/// ("--cropwindow") but for case, dashes and underscores, as -crop_window or --Crop-Window, gets that name; a value behind = is kept. All
/// others are returned as they are.
std::vector<std::string> withOurSpelling(std::vector<std::string> arguments, const std::vector<std::string>& options);

/// What to do instead of an option of pbrt-v4 that we do not have; empty: it is none. `name` begins with dashes.
std::string insteadOf(const std::string& name);

}  // namespace eikonal
