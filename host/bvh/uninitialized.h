#pragma once
// Tables of the hierarchy that many threads fill, as every file that has such tables must know them.

#include "eikonal/bvh.h"
#include "memory_pages.h"

namespace eikonal {

template <> constexpr inline bool staysUninitialized<bvh_node> = true;
template <> constexpr inline bool staysUninitialized<triangle_line> = true;

}  // namespace eikonal
