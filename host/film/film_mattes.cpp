#include "film/join_mattes.h"
#include "film/totals.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>

namespace eikonal {

void FilmTotals::developMattes(FilmImage& image, const char* field, const char* name, const std::string& manifest) const {
    constexpr std::size_t ranks = CryptomatteLayer::ranks, perPixel = CryptomatteLayer::perPixel;
    const size_t n = plane();
    CryptomatteLayer layer{name, manifest, std::vector<float>(n * perPixel)};
    const float* weight = floats("weight");
    const uint* words = numbers(field);
    tbb::parallel_for(size_t{0}, n, [&](size_t i) {
        if (weight[i] == 0) return;
        Mattes mattes;
        for (size_t k = 0; k < MATTE_SLOTS; ++k) {
            const uint* const slot = words + MATTE_WORDS * k * n + i;
            if (slot[0]) mattes[k] = {slot[0], static_cast<float>(double{std::bit_cast<float>(slot[n])} / double{weight[i]})};
        }
        const auto used = std::partition(mattes.begin(), mattes.end(), [](const Matte& m) { return m.id != 0; });
        std::sort(mattes.begin(), used,
                  [](const Matte& a, const Matte& b) { return a.weight > b.weight || (a.weight == b.weight && a.id < b.id); });
        float* values = &layer.values[i * perPixel];
        for (size_t rank = 0; rank < ranks; ++rank) {
            values[2 * rank] = mattes[rank].id == NO_SURFACE_ID ? 0 : std::bit_cast<float>(mattes[rank].id);
            values[2 * rank + 1] = mattes[rank].weight;
        }
    });
    image.cryptomattes.push_back(std::move(layer));
}

}  // namespace eikonal
