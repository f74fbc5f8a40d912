#pragma once
// Every kind of pixel filter. A filter is a table on the device (host/pack/camera.cpp), so its kind is known on the host alone.

#include <span>

namespace eikonal {

struct FilterDescription;
namespace pbrt { class Arguments; }

/// A `PixelFilter "name"` of a pbrt scene.
struct FilterKind {
    const char* name;
    const char* parameters;   ///< a row of read/pbrt/kinds.h, besides the radii, which each has
    /// Reads what is more than the radii. Null: there is no more.
    void (*read)(const pbrt::Arguments&, FilterDescription&);
    /// The value of one axis at a distance of 0 <= x < radius pixels from the centre.
    double (*eval)(const FilterDescription&, double x, double radius);
};

extern const FilterKind box_filter, triangle_filter, gaussian_filter, mitchell_filter, sinc_filter;
std::span<const FilterKind* const> filterKindList();

}  // namespace eikonal
