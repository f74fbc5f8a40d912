#pragma once
// What a study of a scene has measured so far: a file that lets it go on after an interruption.

#include "app/trade/confirmation.h"
#include "app/trade/point.h"
#include "app/trade/setting.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace eikonal {

/// Pixels of an image of this width and height.
inline double pixelsOf(const std::array<int, 2>& size) { return static_cast<double>(size[0]) * size[1]; }

struct StudyState {
    /* What the figures belong to: a study does not go on if any of these differ */
    std::string scene, sceneHash, version, device;
    std::vector<std::string> baseOptions;  ///< the user's options of `eikonal render`

    std::array<int, 2> full{}, studied{};  ///< width and height of the user's image, and of those that are measured
    double pathSeconds = 0;                ///< of the user's options, from the first look
    double prepareSeconds = 0;             ///< to load the scene, with compiled kernels
    double brightness = 0;                 ///< the image's mean
    double spentSeconds = 0;               ///< in all runs of this study
    double lookSeconds = 0;                ///< of that: the first look at the scene
    double referenceSamples = 0;           ///< per pixel, of each of the two references
    double referenceSeconds = 0;
    std::vector<std::string> reference;  ///< the options of references
    std::vector<Setting> settings;
    std::vector<Point> points;  ///< of a setting, by ascending rung
    std::vector<Confirmation> confirmations;

    /// The largest rung, in samples per pixel.
    double ladderTop() const;
    Point* find(size_t setting, double rung);
    /// The points of a setting that have at least `seeds` renders.
    std::vector<const Point*> ladderOf(size_t setting, int seeds = 1) const;

    /// Writes the file, completely or not at all. Throws Error.
    void save(const std::string& file) const;
    /// Nothing if there is no such file. Throws an Error (ExitCode::scene) that says what to do if it is of another scene, device, version
    /// or options than `expected`, or is damaged.
    static std::optional<StudyState> load(const std::string& file, const StudyState& expected);
};

}  // namespace eikonal
