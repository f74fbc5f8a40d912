#pragma once
// Shared state of the parts of the reader.

#include "diagnostics.h"
#include "read/formats/loose_files.h"
#include "read/pbrt/parameters.h"
#include "read/pbrt/problems.h"
#include "scene/scene.h"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace eikonal::pbrt {

struct AlbedoTable;   // subsurface.cpp

struct Reading {
    Reading(Diagnostics& diagnosticsToUse, std::string sceneFolder) : diagnostics(diagnosticsToUse), folder(std::move(sceneFolder)) {}

    Diagnostics& diagnostics;
    std::string folder;      ///< folder of the main scene file, which relative names refer to
    MissingFiles missingFiles = MissingFiles::error;
    Problems problems;
    Scene scene;
    std::map<std::pair<double, double>, std::shared_ptr<const AlbedoTable>> albedoTables;   ///< by g and eta, each computed once
    size_t openedFiles = 0;  ///< by Include and Import, each time counted
    double displacementEdgeScale = 1;   ///< factor of all edge lengths of displaced meshes

    /// The path of a file that the scene names: absolute, or relative to the scene's folder, the folder of the file that names it, or the
    /// working directory; else, with a warning or under --strict a problem, one that is probably meant (read/formats/loose_files.h). If
    /// there is none, notes the problem and returns nothing.
    std::optional<std::string> findFile(const std::string& name, const SourceLocation& where);
    /// The same for a file that a picture can do without: with MissingFiles::magenta there is a warning, which ends with `instead`, and
    /// no problem.
    std::optional<std::string> findFile(const std::string& name, const SourceLocation& where, const char* instead);
    /// The same for an image that textures read. With MissingFiles::magenta, one that is missing is a magenta pixel, and is there.
    std::optional<ImageFile> findImage(const std::string& name, const SourceLocation& where);

    /// The text of a file that Include or Import names (readTextFile). Short ones are kept: a scene may name one thousands of times.
    std::string includedText(const std::string& path);

    /// Reports a feature that is read but not rendered; under --strict a problem.
    void unsupported(const std::string& kind, const SourceLocation& where, const std::string& message);

    /// The spectrum given by a parameter of type rgb, spectrum or blackbody. Throws SceneError.
    Spectrum readSpectrum(const Parameter& parameter);

private:
    /// An existing file, or nothing, which is not noted.
    std::optional<std::string> lookFor(const std::string& name, const SourceLocation& where);
    /// The paths that `name` may refer to, in order.
    std::vector<std::filesystem::path> candidatesFor(const std::string& name, const SourceLocation& where) const;
    bool hasFile(const std::string& name, const SourceLocation& where) const;
    std::map<std::string, std::shared_ptr<const SampledCurve>> spectrumFiles_;
    std::map<std::string, std::string> includedTexts_;   ///< by path
    size_t includedBytes_ = 0;                           ///< their length
};

}  // namespace eikonal::pbrt
