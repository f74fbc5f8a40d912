#pragma once
// What the parts of the reader share while a scene is read.

#include "diagnostics.h"
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
    std::string folder;      ///< of the scene's own file: where relative names start
    Problems problems;
    Scene scene;
    std::map<std::pair<double, double>, std::shared_ptr<const AlbedoTable>> albedoTables;   ///< of bodies, by g and eta: made once (subsurface.cpp)
    double displacementEdgeScale = 1;   ///< of all that the scene says of edges of displaced meshes

    /// The path of a file that the scene names: as it is, or from the scene's folder, from the folder of the file that names it,
    /// or from the current one. If there is none the problem is noted, and nothing returned.
    std::optional<std::string> findFile(const std::string& name, const SourceLocation& where);

    /// Something that is understood but not rendered; under --strict a problem.
    void unsupported(const std::string& kind, const SourceLocation& where, const std::string& message);

    /// The spectrum that a parameter of type rgb, spectrum or blackbody gives. Throws SceneError.
    Spectrum readSpectrum(const Parameter& parameter);

private:
    /// Where a file of that name would be.
    std::vector<std::filesystem::path> candidatesFor(const std::string& name, const SourceLocation& where) const;
    bool hasFile(const std::string& name, const SourceLocation& where) const;
    std::map<std::string, std::shared_ptr<const SampledCurve>> spectrumFiles_;
};

}  // namespace eikonal::pbrt
