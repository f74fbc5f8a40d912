#pragma once
// The settings before WorldBegin: camera, film, filter, sampler, integrator, accelerator, options.

#include "read/pbrt/arguments.h"
#include "read/pbrt/media.h"
#include "read/pbrt/state.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace eikonal::pbrt {

/// Collects settings, and puts them into the scene when the world begins; the last of each sort counts.
class Settings {
public:
    explicit Settings(Reading& reading) : reading_(reading) {}

    enum class Sort { camera, film, filter, sampler, integrator, accelerator };

    /// Sets a camera, film ... Throws SceneError for an unknown kind.
    void set(Sort sort, const std::string& kind, const GraphicsState& state, ParameterList parameters, const SourceLocation& where);
    /// An Option directive; `value` as written, without quotes. Options that the settings depend on must come before WorldBegin. Throws
    /// SceneError.
    void setOption(const std::string& name, const std::string& value, bool inWorld, const SourceLocation& where,
                   const SourceLocation& valueWhere);

    /// Fills in the scene's camera, film, filter, sampler and integrator. finish() fills in the camera's medium.
    void apply();
    void finish(MediumRegistry& media);

private:
    /// Puts all samples of a pixel at its centre, the centre of the lens and the middle of the shutter interval.
    void removeJitter();
    void applyCamera(const Arguments& arguments);
    void applyScreen(const Arguments& arguments);
    void applyFilm(const Arguments& arguments);
    void applyFilter(const Arguments& arguments);
    void applySampler(const Arguments& arguments);
    void applyLightSampler(const Arguments&);
    void applyIntegrator(const Arguments& arguments);

    Reading& reading_;
    std::map<Sort, std::unique_ptr<Arguments>> given_;
    int cameraMedium_ = none;  ///< number in MediumRegistry
    int seed_ = 0;             ///< Option "seed"
    std::optional<SourceLocation> withoutJitter_;                 ///< where Option "disablepixeljitter" says so
    std::optional<SourceLocation> errorReference_, errorLog_;     ///< where Option "msereferenceimage" and "msereferenceout" are
};

}  // namespace eikonal::pbrt
