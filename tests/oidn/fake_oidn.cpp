// Stands in for Intel Open Image Denoise, which is no Debian package: the functions of its C interface (version 2) that the program calls.
// Its filters halve the image, so that a test can tell what was filtered; they fail if anything is not as the real ones need it, or if the
// environment has FAKE_OIDN_FAILS.
#include <cstddef>
#include <cstdlib>
#include <map>
#include <string>

namespace {

const char* problem = nullptr;

struct Image { float* first; size_t width, height; };
struct Filter {
    std::map<std::string, Image> images;
    std::map<std::string, bool> flags;
    bool isCommitted = false;

    const char* fault() {
        if (std::getenv("FAKE_OIDN_FAILS")) return "out of memory, says the test";
        if (!isCommitted) return "the filter is not committed";
        if (!images.count("output")) return "there is no output";
        for (const auto& [name, image] : images)
            if (image.width != images["output"].width || image.height != images["output"].height || !image.first) return "sizes differ";
        const bool isGuide = !images.count("color");
        if (isGuide && images.size() != 2) return "a guide is filtered alone";
        if (isGuide) return images.count("albedo") || images.count("normal") ? nullptr : "there is no such guide";
        if (images.count("normal") && !images.count("albedo")) return "normals need albedo";
        if (!flags["hdr"]) return "radiance is not in [0, 1]";
        return images.size() > 2 && !flags["cleanAux"] ? "the guides have no noise" : nullptr;
    }
};

int device;

}  // namespace

extern "C" {

void* oidnNewDevice(int) { return &device; }
void oidnSetDeviceInt(void*, const char*, int) {}
void oidnCommitDevice(void*) {}
void oidnReleaseDevice(void*) {}
int oidnGetDeviceError(void*, const char** message) {
    *message = problem;
    const int code = problem ? 1 : 0;
    problem = nullptr;
    return code;
}
Filter* oidnNewFilter(void*, const char* type) {
    if (std::string(type) != "RT") problem = "there is no such filter";
    return new Filter;
}
void oidnSetSharedFilterImage(Filter* filter, const char* name, void* first, int format, size_t width, size_t height, size_t offset,
                              size_t pixelStride, size_t rowStride) {
    if (format != 3 || offset || pixelStride || rowStride) problem = "not what this test reads";
    filter->images[name] = {static_cast<float*>(first), width, height};
}
void oidnSetFilterBool(Filter* filter, const char* name, bool value) { filter->flags[name] = value; }
void oidnSetFilterInt(Filter*, const char*, int) {}
void oidnCommitFilter(Filter* filter) { filter->isCommitted = true; }
void oidnExecuteFilter(Filter* filter) {
    if ((problem = filter->fault())) return;
    const Image output = filter->images["output"];
    const char* input = filter->images.count("color") ? "color" : filter->images.count("albedo") ? "albedo" : "normal";
    for (size_t i = 0; i < 3 * output.width * output.height; ++i) output.first[i] = filter->images[input].first[i] / 2;
}
void oidnReleaseFilter(Filter* filter) { delete filter; }

}
