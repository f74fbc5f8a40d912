#pragma once
// Which choices make an image converge to something other than the scene's light transport.

#include "pack/tables.h"
#include "scene/scene.h"

#include <string>
#include <vector>

namespace eikonal {

struct BiasedChoice {
    std::string what;    ///< "RGB colour"
    std::string remedy;  ///< the options without it: "--color=spectral"
};

/// Of an image that has been denoised.
inline const BiasedChoice denoisingChoice = {"denoising", "no --denoise; the layer noisy"};

/// What the integrator computes instead of the whole light transport equation; empty: all of it but paths of more than maxdepth bounces.
std::string partOfTransport(const Scene& scene);

/// The biased choices of a scene that has been packed. mergeRadius: within which its vertices merge in the first pass, if they do, world
/// units. compilerFlags: of the OpenCL compiler, as the user gave them.
std::vector<BiasedChoice> biasedChoices(const Scene& scene, const PackedScene& packed, double mergeRadius,
                                        const std::string& compilerFlags);

/// Those of `compilerFlags` that let the compiler reorder sums.
std::vector<std::string> inexactFlags(const std::string& compilerFlags);

/// "RGB colour (without it: --color=spectral); ..."; empty: none.
std::string describe(const std::vector<BiasedChoice>& choices);
/// What describe() returned, with one more choice if it is not there.
std::string withChoice(const std::string& described, const BiasedChoice& choice);

}  // namespace eikonal
