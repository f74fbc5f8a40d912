#pragma once
// The knobs of a renderer that exchange accuracy for time, and the values worth trying on a scene.

#include <string>
#include <vector>

namespace eikonal {

class Session;
struct IntegratorKind;

/// What the rungs of a setting's ladder are.
enum class Ladder { samples, targetErrors };

/// One way to render a scene: options of `eikonal render` that differ from those of the user.
struct Setting {
    std::string knob;                  ///< "Russian roulette"; "as given" for the user's own options
    std::string value;                 ///< "throughput"
    std::vector<std::string> options;  ///< "--name=value"
    bool addsBias = false;             ///< beyond that of the user's own options
    bool isBiased = false;             ///< by construction, it converges to another image than the reference, or hardly finds some light
    Ladder ladder = Ladder::samples;
    bool compiles = false;  ///< needs kernels that no other scene uses

    std::string name() const { return value.empty() ? knob : knob + ": " + value; }
};

/// The settings for a scene that has been packed: the user's own first, then one for each other value of each knob that has an effect on
/// this scene. `brightness`: the image's mean, > 0; clamping is tried at multiples of it. withCompilerFlags: also each flag that is not
/// strict in all kernels and in each alone, for which the session must have its kernels. `follower`: as of followerOf (followed_light.h).
std::vector<Setting> settingsFor(const Session& session, double brightness, bool withCompilerFlags,
                                 const IntegratorKind* follower);

/// The options of the reference: those that avoid the biased choices of the user's own, and the follower. Depth, and what an integrator
/// leaves out, are part of what the user wants.
std::vector<std::string> referenceOptions(const Session& session, const IntegratorKind* follower);

/// "--integrator=name".
std::string integratorOption(const IntegratorKind& kind);

/// `base` without the options that `more` sets, followed by `more`.
std::vector<std::string> overridden(const std::vector<std::string>& base, const std::vector<std::string>& more);

}  // namespace eikonal
