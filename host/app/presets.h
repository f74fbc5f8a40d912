#pragma once
// The presets of --quality.

namespace eikonal {

/// `options`: what the preset stands for, "--name=value" separated by spaces; options that the user gives override them.
struct Preset { const char *name, *options; };

/// tests/accuracy/presets.py measures them on a set of scenes, beside other options, and finds the front of studies by `eikonal trade`;
/// docs/trade.md has its table.
inline constexpr Preset presets[] = {{"draft", "--spp=8"},
                                     {"preview", "--spp=32"},
                                     {"final", "--spp=512"},
                                     {"reference",
                                      "--spp=4096 --color=spectral --regularize=off --max-component-value=0 --subsurface=randomwalk"}};

}  // namespace eikonal
