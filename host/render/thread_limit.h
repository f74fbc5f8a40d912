#pragma once
// How many threads the system lets this process have (ulimit -u, a container's limit).

namespace eikonal {

/// The threads that TBB and the device may each use: `wanted`, or as many as can be had. Throws DeviceError if there are too few for one:
/// PoCL and TBB end the program where a thread cannot be started.
int affordableThreads(int wanted);

}  // namespace eikonal
