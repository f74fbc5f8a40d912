#include "image/formats/image_formats.h"

#include "error.h"

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

}  // namespace eikonal
