#pragma once
// Errors for the user: where, what was found, and what would have worked.

#include <memory>
#include <stdexcept>
#include <string>

namespace eikonal {

/// A place in a file of the user. Lines and columns count from 1; 0 means the file as a whole.
struct SourceLocation {
    std::shared_ptr<const std::string> file;  ///< as the user named it; null: no file (such as the command line)
    int line = 0;
    int column = 0;

    /// "file:line:column", without the parts that are unknown; empty without a file.
    std::string toString() const;
};

/// Exit statuses of the program. 0 only if the whole image is on disk; partialImage: a valid image is, but it has fewer samples than were
/// asked for.
enum class ExitCode { success = 0, scene = 1, usage = 2, device = 3, partialImage = 4 };

/// Any error that stops the program: one or more lines for the user, and the exit status.
class Error : public std::runtime_error {
public:
    Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
    ExitCode code() const { return code_; }

private:
    ExitCode code_;
};

/// An error in a scene or a file: "scene.pbrt:3:14: message".
struct SceneError : Error {
    SceneError(const SourceLocation& where, const std::string& message);
    bool hasPlace;   ///< the message begins with a file
};

/// An error in the command line; the message ends with how to get help.
struct UsageError : Error {
    explicit UsageError(const std::string& message) : Error(ExitCode::usage, message) {}
};

/// An error of an OpenCL platform, device, program or buffer.
struct DeviceError : Error {
    explicit DeviceError(const std::string& message) : Error(ExitCode::device, message) {}
};

/// The candidate nearest to `word` by edit distance, or empty if none is near; for "did you mean".
template <class Range> std::string nearestWord(const std::string& word, const Range& candidates);
/// Number of insertions, deletions and substitutions that turn a into b.
int editDistance(const std::string& a, const std::string& b);

template <class Range> std::string nearestWord(const std::string& word, const Range& candidates) {
    std::string best;
    int bestDistance = 1 + static_cast<int>(word.size()) / 3;
    for (const auto& candidate : candidates) {
        const int distance = editDistance(word, candidate);
        if (distance <= bestDistance) { bestDistance = distance - 1; best = candidate; }
    }
    return best;
}

}  // namespace eikonal
