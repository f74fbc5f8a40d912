#pragma once
// What the host knows of each kind of medium: one file of host/kinds/medium/ for each line of MEDIA_KINDS (include/eikonal/media.h).

#include "eikonal/media.h"
#include "feature_set.h"

#include <span>

namespace eikonal {

struct Medium;
struct Packer;
namespace pbrt { struct MediumReading; }

/// The light that a medium emits by itself.
enum class MediumEmission { none, spectrum, blackbody };   ///< blackbody: that of a temperature, in kelvin, at each point

/// What a kind's file defines.
struct MediumTraits {
    /// The parameters of a medium whose "type" is the kind's name: a row of read/pbrt/kinds.h, in parts. "g" is one of them.
    const char* parameters[6] = {};
    /// Reads the fields that the kind uses; name, transform and g are filled in. Returns false for a medium to be left out, since its file
    /// is missing, which has been noted. Throws SceneError.
    bool (*read)(const pbrt::MediumReading&, Medium&) = nullptr;

    /// The medium for the device, and its tables. HETEROGENEOUS: also its box and its majorants.
    medium (*pack)(Packer&, const Medium&) = nullptr;

    /// Null: it emits nothing.
    MediumEmission (*emission)(const Medium&) = nullptr;
};

/* Each kind's file defines one of them. */
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

/// All kinds, by medium_kind.
std::span<const MediumKind> mediumKindList();
inline const MediumKind& kindOf(medium_kind kind) { return mediumKindList()[kind]; }
inline const MediumKind& kindOf(const medium& m) { return mediumKindList()[m.kind]; }

MediumEmission emissionOf(const Medium&);

}  // namespace eikonal
