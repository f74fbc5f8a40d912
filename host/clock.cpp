#include "clock.h"

namespace eikonal {

/// Initialized when the program is loaded, before main(). (/proc/self/stat does not help: its start time is that of the fork, and `./dev
/// render` may build for minutes between its fork and the exec of this program.)
static const Stopwatch sinceStart;

double secondsSinceStart() { return sinceStart.seconds(); }

}  // namespace eikonal
