#include "app/clock.h"

namespace eikonal {

/// Set when the program is loaded, before main(). (The kernel's own record, in /proc/self/stat, is no use: it counts from the fork, and
/// `./dev render` spends minutes building between that and its exec.)
static const Stopwatch sinceStart;

double secondsSinceStart() { return sinceStart.seconds(); }

}  // namespace eikonal
