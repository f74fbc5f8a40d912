#pragma once
// Constants that a scene's kernels are built with, besides its features: iterations of loops that are unrolled.

#include <sstream>
#include <string>

namespace eikonal {

/// C(macro, name, default value)
#define SCENE_CONSTANTS(C) \
    C(ENVIRONMENTS,              environments,            0)  /* number of infinite lights */ \
    C(MEASURED_FILES,            measuredFiles,           1)  /* size of `measured_files`, at least 1 */ \
    C(MEASURED_ANGLE_STEPS,      measuredAngleSteps,      0)  /* bisection steps in the longest list of angles */ \
    C(MEASURED_FACET_STEPS,      measuredFacetSteps,      0)  /* in the longest side of the grids that facets are sampled from */ \
    C(MEASURED_BRIGHTNESS_STEPS, measuredBrightnessSteps, 0)  /* in the longest side of the brightness grids */ \
    C(LIGHT_GROUP_COUNT,         lightGroups,             0)  /* number of light groups whose light the film keeps apart */ \
    C(ENERGY_TABLES,             energyTables,            1)  /* size of `energy_tables`, at least 1 */ \
    C(INTERLEAVED_RAYS,          interleavedRays,         4)  /* how many rays a work-item traverses in turns, at least 1 */

struct SceneConstants {
#define MEMBER(MACRO, name, value) int name = value;
    SCENE_CONSTANTS(MEMBER)
#undef MEMBER

    /// Calls f(macro, number) for each.
    template <class F> void forEach(F&& f) { visit(*this, f); }
    template <class F> void forEach(F&& f) const { visit(*this, f); }

    /// All constants as text, for another process.
    std::string text() const {
        std::string numbers;
        forEach([&](const char*, int number) { numbers += std::to_string(number) + "/"; });
        return numbers;
    }
    static SceneConstants fromText(const std::string& text) {
        SceneConstants constants;
        std::istringstream stream(text);
        constants.forEach([&](const char*, int& number) { stream >> number; stream.ignore(); });
        return constants;
    }

private:
    template <class Self, class F> static void visit(Self& self, F& f) {
#define VISIT(MACRO, name, value) f(#MACRO, self.name);
        SCENE_CONSTANTS(VISIT)
#undef VISIT
    }
};

}  // namespace eikonal
