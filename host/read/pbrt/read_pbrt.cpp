#include "read/pbrt/read_pbrt.h"

#include "read/pbrt/parser.h"
#include "read/pbrt/source.h"
#include "read/scene_name.h"

#include <unistd.h>

#include <filesystem>

namespace eikonal {
namespace {

Scene read(const std::string& name, std::string text, const std::string& folder, Diagnostics& diagnostics,
           MissingFiles missing) {
    pbrt::Builder builder(diagnostics, folder);
    builder.reading.missingFiles = missing;
    builder.reading.scene.name = sceneName(name);
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

Scene readPbrt(const std::string& path, Diagnostics& diagnostics, MissingFiles missing) {
    return read(path, pbrt::readTextFile(path), std::filesystem::path(path).parent_path().string(), diagnostics, missing);
}

Scene readPbrtInput(Diagnostics& diagnostics, MissingFiles missing) {
    if (::isatty(STDIN_FILENO))
        throw Error(ExitCode::scene,
                    "the scene - is standard input, and that is a terminal; lead a scene to it: eikonal render - < scene.pbrt");
    Scene scene = read("<stdin>", pbrt::readStandardInput("<stdin>"), "", diagnostics, missing);
    scene.name = sceneName("-");
    return scene;
}

Scene readPbrtText(std::string_view text, const std::string& nameForMessages, const std::string& folder, Diagnostics& diagnostics,
                   MissingFiles missing) {
    return read(nameForMessages, std::string(text), folder, diagnostics, missing);
}

}  // namespace eikonal
