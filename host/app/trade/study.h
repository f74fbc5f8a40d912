#pragma once
// Measures error and time of a scene under many settings, within a budget of time.

#include "app/trade/study_state.h"
#include "diagnostics.h"

#include <functional>
#include <optional>
#include <string>

namespace eikonal {

/// How far a study is: `fraction` of its budget, and what it does.
struct StudyProgress {
    double fraction, secondsLeft;
    std::string what;
};

/// A study in a folder, which it creates. Everything measured is kept there after each session, so an interrupted study goes on where it
/// was. Random numbers: renders of points have the seeds 1, 2, ..., those of references others, so none is in both.
class Study {
public:
    struct Request {
        std::string scene;                 ///< its file
        std::vector<std::string> options;  ///< the user's, "--name=value"
        std::string folder;
        bool withCompilerFlags = false;    ///< also try flags that are not strict, which takes long to compile
        double budgetSeconds = 300;  ///< of all runs of this study
        std::function<bool()> stop;  ///< asked often; true: end soon
        std::function<void(const StudyProgress&)> progress;
        LogLevel log = LogLevel::warning;  ///< of warnings about the scene, which are printed once
    };

    static constexpr int seedsInASession = 4;       ///< so that each point is measured at two times, in turn with the others
    static constexpr int seeds = 8;                 ///< of a point that is measured in full
    static constexpr double rungs[] = {4, 16, 64};  ///< samples per pixel of every ladder; longer ones follow if there is time

    /// Reads what an earlier run left in the folder. Throws Error.
    explicit Study(Request request);

    /// Measures until the work is done, the budget is spent, or `stop` says so. Throws an Error if the scene cannot be rendered.
    void run();
    /// Whether the first look at the scene has ended; otherwise it was interrupted, and nothing is kept.
    bool hasLooked() const { return !state_.settings.empty(); }
    bool isInterrupted() const { return request_.stop && request_.stop(); }

    StudyState& state() { return state_; }
    const StudyState& state() const { return state_; }
    const Request& request() const { return request_; }
    References loadReferences() const;
    /// Images of a point that has been measured.
    PointImages loadImages(const Point& point) const;
    /// The options of a setting at a rung, for a render of this size; all of the image if not given.
    std::vector<std::string> optionsOf(const Setting& setting, double rung, std::optional<std::array<int, 2>> size = std::nullopt) const;
    /// Renders a setting at a rung with the seeds up to endSeed that it does not have yet. Seeds are 1, 2, 3 ... without gaps.
    void climb(size_t setting, double rung, int endSeed);
    /// Whether all seeds of a rung take less than half of what is left of the budget.
    bool canAfford(double rung) const { return !isInterrupted() && costOf(seeds * rung) < (request_.budgetSeconds - spent()) / 2; }
    /// Runs a setting at full size as a process of its own, and adds what it took to the state.
    void confirmAt(size_t setting, double rung);
    /// Seconds that all runs of this study have taken.
    double spent() const;

private:
    void lookAtScene();
    void chooseSize();
    void renderReferences(double until);
    void climbAll(double until);
    void climbHigher(double until);
    void addCombination();
    bool isWorthClimbing(size_t setting, double rung);
    std::vector<double> rungsOf(const Setting& setting) const;
    double costOf(double samples) const;
    bool isOver(double until) const { return spent() >= until || isInterrupted(); }
    /// Seconds of the study at which a part of what the first look leaves of the budget is spent.
    double share(double part) const;
    void save();
    void report(const std::string& what) const;
    std::string stateFile() const { return request_.folder + "/study.json"; }
    std::string stemOf(const Point& point) const;
    std::string stemOfReference(size_t which) const;

    Request request_;
    StudyState state_;
    double spentBefore_ = 0;
    std::function<double()> clock_;
};

}  // namespace eikonal
