#pragma once
// Tells whether a file is still the one that was there before.

#include <cstdint>
#include <string>

namespace eikonal {

/// What a file was when it was looked at: its place on the disk and when it was last changed. All 0: there was none.
struct FileMark {
    std::uint64_t device = 0, inode = 0;
    std::int64_t seconds = 0, nanoseconds = 0;
    static FileMark of(const std::string& path);
    bool operator==(const FileMark&) const = default;
};

/// A name of no file yet, beside `path`: "image-2.film" beside "image.film", or with the next number that is free.
std::string nameBeside(const std::string& path);

}  // namespace eikonal
