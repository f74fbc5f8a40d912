#pragma once
// What the host knows of each kind of light: one file of host/kinds/light/ for each line of LIGHTS (include/eikonal/lights.h).

#include "eikonal/lights.h"
#include "feature_set.h"

#include <span>
#include <string>

namespace eikonal {

struct AreaElement;
struct Light;
struct LightBounds;
struct PackedLight;
struct Packer;
namespace pbrt { struct LightReading; }

/// What a kind's file defines. All but `bound` may be left out by kinds that do not need it.
struct LightTraits {
    /// `LightSource "directive"` of a pbrt scene, its parameters as a row of read/pbrt/kinds.h, and what reads them into a light whose
    /// other fields are filled in. Null: no directive of its own. `read` returns false for a light to be left out, since its image is
    /// missing, which has been noted; it throws SceneError.
    const char* directive = nullptr;
    const char* parameters = "";
    bool (*read)(const pbrt::LightReading&, Light&) = nullptr;
    /// Whether it depends on the rotation of its space, which then must be invertible.
    bool hasDirections = true;

    /// A light without a shape, for the device. May throw SceneError.
    PackedLight (*pack)(Packer&, const Light&) = nullptr;
    /// One element of a shape that emits the radiance L.
    light (*packElement)(const AreaElement&, const color& L) = nullptr;

    /// Bounds for the light tree, of a light that emits `power` in all and is not infinitely far away. `bounds` holds the light's point p,
    /// its normal n as the axis, and the intensity of a flat area.
    void (*bound)(const light&, double power, LightBounds& bounds) = nullptr;

    /// Whether paths that follow BSDFs find it at least as well as light samples do, so that the light sampler leaves it to them (Karlík et
    /// al. 2019, "MIS compensation"), unless the environment guide aims at it.
    bool isLeftToBsdfs = false;
};

/* Each kind's file defines one of them. */
#define DECLARE_KIND(name, FEATURE, PLACE) extern const LightTraits name##_light;
LIGHTS(DECLARE_KIND)
#undef DECLARE_KIND

enum class LightPlace { POINT, DISTANT, AREA, INFINITE };   ///< as in LIGHTS

/// A line of LIGHTS.
struct LightKind {
    const char* name;
    light_kind value;
    Feature feature;
    LightPlace place;
    const LightTraits& traits;
};

/// All kinds, by light_kind.
std::span<const LightKind> lightKindList();
inline const LightKind& kindOf(light_kind kind) { return lightKindList()[kind]; }
inline const LightKind& kindOf(const light& l) { return lightKindList()[l.kind]; }

}  // namespace eikonal
