#pragma once
// Wall-clock time.

#include <chrono>

namespace eikonal {

class Stopwatch {
public:
    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Seconds since the program was loaded.
double secondsSinceStart();

}  // namespace eikonal
