#pragma once
// Files that are written completely or not at all.

#include <cstdint>
#include <span>
#include <string>

namespace eikonal {

/// Replaces a file's content: writes a temporary file in its folder and renames it. Follows a symbolic link and replaces its target. Throws
/// Error (ExitCode::scene), "cannot write "path": reason", and leaves the old file as it was.
void writeFileAtomically(const std::string& path, std::span<const unsigned char> content);
void writeTextAtomically(const std::string& path, const std::string& text);

/// Throws the same Error now if it is foreseeable: no folder, no permission, not a regular file, or fewer than `bytes` bytes free.
void checkFileWritable(const std::string& path, std::uint64_t bytes);

}  // namespace eikonal
