#pragma once
// Handling of SIGINT (Ctrl-C), SIGTERM and SIGHUP (a closed terminal).

namespace eikonal {

/// Plus its number: the exit status of a program that a signal ended.
inline constexpr int signalStatus = 128;

/// Blocks the signals that the parent process made this one ignore, as nohup and shells running `eikonal ... &` in a script do. They then
/// stay without effect even if a library sets a handler, as LLVM inside PoCL does. Call this before any thread starts.
void keepIgnoredSignals();

/// While this object lives, the first SIGINT, SIGTERM or SIGHUP is only noted, so that the image so far can be written; a second one ends
/// the program at once.
class Interrupt {
public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    /// As if SIGINT had arrived, unless one has been noted.
    static void request();
    /// The number of the noted signal, or 0.
    static int signal();
};

}  // namespace eikonal
