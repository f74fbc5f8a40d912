#include "render/implicit_doubts.h"

#include <fmt/format.h>

#include <algorithm>

namespace eikonal {

std::vector<std::string> describe(const ImplicitDoubts& counts, uint64_t paths) {
    std::vector<std::string> sentences;
    const auto rays = [](uint count, const char* what) { return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s"); };
    if (const uint count = counts[doubt_splits])
        sentences.push_back(fmt::format("{} at an implicit surface ran out of splits, so parts of that surface may be missing; "
                                        "use a smaller box or a simpler F",
                                        rays(count, "ray")));
    /* A few hits next to a sharp edge are always among so many, and do not show */
    if (const uint count = counts[doubt_sides]; count > std::max(16., 1e-5 * static_cast<double>(paths)))
        sentences.push_back(fmt::format("at {} of an implicit surface its other side was nearer than single precision resolves (2e-6 of "
                                        "the box's largest coordinate), so a transparent shell may be too dark; make it thicker, or use a "
                                        "surface without thickness (thindielectric)",
                                        rays(count, "hit")));
    return sentences;
}

}  // namespace eikonal
