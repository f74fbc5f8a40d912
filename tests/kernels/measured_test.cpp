// Tables of measured surfaces are searched in a number of steps that is fixed when the kernel is built.

#include "device_function.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

namespace eikonal {
namespace {

// Between which neighbours of an ascending list a number is, for lists of 1 to 33 squares: 33 are the most whose 32 intervals five steps
// halve until one is left. Numbers are on each square, between them, and beyond both ends, where the place is the end.
TEST(MeasuredSearch, FiveStepsFindTheIntervalInListsOfUpTo33) {
    constexpr uint longest = 33;
    const DeviceFunction<vec2> find(
        {.include = "bsdf/measured_grid.clh",
         .type = "vec2",
         .body = "measured_step at = find_step(squares_array[index].n, length, x); result = make_vec2(float_of(at.i), at.t);",
         .inputs = {"list squares", "uint length", "float x"},
         .declarations = "typedef struct { float n[33]; } list;",
         .constants = {.measuredAngleSteps = 5}});
    WordArray lists{longest, {}};
    std::vector<uint> lengths;
    std::vector<float> numbers;
    std::vector<vec2> expected;
    for (uint length = 1; length <= longest; ++length)
        for (uint i = 0; i < length; ++i)
            for (const float t : {-0.5f, 0.0f, 0.25f, 0.5f}) {
                if (t < 0 && i > 0) continue;
                for (uint n = 0; n < longest; ++n) lists.data.push_back(std::bit_cast<uint>(static_cast<float>(n * n)));
                lengths.push_back(length);
                numbers.push_back(static_cast<float>(i * i) + t * static_cast<float>(2 * i + 1));
                const bool isBeyond = i + 1 == length;
                expected.push_back({static_cast<float>(isBeyond && i > 0 ? i - 1 : i), length == 1 ? 0 : isBeyond ? 1 : std::max(t, 0.0f)});
            }
    const std::vector<vec2> found = find(lists, lengths, numbers);
    for (size_t i = 0; i < found.size(); ++i) {
        EXPECT_EQ(found[i].x, expected[i].x) << numbers[i] << " among the first " << lengths[i] << " squares";
        EXPECT_FLOAT_EQ(found[i].y, expected[i].y) << numbers[i] << " among the first " << lengths[i] << " squares";
    }
}

}  // namespace
}  // namespace eikonal
