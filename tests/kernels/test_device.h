#pragma once
// The device, compiler and program cache that all kernel tests of a process share.

#include "device/kernel.h"
#include "pack/scene_constants.h"

namespace eikonal {

/// $EIKONAL_TEST_DEVICE (a name or index as for --device), or the first PoCL device, or the best device there is.
const Context& testContext();

/// Builds with a cache of its own in the folder of temporary files: a second run of the tests hardly compiles, and neither
/// the user's cache nor PoCL's is touched. Entries are keyed by the text of the kernels, so they cannot be stale.
Compiler& testCompiler();

/// The folder of that cache.
const std::string& testCacheFolder();

/// The settings that kernels ship with, for these features and constants and the shape of stages that tests use; warnings are errors.
BuildSettings shippedSettings(const Features& features, const SceneConstants& constants = {.environments = 1});

/// Work-items in a group, and slots in a run of a tracing stage, in all kernel tests.
constexpr unsigned testLocalSize = 4, testRun = 16, testGroup = testLocalSize * testRun;

/// Whether kernels/<name> exists: tests that walk a list of kinds pass over those that are not written yet.
bool hasKernelFile(const std::string& name);

}  // namespace eikonal
