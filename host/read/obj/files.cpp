#include "error.h"
#include "read/formats/loose_files.h"
#include "read/obj/materials.h"

#include <fmt/format.h>

#include <algorithm>

namespace eikonal {

namespace fs = std::filesystem;

std::string ObjFiles::find(const std::string& name, const fs::path& beside) {
    std::string portable = name;
    std::ranges::replace(portable, '\\', '/');
    const fs::path folder = beside.parent_path();
    std::error_code error;
    for (const fs::path& candidate : {folder / portable, folder / fs::path(portable).filename()})
        if (fs::is_regular_file(candidate, error)) return candidate.string();
    return findLoosely(name, folder).value_or("");
}

std::string ObjFiles::require(const std::string& name, const SourceLocation& where) {
    const fs::path beside = where.file ? fs::path(*where.file) : fs::path();
    std::string found = find(name, beside);
    if (!found.empty()) return found;

    // Suggest a file with a similar name.
    const fs::path folder = beside.has_parent_path() ? beside.parent_path() : fs::path(".");
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        names.push_back(entry->path().filename().string());
    const std::string similar = nearestWord(fs::path(name).filename().string(), names);
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
