#pragma once
// Short texts of pbrt-v4 read into scenes, and what is said about those that are wrong.

#include "read/pbrt/read_pbrt.h"
#include "unit/temporary_folder.h"

#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace eikonal {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Reads texts as if they were test.pbrt in a folder of the test's own. Warnings are kept, not printed.
class PbrtTest : public TemporaryFolder {
protected:
    Scene read(const std::string& text, bool strict = false) {
        Diagnostics diagnostics(LogLevel::silent, strict);
        const auto keep = [&] { warnings_ = diagnostics.warnings(); };
        try {
            Scene scene = readPbrtText(text, "test.pbrt", folder_.string(), diagnostics, missing_);
            keep();
            return scene;
        } catch (...) {
            keep();
            throw;
        }
    }
    /// The same of a text whose first line is WorldBegin.
    Scene world(const std::string& text) { return read("WorldBegin\n" + text); }

    /// The message of the error that a text ends in; "no error" if there is none.
    std::string errorOf(const std::string& text, bool strict = false) {
        try {
            read(text, strict);
            return "no error";
        } catch (const SceneError& error) { return error.what(); }
    }
    std::string errorOfWorld(const std::string& text, bool strict = false) { return errorOf("WorldBegin\n" + text, strict); }

    std::vector<std::string> warningsOfWorld(const std::string& text) {
        world(text);
        return warnings_;
    }

    std::vector<std::string> warnings_;  ///< of the last text that was read
    MissingFiles missing_ = MissingFiles::error;
};

inline void expectNear(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-6) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

/// Where a transform takes a point.
inline glm::dvec3 apply(const Transform& transform, glm::dvec3 p) { return glm::dvec3(transform * glm::dvec4(p, 1)); }

}  // namespace eikonal
