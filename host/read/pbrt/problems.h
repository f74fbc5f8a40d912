#pragma once
// All that is wrong with a scene, gathered so that the user sees it at once.

#include "error.h"

#include <set>
#include <string>
#include <vector>

namespace eikonal::pbrt {

/// Text that pbrt-v3 reads and pbrt-v4 does not: it ends the reading, since everything after it would be wrong as well.
struct Version3Error : SceneError {
    /// `what` belongs to pbrt-v3, and is now called `successor` (null: there is none).
    Version3Error(const SourceLocation& where, const std::string& what, const char* successor = nullptr);
};

class Problems {
public:
    void add(const SourceLocation& where, const std::string& message);
    void add(const SceneError& error);
    /// A file that the scene names and that is not there. Each is listed once.
    void addMissingFile(const SourceLocation& where, const std::string& name);

    /// Runs f; a SceneError that it throws is added, but for a Version3Error.
    template <class F> void guard(F&& f) {
        try {
            f();
        } catch (const Version3Error&) { throw; } catch (const SceneError& error) { add(error); }
    }

    /// Throws one SceneError that lists all problems, if there are any: missing files last.
    void throwIfAny() const;

private:
    std::vector<std::string> messages_, missing_;
    std::set<std::string> missingNames_;
};

}  // namespace eikonal::pbrt
