#pragma once
// Ctrl-C and the polite request to end.

namespace eikonal {

/// What whoever started the program has it ignore, as a shell does for `eikonal ... &` in a script or nohup does, stays ignored, whatever
/// handlers are set later: LLVM, inside PoCL, sets its own. To be called before there are threads.
void keepIgnoredSignals();

/// While it lives, a first SIGINT or SIGTERM is only noted, so that what is rendered can be written; a second one ends the program at once.
class Interrupt {
public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    /// The signal's number, or 0.
    static int signal();
};

}  // namespace eikonal
