#pragma once
// Warnings and progress messages: the readers never ignore anything silently.

#include "error.h"

#include <functional>
#include <mutex>
#include <set>
#include <string>
#include <vector>

namespace eikonal {

enum class LogLevel { silent, error, warning, info, debug };

/// Collects messages for the user. Thread-safe.
class Diagnostics {
public:
    /// strict: throw a SceneError instead of warning about unsupported or unknown content, or a guess in place of what is missing.
    explicit Diagnostics(LogLevel level = LogLevel::warning, bool strict = false) : level_(level), strict_(strict) {}

    /// Prints "place: warning: message" to standard error (if the level allows) and keeps the message.
    void warn(const SourceLocation& where, const std::string& message);

    /// Warns once for each `kind`, at the first place; later ones are only counted.
    void warnOnce(const std::string& kind, const SourceLocation& where, const std::string& message);

    /// Reports what is read but not rendered, or something else in its place, once for each kind. With strict, throws a SceneError.
    void unsupported(const std::string& kind, const SourceLocation& where, const std::string& message);

    /// A line for --log-level info.
    void info(const std::string& message);
    /// The same, once for each `kind`, with its first place.
    void infoOnce(const std::string& kind, const SourceLocation& where, const std::string& message);
    void debug(const std::string& message);

    LogLevel level() const { return level_; }
    bool strict() const { return strict_; }
    std::vector<std::string> warnings() const;

private:
    /// Of its kind; notes it.
    bool isFirst(const std::string& kind);

    mutable std::mutex mutex_;
    LogLevel level_;
    bool strict_;
    std::set<std::string> kinds_;
    std::vector<std::string> warnings_;
};

}  // namespace eikonal
