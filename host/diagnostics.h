#pragma once
// Warnings and progress notes: nothing in a scene is ever silently ignored.

#include "error.h"

#include <functional>
#include <mutex>
#include <set>
#include <string>
#include <vector>

namespace eikonal {

enum class LogLevel { silent, error, warning, info, debug };

/// Collects what the user should know. Thread-safe.
class Diagnostics {
public:
    /// strict: what would be a warning about unsupported or unknown content is thrown as a SceneError instead.
    explicit Diagnostics(LogLevel level = LogLevel::warning, bool strict = false) : level_(level), strict_(strict) {}

    /// A warning. Printed at once to standard error as "place: warning: message" (if the level allows) and kept.
    void warn(const SourceLocation& where, const std::string& message);

    /// A warning given once for each `kind`, at the first place that asks; later ones are only counted.
    void warnOnce(const std::string& kind, const SourceLocation& where, const std::string& message);

    /// Something in the scene that is understood but not rendered (yet), once for each kind. An error under strict.
    void unsupported(const std::string& kind, const SourceLocation& where, const std::string& message);

    /// A line for --log-level info.
    void info(const std::string& message);
    void debug(const std::string& message);

    LogLevel level() const { return level_; }
    bool strict() const { return strict_; }
    std::vector<std::string> warnings() const;

private:
    mutable std::mutex mutex_;
    LogLevel level_;
    bool strict_;
    std::set<std::string> kinds_;
    std::vector<std::string> warnings_;
};

}  // namespace eikonal
