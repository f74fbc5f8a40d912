#pragma once
// Which of the renders of a call one is.

#include <cstddef>
#include <optional>

namespace eikonal {

struct RenderPlace {
    std::size_t number = 1, inAll = 1;  ///< number: from 1
    std::optional<int> frame;           ///< of an animation
};

}  // namespace eikonal
