#pragma once
// How deeply textures refer to textures, and mixed materials to materials.

#include "read/pbrt/problems.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

namespace eikonal::pbrt {

/// Bounds chains of things that are built from others, which may be built meanwhile or before: code that follows them recurses.
class Nesting {
public:
    /// Beyond what any scene needs.
    static constexpr int most = 1000;

    /// `what` is built, for messages: "the textures". Reports chains to `problems`.
    Nesting(Problems& problems, std::string what) : problems_(problems), what_(std::move(what)) {}

    /// Calls `build`, which only throws what ends the reading. Returns the height of what it builds: 1 without parts; 0 if it is too high,
    /// which is reported once. Throws SceneError if too much is being built around it.
    template <class Build> int around(const SourceLocation& where, const Build& build) {
        if (level_ == most) {
            isTold_ = true;
            throw SceneError(where, message());
        }
        ++level_;
        const int outer = std::exchange(highest_, 0);
        build();
        int height = highest_ + 1;
        if (height > most) {
            if (!std::exchange(isTold_, true)) problems_.add(where, message());
            height = 0;
        }
        --level_;
        highest_ = std::max(outer, height);
        return height;
    }
    /// A part that is built already.
    void meet(int height) { highest_ = std::max(highest_, height); }

private:
    std::string message() const { return fmt::format("{} are nested in each other {} times here, and no more are read", what_, most); }

    Problems& problems_;
    std::string what_;
    int level_ = 0, highest_ = 0;
    bool isTold_ = false;
};

}  // namespace eikonal::pbrt
