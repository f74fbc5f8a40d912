#pragma once
// Settings of a test's scene that the test may replace.

#include <sstream>
#include <string>

namespace eikonal {

/// The lines of `defaults`, one directive each, without those whose directive is also in `given`: the reader warns of a second Film,
/// Sampler and so on, and a test's scene must give no warning.
inline std::string defaultSettings(const std::string& defaults, const std::string& given) {
    std::istringstream lines(defaults);
    std::string kept;
    for (std::string line; std::getline(lines, line);) {
        const size_t start = line.find_first_not_of(' ');
        const std::string directive = start == std::string::npos ? "" : line.substr(start, line.find(' ', start) - start) + " \"";
        if (directive.empty() || given.find(directive) == std::string::npos) kept += line + "\n";
    }
    return kept;
}

}  // namespace eikonal
