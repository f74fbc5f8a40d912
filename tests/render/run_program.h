#pragma once
// The program, run as a user runs it.

#include "unit/temporary_folder.h"

#include <map>

namespace eikonal {

/// What a run of the program left.
struct Outcome {
    int status = -1;            ///< exit status; 128 + number of the signal that killed it
    std::string out, error;     ///< what it printed
    double seconds = 0;
};

/// Runs the program in a folder of the test's own. Compiled kernels are kept beside the program, for the next test.
class ProgramTest : public TemporaryFolder {
protected:
    using Environment = std::map<std::string, std::string>;
    Outcome run(const std::vector<std::string>& arguments, const Environment& environment = {}) const {
        return wait(start(arguments, environment));
    }

    /// A run that goes on. Every one is to be waited for.
    struct Running { int process; std::string out, error; };
    Running start(const std::vector<std::string>& arguments, const Environment& environment = {}) const;
    static const std::string builtProgram;
    std::string program_ = builtProgram;   ///< that is run
    Outcome wait(const Running& running) const;

    /// Waits until the running program has printed `text` as an error or warning; false: it did not, for 60 seconds.
    static bool printed(const Running& running, const std::string& text);
};

/// A grey square seen from the front, lit by a point light beside the camera. 16 x 12 pixels, 4 samples.
std::string tinyScene(const std::string& settings = "", const std::string& world = "");

}  // namespace eikonal
