#pragma once
// Pixel filters. The device only gets a table of filter values (host/pack/camera.cpp), so only the host knows the kinds.

#include <span>

namespace eikonal {

struct FilterDescription;
namespace pbrt { class Arguments; }

/// A `PixelFilter "name"` of a pbrt scene.
struct FilterKind {
    const char* name;
    const char* parameters;   ///< a row of read/pbrt/kinds.h
    /// Reads the parameters other than the radii. Null: there are none.
    void (*read)(const pbrt::Arguments&, FilterDescription&);
    /// The filter along one axis, at a distance of 0 <= x < radius pixels from the centre.
    double (*eval)(const FilterDescription&, double x, double radius);
};

extern const FilterKind box_filter, triangle_filter, gaussian_filter, mitchell_filter, sinc_filter;
std::span<const FilterKind* const> filterKindList();

}  // namespace eikonal
