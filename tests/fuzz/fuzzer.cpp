// The entry of libFuzzer, for the target that the environment variable EIKONAL_FUZZ_TARGET names.

#include "targets.h"

#include <tbb/global_control.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>

using namespace eikonal::fuzz;

static const Target* chosen = nullptr;

extern "C" int LLVMFuzzerInitialize(int*, char***) {
    // One thread: the order of what runs depends on the input only.
    static const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 1);
    const char* name = std::getenv("EIKONAL_FUZZ_TARGET");
    try {
        chosen = &targetNamed(name ? name : "");
        inputFolder();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "EIKONAL_FUZZ_TARGET: %s\n", error.what());
        std::exit(2);
    }
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return chosen->run({reinterpret_cast<const char*>(data), size}) ? 0 : -1;
}
