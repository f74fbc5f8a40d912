#include "read/pbrt/problems.h"

namespace eikonal::pbrt {

static std::string version3Message(const std::string& what, const char* successor) {
    return what + " belongs to pbrt-v3" + (successor ? std::string(" (pbrt-v4 has ") + successor + ")" : "") +
           "; Eikonal reads pbrt-v4. Convert the scene with pbrt-v4's own program: pbrt --upgrade old.pbrt > new.pbrt";
}

Version3Error::Version3Error(const SourceLocation& where, const std::string& what, const char* successor)
    : SceneError(where, version3Message(what, successor)) {}

void Problems::add(const SourceLocation& where, const std::string& message) { add(SceneError(where, message)); }

void Problems::add(const SceneError& error) { messages_.push_back(error.what()); }

void Problems::addMissingFile(const SourceLocation& where, const std::string& name) {
    if (missingNames_.insert(name).second) missing_.push_back(SceneError(where, "there is no file \"" + name + "\"").what());
}

void Problems::throwIfAny() const {
    constexpr size_t most = 20;
    std::string text;
    for (size_t i = 0; i < messages_.size() && i < most; ++i) text += (text.empty() ? "" : "\n") + messages_[i];
    if (messages_.size() > most) text += "\nand " + std::to_string(messages_.size() - most) + " more";
    for (const std::string& message : missing_) text += (text.empty() ? "" : "\n") + message;
    if (!text.empty()) throw SceneError({}, text);
}

}  // namespace eikonal::pbrt
