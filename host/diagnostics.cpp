#include "diagnostics.h"

#include "messages.h"
#include "printable.h"

namespace eikonal {

void Diagnostics::warn(const SourceLocation& where, const std::string& message) {
    const std::string place = where.toString();
    const std::string text = inOneLine((place.empty() ? "" : place + ": ") + "warning: " + message);
    std::lock_guard lock(mutex_);
    warnings_.push_back(text);
    tell(LogLevel::warning, text, level_);
}

bool Diagnostics::isFirst(const std::string& kind) {
    std::lock_guard lock(mutex_);
    return kinds_.insert(kind).second;
}

void Diagnostics::warnOnce(const std::string& kind, const SourceLocation& where, const std::string& message) {
    if (isFirst(kind)) warn(where, message);
}

void Diagnostics::unsupported(const std::string& kind, const SourceLocation& where, const std::string& message) {
    if (strict_) throw SceneError(where, message + " (an error because of --strict)");
    warnOnce(kind, where, message);
}

void Diagnostics::info(const std::string& message) { tell(LogLevel::info, message, level_); }

void Diagnostics::infoOnce(const std::string& kind, const SourceLocation& where, const std::string& message) {
    if (isFirst(kind)) info(where.toString() + ": " + message);
}

void Diagnostics::debug(const std::string& message) { tell(LogLevel::debug, message, level_); }

std::vector<std::string> Diagnostics::warnings() const {
    std::lock_guard lock(mutex_);
    return warnings_;
}

}  // namespace eikonal
