#pragma once
// The slots of the parameters of BSDFs.

#include "eikonal/bsdfs.h"
#include "eikonal/stages.h"

namespace eikonal {

// Slots of every BSDF's parameters, from the lists: slot_diffuse::reflectance. A slot is the index of its first word in RGB
// rendering plus spectrumBefore times the number of spectra before it, which are longer in spectral rendering.
constexpr uint spectrumBefore = 256;
#define STEP_uint 1
#define STEP_float 1
#define STEP_spectrum (CHANNELS_RGB + spectrumBefore)
#define PARAMETER_SLOT(q, type, name, FEATURE) name, name##_last = name + STEP_##type - 1,
constexpr uint wordOf(uint slot, bool spectral) {
    return slot % spectrumBefore + (spectral ? (CHANNELS_SPECTRAL - CHANNELS_RGB) * (slot / spectrumBefore) : 0);
}
#define PARAMETER_SLOTS(bsdf, FEATURE, PARAMETERS) \
    namespace slot_##bsdf { enum : uint { PARAMETERS(PARAMETER_SLOT, bsdf) words }; }
BSDFS(PARAMETER_SLOTS)

/// The words of the parameters of the BSDF that shades what goes to `next`, a next_queue; 0: none does.
constexpr uint bsdfParameterWords(uint next, bool spectral) {
#define WORDS_OF(bsdf, FEATURE, PARAMETERS) if (next == next_##bsdf) return wordOf(slot_##bsdf::words, spectral);
    BSDFS(WORDS_OF)
#undef WORDS_OF
    return 0;
}

}  // namespace eikonal
