#pragma once
// Numbers that a scene's kernels are built with, besides its features: how often a loop runs that has to be unrolled.

#include <sstream>
#include <string>

namespace eikonal {

/// C(macro, name, value that anything builds with)
#define SCENE_CONSTANTS(C) \
    C(ENVIRONMENTS,              environments,            0)  /* how many lights surround the scene */ \
    C(MEASURED_FILES,            measuredFiles,           1)  /* elements of `measured_files`, or 1 */ \
    C(MEASURED_ANGLE_STEPS,      measuredAngleSteps,      0)  /* to search the longest list of angles, by halves */ \
    C(MEASURED_FACET_STEPS,      measuredFacetSteps,      0)  /* and the longest side of the grids that facets are sampled from */ \
    C(MEASURED_BRIGHTNESS_STEPS, measuredBrightnessSteps, 0)  /* and of those of brightness */

struct SceneConstants {
#define MEMBER(MACRO, name, value) int name = value;
    SCENE_CONSTANTS(MEMBER)
#undef MEMBER

    /// Calls f(macro, number) for each.
    template <class F> void forEach(F&& f) { visit(*this, f); }
    template <class F> void forEach(F&& f) const { visit(*this, f); }

    /// All of them, for another process.
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
