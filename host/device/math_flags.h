#pragma once
// Flags of the OpenCL compiler that may change arithmetic: those that all kernels ship with, and replacements for single stages.

#include <string>

namespace eikonal {

/// The flags with which the OpenCL compiler may change arithmetic, in all kernels: neither changes rounding or order of evaluation, and
/// without both, PoCL does not vectorise over work-items (docs/performance.md). tests/accuracy/flags.py compares them with others.
inline constexpr const char* shippedMathFlags = "-cl-finite-math-only -cl-no-signed-zeros";

/// Math flags that replace those of one stage.
struct StageFlags {
    std::string stage;   ///< "shade_hits", or for one BSDF "shade_hits diffuse"; empty: all kernels
    std::string flags;
};

}  // namespace eikonal
