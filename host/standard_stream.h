#pragma once
// The file name "-": standard input as a scene, standard output as an image.

#include <span>
#include <string>

namespace eikonal {

inline bool isStandardStream(const std::string& path) { return path == "-"; }

/// Throws Error (ExitCode::scene) if standard output is a terminal, which an image would garble.
void checkStandardOutput();
/// Writes all bytes. Throws Error (ExitCode::scene) with the reason; also if the reader has gone.
void writeToStandardOutput(std::span<const unsigned char> content);

}  // namespace eikonal
