#pragma once
// Light that paths from the camera miss: how a study finds it.

#include <string>
#include <vector>

namespace eikonal {

class Session;
struct IntegratorKind;

/// The integrator for an image with the light that paths from the camera miss, or would miss if the scene did not trace light paths: bdpt,
/// or vcm where bdpt misses some of it for good. Null: there is no such light, no light paths can be traced, or the user's integrator
/// renders a part of light transport only. `session`: of the user's own options, packed; `scene` and `options`: what it was made from.
/// Packs the scene once more. Throws Error.
const IntegratorKind* followerOf(const Session& session, const std::string& scene, const std::vector<std::string>& options);

}  // namespace eikonal
