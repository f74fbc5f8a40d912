#include "read/pbrt/read_pbrt.h"

#include "read/pbrt/parser.h"
#include "read/pbrt/source.h"

#include <filesystem>

namespace eikonal {
namespace {

/// The file name without folder and extension.
std::string stemOf(const std::string& path) {
    std::filesystem::path name = std::filesystem::path(path).filename();
    if (name.extension() == ".gz") name = name.stem();
    return name.stem().string();
}

Scene read(const std::string& name, std::string text, const std::string& folder, Diagnostics& diagnostics) {
    pbrt::Builder builder(diagnostics, folder);
    builder.reading.scene.name = stemOf(name);
    SourceLocation end{std::make_shared<const std::string>(name)};
    try {
        end = pbrt::Parser(builder).read(name, std::move(text));
    } catch (const pbrt::Version3Error&) { throw; } catch (const SceneError& error) {
        // The rest of the text cannot be read; report what was found so far.
        builder.reading.problems.add(error);
        builder.reading.problems.throwIfAny();
    }
    return builder.finish(end);
}

}  // namespace

Scene readPbrt(const std::string& path, Diagnostics& diagnostics) {
    return read(path, pbrt::readTextFile(path), std::filesystem::path(path).parent_path().string(), diagnostics);
}

Scene readPbrtText(std::string_view text, const std::string& nameForMessages, const std::string& folder, Diagnostics& diagnostics) {
    return read(nameForMessages, std::string(text), folder, diagnostics);
}

}  // namespace eikonal
