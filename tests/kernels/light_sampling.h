#pragma once
// What a light's sample says arrives at a point, and what paths would say that meet the same place by themselves.

#include "eikonal/lights.h"
#include "device_function.h"

#include <glm/glm.hpp>

#include <vector>

namespace eikonal {

struct LightResult {
    spectrum L; vec3 wi; float distance, pdf; int isDelta;   ///< sample_light
    uint index;                                              ///< which light the sampler took
    float pdfHit;                                            ///< density that a path finds which meets that point by itself (areas)
    spectrum Le; float pdfEnvironment;                       ///< eval_x and pdf_x of wi (environments)
};

/// For each u, which chooses the light, and v.
std::vector<LightResult> sample(const PackedScene& scene, vec3 p, const std::vector<float>& u, const std::vector<vec2>& v);

/// With one light.
PackedScene sceneOf(const light& l);
/// One of RGB radiance or intensity (1, 2, 3), whole, and alone.
light newLight(light_kind kind);

static inline glm::dvec3 toGlm(vec3 v) { return {v.x, v.y, v.z}; }

}  // namespace eikonal
