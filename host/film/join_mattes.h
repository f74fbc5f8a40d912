#pragma once
// Adds the Cryptomatte slots of one range of samples to those of another.

#include "eikonal/film.h"
#include "film/pixel_row.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace eikonal {

/// The weight of a Cryptomatte ID in a pixel; an ID of 0: a free slot.
struct Matte { uint id = 0; float weight = 0; };
using Mattes = std::array<Matte, MATTE_SLOTS>;

/// Adds `earlier` to `now`. Each ID keeps a slot unless there are more than MATTE_SLOTS: then those with the smallest weights lose theirs,
/// of equal ones those with the larger ID, and their weight is in no slot.
void joinMattes(std::span<const Matte, MATTE_SLOTS> earlier, std::span<Matte, MATTE_SLOTS> now);

/// The same for `count` pixels in a row, whose slots begin at word `slot`.
void joinMattes(PixelRow<const uint> earlier, PixelRow<uint> row, int slot, std::size_t count);

}  // namespace eikonal
