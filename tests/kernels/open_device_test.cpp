// What opening a device does to the process.

#include "test_device.h"

#include <gtest/gtest.h>

#include <unistd.h>

namespace eikonal {
namespace {

// A scene is read while the device opens, by libraries that read environment variables: none may be added meanwhile, for that moves them
// all. (ctest gives this test a process of its own; after another test the device is open already.)
TEST(OpenDevice, LeavesTheEnvironmentWhereItIs) {
    preparePocl(testCacheFolder());
    char** const before = environ;
    testContext();
    EXPECT_EQ(environ, before);
}

}  // namespace
}  // namespace eikonal
