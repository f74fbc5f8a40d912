#pragma once
// Makes vectors of the hierarchy's tables skip zero-initialisation, since threads fill them. Every file that uses these tables must
// include this.

#include "eikonal/bvh.h"
#include "memory_pages.h"

namespace eikonal {

template <> constexpr inline bool staysUninitialized<bvh_node> = true;
template <> constexpr inline bool staysUninitialized<triangle_line> = true;

}  // namespace eikonal
