// The host knows which BSDFs are delta distributions, as their kernels do.

#include "eikonal/bsdfs.h"
#include "pack/smooth_bsdfs.h"
#include "test_paths.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

namespace eikonal {
namespace {

bool isDeltaInKernels(const std::string& name) {
    std::ifstream file(std::string(EIKONAL_SOURCE_DIR "/kernels/bsdf/") + name + ".clh");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    EXPECT_NE(text.find("#define " + name + "_is_delta "), std::string::npos) << name;
    return text.find("#define " + name + "_is_delta 1") != std::string::npos;
}

TEST(SmoothBsdfs, AreThoseOfTheKernels) {
#define COMPARE(name, FEATURE, PARAMETERS) EXPECT_EQ(isSmoothBsdf(next_##name), isDeltaInKernels(#name)) << #name;
    BSDFS(COMPARE)
#undef COMPARE
}

}  // namespace
}  // namespace eikonal
