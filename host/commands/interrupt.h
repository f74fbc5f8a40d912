#pragma once
// Ctrl-C and the polite request to end.

namespace eikonal {

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
