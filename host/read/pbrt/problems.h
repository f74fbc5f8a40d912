#pragma once
// Collects the problems of a scene, so that the user sees all of them at once.

#include "error.h"

#include <set>
#include <string>
#include <vector>

namespace eikonal::pbrt {

/// Input that pbrt-v3 reads and pbrt-v4 does not. It ends the reading, because everything after it would be wrong, too.
struct Version3Error : SceneError {
    /// `what` belongs to pbrt-v3; pbrt-v4 has `successor` instead (null: nothing).
    Version3Error(const SourceLocation& where, const std::string& what, const char* successor = nullptr);
};

class Problems {
public:
    void add(const SourceLocation& where, const std::string& message);
    void add(const SceneError& error);
    /// Notes a missing file; each name is listed once.
    void addMissingFile(const SourceLocation& where, const std::string& name);

    /// Runs f and notes a SceneError that it throws; a Version3Error passes through.
    template <class F> void guard(F&& f) {
        try {
            f();
        } catch (const Version3Error&) { throw; } catch (const SceneError& error) { add(error); }
    }

    /// Throws one SceneError that lists all problems, missing files last, if there are any.
    void throwIfAny() const;

private:
    std::vector<std::string> messages_, missing_;
    std::set<std::string> missingNames_;
};

}  // namespace eikonal::pbrt
