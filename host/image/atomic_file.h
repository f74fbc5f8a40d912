#pragma once
// Files that appear whole or not at all.

#include <cstdint>
#include <span>
#include <string>

namespace eikonal {

/// Replaces the file's content: writes a temporary file in its folder, and renames it. A symbolic link stays, its target is replaced.
/// Throws Error (ExitCode::scene), "cannot write "path": reason", and then leaves what was there.
void writeFileAtomically(const std::string& path, std::span<const unsigned char> content);

/// Throws that Error now if it can be foreseen: no folder, not permitted, not a regular file, or fewer than `bytes` bytes free.
void checkFileWritable(const std::string& path, std::uint64_t bytes);

}  // namespace eikonal
