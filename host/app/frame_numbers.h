#pragma once
// Frames of an animation: their numbers, and the numbers in the names of files.

#include <string>
#include <vector>

namespace eikonal {

/// A call renders at most so many frames.
inline constexpr int mostFrames = 100'000;

/// "1-10:2,20": numbers from 0, ranges and ranges with a step, as Open Job Description writes them; in the order given, each number once.
/// Throws a UsageError that names the option, what was found, and what would have worked.
std::vector<int> parseFrames(const std::string& option, const std::string& text);

/// Whether the name of a file (not its folder) has a place for the number of a frame: one or more #.
bool hasFramePlace(const std::string& path);
/// The path with each run of # in the file's name replaced by the number, with zeros before it up to the length of the run.
std::string withFrame(const std::string& path, int frame);

/// The numbers as the shortest list, "1-3, 7". `frames`: ascending.
std::string frameRanges(const std::vector<int>& frames);

}  // namespace eikonal
