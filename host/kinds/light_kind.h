#pragma once
// The host's side of each kind of light: one file in host/kinds/light/ for each line of LIGHTS (include/eikonal/lights.h).

#include "eikonal/light.h"
#include "eikonal/lights.h"
#include "feature_set.h"

#include <span>
#include <string>

namespace eikonal {

struct AreaElement;
struct Light;
struct LightBounds;
struct LightPacking;
struct PackedLight;
namespace pbrt { struct LightReading; }

/// What a kind's file defines. AREA kinds define `packElement`, the others `pack`; AREA and POINT kinds define `bound`; a kind with a
/// `directive` defines `read` (tests/unit/kinds_test.cpp).
struct LightTraits {
    /// `LightSource "directive"` in a pbrt scene and its parameters, a row of read/pbrt/kinds.h. Null: no directive of its own. `read`
    /// fills in the kind's fields; the others are already set. It returns false to skip a light whose image is missing (already
    /// reported), and throws SceneError.
    const char* directive = nullptr;
    const char* parameters = "";
    bool (*read)(const pbrt::LightReading&, Light&) = nullptr;
    /// Whether the light's rotation matters; if so, its transform must be invertible.
    bool hasDirections = true;

    /// Packs a light without a shape for the device. May throw SceneError.
    PackedLight (*pack)(const LightPacking&, const Light&) = nullptr;
    /// Packs one element of a shape that emits the radiance L.
    light (*packElement)(const AreaElement&, const color& L) = nullptr;

    /// Bounds for the light tree, of a light with total `power` that is not infinitely far away. `bounds` already holds the light's point
    /// p, its normal n as the axis, and the intensity of a flat area.
    void (*bound)(const light&, double power, LightBounds& bounds) = nullptr;

    /// AREA kinds: whether a light sample is only a direction, along which test_shadows finds the point.
    bool isAimedByDirection = false;

    /// Whether BSDF sampling finds it as well as light sampling does. The light sampler then skips it (Karlík et al. 2019, "MIS
    /// compensation"), unless the environment guide samples it.
    bool isLeftToBsdfs = false;

    /// Whether light paths may begin there.
    bool startsPaths = true;
};

/* One for each kind, defined in the kind's file. */
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

/// All kinds, indexed by light_kind.
std::span<const LightKind> lightKindList();
inline const LightKind& kindOf(light_kind kind) { return lightKindList()[kind]; }
inline const LightKind& kindOf(const light& l) { return lightKindList()[l.kind]; }

}  // namespace eikonal
