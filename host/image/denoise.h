#pragma once
// Removes noise with Intel Open Image Denoise, which is loaded at run time: it is no Debian package, and its library has 50 MB.

#include "image/film_image.h"

#include <memory>

namespace eikonal {

class Denoiser {
public:
    /// Loads the library: the file in the environment variable EIKONAL_OIDN, or libOpenImageDenoise.so.2 where the system finds it.
    /// `threads` is how many it may use; 0: one per core. Throws Error (ExitCode::scene) that says how to get it.
    explicit Denoiser(int threads);
    ~Denoiser();

    /// Replaces image.color by what is left without noise, and keeps what was there in image.noisy. An image that has `noisy` is denoised
    /// from it. Albedo and normal guide it where the image has them; they are freed of noise first, and stay as they are. The image is
    /// biased: edges that no guide shows may be blurred. Same image, same bits. Throws Error (ExitCode::scene); then the image is as
    /// before.
    void denoise(FilmImage& image) const;

    /// Memory that denoising takes, besides the image.
    static size_t bytes(size_t pixels);

private:
    struct Library;
    std::unique_ptr<Library> library_;
};

}  // namespace eikonal
