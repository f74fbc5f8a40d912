#include "image/denoise.h"

#include "error.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <optional>

namespace eikonal {
namespace {

/* What we use of the library's C interface, version 2 (OpenImageDenoise/oidn.h) */
struct Device;
struct Filter;
constexpr int cpuDevice = 1, float3 = 3;

/* Measured: 700 bytes for each pixel; what takes more than this limit is denoised in tiles */
constexpr size_t bytesPerPixel = 700;
constexpr int mostMegabytes = 1024;

using Vectors = std::vector<glm::vec3>;

/// A filter of the library, released at the end.
template <class Library> class OwnedFilter {
public:
    OwnedFilter(const Library& library, const FilmImage& image)
        : library_(library), filter_(library.newFilter(library.device, "RT")), width_(static_cast<size_t>(image.columns())),
          height_(static_cast<size_t>(image.rows())) {}
    OwnedFilter(const OwnedFilter&) = delete;
    ~OwnedFilter() { library_.releaseFilter(filter_); }

    void set(const char* name, const Vectors& values) {
        library_.setImage(filter_, name, const_cast<glm::vec3*>(values.data()), float3, width_, height_, 0, 0, 0);
    }
    void set(const char* name, bool value) { library_.setBool(filter_, name, value); }
    void execute() {
        library_.setFilterInt(filter_, "maxMemoryMB", mostMegabytes);
        library_.commitFilter(filter_);
        library_.executeFilter(filter_);
        library_.check("cannot denoise the image");
    }

private:
    const Library& library_;
    Filter* filter_;
    size_t width_, height_;
};

}  // namespace

struct Denoiser::Library {
    void* handle = nullptr;
    Device* device = nullptr;
    Device* (*newDevice)(int type);
    void (*setInt)(Device*, const char* name, int value);
    void (*commitDevice)(Device*);
    void (*releaseDevice)(Device*);
    int (*error)(Device*, const char** message);
    Filter* (*newFilter)(Device*, const char* type);
    void (*setImage)(Filter*, const char* name, void* first, int format, size_t width, size_t height, size_t offset, size_t pixelStride,
                     size_t rowStride);
    void (*setBool)(Filter*, const char* name, bool value);
    void (*setFilterInt)(Filter*, const char* name, int value);
    void (*commitFilter)(Filter*);
    void (*executeFilter)(Filter*);
    void (*releaseFilter)(Filter*);

    explicit Library(int threads) {
        const char* given = std::getenv("EIKONAL_OIDN");
        handle = ::dlopen(given && *given ? given : "libOpenImageDenoise.so.2", RTLD_NOW | RTLD_LOCAL);
        if (!handle) {
            const char* reason = ::dlerror();
            throw Error(ExitCode::scene,
                        fmt::format("cannot denoise: Intel Open Image Denoise 2 is not there ({}); docs/denoise.md says how to get it, and "
                                    "EIKONAL_OIDN=/path/to/libOpenImageDenoise.so.2 where it is",
                                    reason ? reason : "no reason given"));
        }
        find(newDevice, "oidnNewDevice");
        find(setInt, "oidnSetDeviceInt");
        find(commitDevice, "oidnCommitDevice");
        find(releaseDevice, "oidnReleaseDevice");
        find(error, "oidnGetDeviceError");
        find(newFilter, "oidnNewFilter");
        find(setImage, "oidnSetSharedFilterImage");
        find(setBool, "oidnSetFilterBool");
        find(setFilterInt, "oidnSetFilterInt");
        find(commitFilter, "oidnCommitFilter");
        find(executeFilter, "oidnExecuteFilter");
        find(releaseFilter, "oidnReleaseFilter");
        device = newDevice(cpuDevice);
        if (!device) check("cannot denoise: the library finds no processor that it can use");
        if (threads > 0) setInt(device, "numThreads", threads);
        commitDevice(device);
        check("cannot denoise");
    }
    Library(const Library&) = delete;
    ~Library() {
        if (device) releaseDevice(device);   // the library stays loaded: its threads may outlive it
    }

    void check(const char* what) const {
        const char* message = nullptr;
        if (error(device, &message) != 0)
            throw Error(ExitCode::scene, fmt::format("{}: Intel Open Image Denoise: {}", what, message ? message : "no reason given"));
    }

private:
    template <class Function> void find(Function& function, const char* name) {
        function = reinterpret_cast<Function>(::dlsym(handle, name));
        if (!function)
            throw Error(ExitCode::scene, fmt::format("cannot denoise: the library of Intel Open Image Denoise has no {}; version 2 has it",
                                                     name));
    }
};

Denoiser::Denoiser(int threads) : library_(std::make_unique<Library>(threads)) {}
Denoiser::~Denoiser() = default;

size_t Denoiser::bytes(size_t pixels) {
    return std::min(pixels * bytesPerPixel, size_t{mostMegabytes} << 20) + pixels * 4 * sizeof(glm::vec3);
}

void Denoiser::denoise(FilmImage& image) const {
    using Owned = OwnedFilter<Library>;
    const Vectors& noisy = image.noisy.empty() ? image.color : image.noisy;
    Vectors result(noisy.size()), albedo, normal;

    /* Guides without noise */
    const auto clean = [&](const char* name, const Vectors& guide) {
        Vectors cleaned(guide.size());
        if (guide.empty()) return cleaned;
        Owned filter(*library_, image);
        filter.set(name, guide);
        filter.set("output", cleaned);
        filter.execute();
        return cleaned;
    };
    albedo = clean("albedo", image.albedo);
    if (!albedo.empty()) normal = clean("normal", image.normal);   // of normals alone the library makes no use

    Owned filter(*library_, image);
    filter.set("color", noisy);
    if (!albedo.empty()) filter.set("albedo", albedo);
    if (!normal.empty()) filter.set("normal", normal);
    filter.set("output", result);
    filter.set("hdr", true);
    filter.set("cleanAux", true);
    filter.execute();
    if (image.noisy.empty()) image.noisy = std::move(image.color);
    image.color = std::move(result);
}

}  // namespace eikonal
