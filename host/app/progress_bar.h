#pragma once
// Progress of a render: a bar on a terminal, otherwise a line every ten seconds.

#include "render/render.h"

#include <string>

namespace eikonal {

/// 75.4 as "1:15", 4000 as "1:06:40".
std::string clockTime(double seconds);

/// Writes to standard error, or nothing at all if `silent`.
class ProgressBar {
public:
    /// `samples`: the maximum per pixel.
    ProgressBar(unsigned samples, bool silent);
    /// Ends the bar's line.
    ~ProgressBar();

    void show(const Progress& progress);

private:
    void draw(const Progress& progress) const;
    unsigned samples_;
    bool silent_, terminal_;
    double shownAt_ = 0;
    bool drawn_ = false;
};

}  // namespace eikonal
