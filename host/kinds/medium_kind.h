#pragma once
// The host's side of each kind of medium: one file in host/kinds/medium/ for each line of MEDIA_KINDS (include/eikonal/media.h).

#include "eikonal/media.h"
#include "eikonal/medium.h"
#include "feature_set.h"

#include <span>

namespace eikonal {

struct Medium;
struct MediumPacking;
namespace pbrt { struct MediumReading; }

/// How a medium's emission is given.
enum class MediumEmission { none, spectrum, blackbody };   ///< blackbody: by a temperature (kelvin) at each point

/// What a kind's file defines.
struct MediumTraits {
    /// The parameters of a medium whose "type" is the kind's name: a row of read/pbrt/kinds.h, in parts. They include "g".
    const char* parameters[6] = {};
    /// Reads the fields that the kind uses; name, transform and g are already set. Returns false to skip a medium whose file is missing
    /// (already reported). Throws SceneError.
    bool (*read)(const pbrt::MediumReading&, Medium&) = nullptr;

    /// Packs the medium and its tables for the device; if HETEROGENEOUS, also its box and its majorants.
    medium (*pack)(const MediumPacking&, const Medium&) = nullptr;

    /// How this medium emits. Null: never.
    MediumEmission (*emission)(const Medium&) = nullptr;
};

/* One for each kind, defined in the kind's file. */
#define DECLARE_KIND(name, FEATURE, VARIATION) extern const MediumTraits name##_medium;
MEDIA_KINDS(DECLARE_KIND)
#undef DECLARE_KIND

enum class MediumVariation { HOMOGENEOUS, HETEROGENEOUS };   ///< as in MEDIA_KINDS

/// A line of MEDIA_KINDS.
struct MediumKind {
    const char* name;
    medium_kind value;
    Feature feature;
    MediumVariation variation;
    const MediumTraits& traits;
};

/// All kinds, indexed by medium_kind.
std::span<const MediumKind> mediumKindList();
inline const MediumKind& kindOf(medium_kind kind) { return mediumKindList()[kind]; }
inline const MediumKind& kindOf(const medium& m) { return mediumKindList()[m.kind]; }

MediumEmission emissionOf(const Medium&);

}  // namespace eikonal
