#include "film/join_mattes.h"

#include "film/sample_nodes.h"

#include <algorithm>
#include <bit>

namespace eikonal {

static_assert(MATTE_SLOTS >= leafSamples, "each ID of a leaf has a slot");

void joinMattes(std::span<const Matte, MATTE_SLOTS> earlier, std::span<Matte, MATTE_SLOTS> now) {
    std::array<Matte, 2 * MATTE_SLOTS> all{};
    std::size_t count = 0;
    const auto add = [&](const Matte& matte) {
        if (!matte.id) return;
        const auto end = all.begin() + static_cast<std::ptrdiff_t>(count);
        const auto found = std::find_if(all.begin(), end, [&](const Matte& other) { return other.id == matte.id; });
        if (found == end) all[count++] = matte;
        else found->weight = static_cast<float>(double{found->weight} + double{matte.weight});
    };
    for (const Matte& matte : earlier) add(matte);
    for (const Matte& matte : now) add(matte);
    if (count > MATTE_SLOTS)
        std::sort(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count), [](const Matte& a, const Matte& b) {
            return a.weight > b.weight || (a.weight == b.weight && a.id < b.id);
        });
    std::copy_n(all.begin(), MATTE_SLOTS, now.begin());
}

void joinMattes(PixelRow<const uint> earlier, PixelRow<uint> row, int slot, std::size_t count) {
    const auto at = [&](const auto& pixels, std::size_t k, std::size_t word) {
        return pixels.first + (static_cast<std::size_t>(slot) + MATTE_WORDS * k + word) * pixels.stride;
    };
    const auto load = [&](const auto& pixels, std::size_t i) {
        Mattes mattes;
        for (std::size_t k = 0; k < MATTE_SLOTS; ++k) mattes[k] = {at(pixels, k, 0)[i], std::bit_cast<float>(at(pixels, k, 1)[i])};
        return mattes;
    };
    for (std::size_t i = 0; i < count; ++i) {
        Mattes now = load(row, i);
        joinMattes(load(earlier, i), now);
        for (std::size_t k = 0; k < MATTE_SLOTS; ++k) {
            at(row, k, 0)[i] = now[k].id;
            at(row, k, 1)[i] = std::bit_cast<uint>(now[k].weight);
        }
    }
}

}  // namespace eikonal
