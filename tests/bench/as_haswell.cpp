// Makes PoCL (LLVM 15) and Dr.Jit generate code for a CPU with AVX2, such as a Haswell, on one that can do more. Not part of the build:
//     apt-get install llvm-15-dev
//     g++ -O1 -fPIC -shared -std=c++17 -Wl,-z,lazy -I$(llvm-config-15 --includedir) tests/bench/as_haswell.cpp -o as_haswell.so
//     LD_PRELOAD=$PWD/as_haswell.so XDG_CACHE_HOME=... POCL_CACHE_DIR=... HOME=... COMMAND    caches of its own: kernels differ
// Libraries that choose by the instruction cpuid, such as Embree, do not notice.

#include <dlfcn.h>
#include <llvm/ADT/StringMap.h>

#include <cstring>
#include <string>

static constexpr const char* name = "haswell";
static constexpr const char* present[] = {"sse",  "sse2", "sse3", "ssse3", "sse4.1", "sse4.2", "avx",    "avx2", "fma", "f16c", "bmi",
                                          "bmi2", "cx8",  "cx16", "sahf",  "pclmul", "mmx",    "popcnt", "fxsr", "x87", "movbe", "lzcnt"};
static constexpr const char* absent[] = {"avx512f", "avx512vl", "avx512bw", "avx512dq", "avx512cd"};

/* What PoCL asks */
namespace llvm::sys {

StringRef getHostCPUName() { return name; }

bool getHostCPUFeatures(StringMap<bool, MallocAllocator>& features) {
    ::dlopen("libLLVM-15.so.1", RTLD_NOLOAD | RTLD_NOW | RTLD_GLOBAL);   // PoCL has loaded it; StringMap's functions are found there
    for (const char* feature : present) features[feature] = true;
    for (const char* feature : absent) features[feature] = false;
    return true;
}

}  // namespace llvm::sys

/* What Dr.Jit asks, by way of dlsym */
static char* copyName() { return ::strdup(name); }
static char* copyFeatures() {
    std::string all = "-avx512vl";
    for (const char* feature : present) all += std::string(",+") + feature;
    return ::strdup(all.c_str());
}

extern "C" void* dlsym(void* library, const char* symbol) noexcept {
    using Dlsym = void* (*)(void*, const char*);
    static const Dlsym original = reinterpret_cast<Dlsym>(::dlvsym(RTLD_NEXT, "dlsym", "GLIBC_2.34"));
    if (std::strcmp(symbol, "LLVMGetHostCPUName") == 0) return reinterpret_cast<void*>(copyName);
    if (std::strcmp(symbol, "LLVMGetHostCPUFeatures") == 0) return reinterpret_cast<void*>(copyFeatures);
    return original(library, symbol);
}
