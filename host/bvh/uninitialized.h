#pragma once
// Marks the hierarchy's tables, which many threads fill, as uninitialised. Every file that uses these tables must include this.

#include "eikonal/bvh.h"
#include "memory_pages.h"

namespace eikonal {

template <> constexpr inline bool staysUninitialized<bvh_node> = true;
template <> constexpr inline bool staysUninitialized<triangle_line> = true;

}  // namespace eikonal
