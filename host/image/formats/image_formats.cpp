#include "image/formats/image_formats.h"

#include "background.h"
#include "error.h"
#include "image/formats/signature.h"

#include <fmt/format.h>

#include <dlfcn.h>

namespace eikonal {

static const ImageFormats& loadFormats() {
    /* The dynamic linker finds it in the program's run path */
    void* const library = ::dlopen("libeikonal_openimageio.so", RTLD_LAZY | RTLD_LOCAL);
    void* const symbol = library ? ::dlsym(library, "eikonal_image_formats") : nullptr;
    if (!symbol) throw Error(ExitCode::scene, fmt::format("images cannot be read: {}", ::dlerror()));
    return *reinterpret_cast<const ImageFormats* (*)()>(symbol)();
}

const ImageFormats& imageFormats() {
    static const ImageFormats& formats = loadFormats();
    return formats;
}

void beginLoadingImageFormats() {
    /* The program's end waits for the library. An error is thrown again when an image is read */
    static const std::future<void> loading = inBackground([] {
        try {
            imageFormats();
        } catch (const Error&) {
        }
    });
}

std::unique_ptr<ImageReader> openImage(const std::string& path, bool isAlphaApart, std::string& error) {
    const ImageSignature signature = recognizeImage(path);
    if (signature.format) return imageFormats().open(path, signature.format, isAlphaApart, error);
    error = signature.problem;
    return nullptr;
}

}  // namespace eikonal
