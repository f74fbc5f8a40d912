#include "app/progress_bar.h"

#include <fmt/format.h>

#include <unistd.h>

#include <cstdio>

namespace eikonal {

constexpr double secondsBetweenFrames = 0.1, secondsBetweenLines = 10;
constexpr int barWidth = 30;

std::string clockTime(double seconds) {
    const long s = static_cast<long>(seconds);
    return s >= 3600 ? fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60) : fmt::format("{}:{:02}", s / 60, s % 60);
}

ProgressBar::ProgressBar(unsigned samples, bool silent) : samples_(samples), silent_(silent), terminal_(isatty(STDERR_FILENO)) {}

ProgressBar::~ProgressBar() {
    if (drawn_) std::fputc('\n', stderr);
}

void ProgressBar::show(const Progress& p) {
    const double pause = terminal_ ? secondsBetweenFrames : secondsBetweenLines;
    if (silent_ || (p.seconds - shownAt_ < pause && (p.fraction < 1 || !terminal_))) return;
    shownAt_ = p.seconds;
    draw(p);
    drawn_ = terminal_;
}

void ProgressBar::draw(const Progress& p) const {
    const std::string text = fmt::format("{:3.0f} %  {}/{} samples  {} elapsed  {} left", std::floor(p.fraction * 100),
                                         std::floor(p.meanSamples), samples_, clockTime(p.seconds), clockTime(p.secondsLeft));
    const int full = static_cast<int>(p.fraction * barWidth);
    if (terminal_) std::fputs(fmt::format("\r[{:=<{}}{: <{}}] {}\x1b[K", "", full, "", barWidth - full, text).c_str(), stderr);
    else std::fputs((text + "\n").c_str(), stderr);
    std::fflush(stderr);
}

}  // namespace eikonal
