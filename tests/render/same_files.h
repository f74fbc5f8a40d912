#pragma once
// Comparison of image files by bits.

#include "image/channels.h"
#include "image/image_file.h"

#include <gtest/gtest.h>

#include <cstring>

namespace eikonal {

/// Every channel of two files has the same bits.
inline void expectSameFiles(const std::string& a, const std::string& b) {
    const FilmImage first = readImage(a).image, second = readImage(b).image;
    const auto firsts = channelsOf<const float>(first), seconds = channelsOf<const float>(second);
    ASSERT_EQ(firsts.size(), seconds.size());
    ASSERT_EQ(first.pixelCount(), second.pixelCount());
    for (size_t c = 0; c < firsts.size(); ++c) {
        ASSERT_EQ(firsts[c].name, seconds[c].name);
        for (size_t i = 0; i < first.pixelCount(); ++i)
            ASSERT_EQ(std::memcmp(&firsts[c][i], &seconds[c][i], sizeof(float)), 0) << firsts[c].name << " of pixel " << i << " of " << b;
    }
}

}  // namespace eikonal
