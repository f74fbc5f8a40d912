#include "pack/colors.h"
#include "pack/packer.h"

#include <algorithm>

namespace eikonal {

/// The least part of the wavelengths that is within the film's range; the rest is beside it, and makes the pixels' colours complete. Of a
/// path's four wavelengths one, then.
constexpr double leastShare = 0.75;

void packSpectrumKept(Packer& packer) {
    const FilmDescription& film = packer.scene.film;
    if (!film.spectrum) return;
    packer.packed.require(Feature::SPECTRAL_FILM, film.where.toString());
    packer.packed.frame().bucket_count = static_cast<uint>(film.spectrum->buckets);

    /* Even over all that the eye sees, unless that leaves too few to the range */
    const double all = longestWavelength - shortestWavelength, extent = film.spectrum->last - film.spectrum->first;
    const double share = std::max(extent / all, leastShare), inversePdf = extent / share;
    const double beside = share < 1 ? (all - extent) / (1 - share) : inversePdf;
    const auto toFloat = [](double x) { return static_cast<float>(x); };
    packer.packed.tables.wavelengths.push_back(
        {toFloat(film.spectrum->first), toFloat(extent), toFloat(share), toFloat(inversePdf), toFloat(beside)});
}

}  // namespace eikonal
