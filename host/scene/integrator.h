#pragma once
// How light is carried to the camera: docs/integrators.md says what each computes.

#include "error.h"
#include "spectra/spectrum.h"

#include <string>
#include <utility>

namespace eikonal {

enum class IntegratorKind { volpath, path, direct, ambientOcclusion, simplePath, randomWalk };

/// As scenes and --integrator name them.
inline constexpr std::pair<const char*, IntegratorKind> integratorNames[] = {
    {"volpath", IntegratorKind::volpath}, {"path", IntegratorKind::path}, {"direct", IntegratorKind::direct},
    {"ambientocclusion", IntegratorKind::ambientOcclusion}, {"simplepath", IntegratorKind::simplePath}, {"simplevolpath", IntegratorKind::volpath},
    {"randomwalk", IntegratorKind::randomWalk}};

struct IntegratorDescription {
    IntegratorKind kind = IntegratorKind::volpath;
    std::string standsFor;                 ///< what the scene asks for, if this takes its place; otherwise empty
    int maxDepth = 5;                      ///< most scattering events on a path
    bool regularize = false;
    bool sampleLights = true;              ///< simplePath: whether lights are sampled; if not, paths have to find them by themselves
    bool sampleBsdf = true;                ///< simplePath: whether directions follow the BSDF; if not, they are uniform
    bool cosine = true;                    ///< ambientOcclusion: whether directions follow the cosine; if not, they are uniform
    double maxDistance = 0;                ///< ambientOcclusion: what is farther away does not occlude, world units; 0: everything does
    ColorSpace colorSpace = ColorSpace::srgb;  ///< ambientOcclusion: whose white the light has
    SourceLocation where;
};

}  // namespace eikonal
