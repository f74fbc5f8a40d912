#include "error.h"
#include "read/formats/loose_files.h"
#include "read/obj/materials.h"

#include <fmt/format.h>

#include <algorithm>

namespace eikonal {

namespace fs = std::filesystem;

std::string ObjFiles::find(const std::string& name, const SourceLocation& where) {
    const fs::path folder = where.file ? fs::path(*where.file).parent_path() : fs::path();
    std::error_code error;
    if (const fs::path exact = folder / name; fs::is_regular_file(exact, error)) return exact.string();
    const std::optional<std::string> found = findLoosely(name, folder);
    if (found) diagnostics_.unsupported("loose file " + name, where, looseMatchMessage(name, *found));
    return found.value_or("");
}

std::string ObjFiles::require(const std::string& name, const SourceLocation& where) {
    std::string found = find(name, where);
    if (!found.empty()) return found;

    // Suggest a file with a similar name.
    const fs::path beside = where.file ? fs::path(*where.file) : fs::path();
    const fs::path folder = beside.has_parent_path() ? beside.parent_path() : fs::path(".");
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        names.push_back(entry->path().filename().string());
    const std::string last = name.substr(name.find_last_of("/\\") + 1), similar = nearestWord(last, names);
    const std::string message =
        fmt::format("there is no image \"{}\"{}", name, similar.empty() ? "" : "; did you mean \"" + similar + "\"?");
    const std::string text = SceneError(where, message).what();
    if (std::ranges::find(missing_, text) == missing_.end()) missing_.push_back(text);
    return {};
}

void ObjFiles::throwMissing() const {
    std::string all;
    for (const std::string& text : missing_) all += (all.empty() ? "" : "\n") + text;
    if (!all.empty()) throw Error(ExitCode::scene, all);
}

}  // namespace eikonal
