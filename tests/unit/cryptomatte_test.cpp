// Hashes, IDs and manifests as the specification of Cryptomatte has them, and slots that join.

#include "film/join_mattes.h"
#include "image/cryptomatte.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

namespace eikonal {
namespace {

TEST(Cryptomatte, HashesAreThoseOfTheSpecification) {
    EXPECT_EQ(murmurHash3("torus"), 4053562365u);
    EXPECT_EQ(murmurHash3("равнина"), 2518896926u);
    EXPECT_FLOAT_EQ(std::bit_cast<float>(cryptomatteId("torus")), -1.54943624832e+30f);
    EXPECT_FLOAT_EQ(std::bit_cast<float>(cryptomatteId("равнина")), -1.31926312124e-25f);
    /* Manifests of Psyop's sample images: these lengths leave 1, 2, 3 and 0 bytes after the last word */
    EXPECT_EQ(murmurHash3(""), 0u);
    EXPECT_EQ(cryptomatteId("bunny"), 0x13851a76u);
    EXPECT_EQ(cryptomatteId("default"), 0x42c9679fu);
    EXPECT_EQ(cryptomatteId("bunny_porcelain_mat"), 0xb24b26d4u);
}

TEST(Cryptomatte, IdsAreNormalNumbers) {
    size_t flipped = 0;
    for (int i = 0; i < 20000; ++i) {
        const std::string name = "object" + std::to_string(i);
        const std::uint32_t id = cryptomatteId(name);
        EXPECT_TRUE(std::isnormal(std::bit_cast<float>(id))) << name;
        EXPECT_EQ((id ^ murmurHash3(name)) & ~(1u << 23), 0u) << name;
        flipped += id != murmurHash3(name);
    }
    EXPECT_NEAR(static_cast<double>(flipped), 20000 * 2 / 256., 60) << "two of 256 exponents, within 5 standard deviations";
}

TEST(Cryptomatte, ManifestIsJson) {
    EXPECT_EQ(cryptomatteManifest({{"bunny", 0x13851a76u}, {"a \"b\"\\c", 1u}}), R"({"a \"b\"\\c":"00000001","bunny":"13851a76"})");
    EXPECT_EQ(cryptomatteName("gr\xfc" "n"), "gr\xef\xbf\xbdn");
    EXPECT_EQ(cryptomatteName("grün"), "grün");
    EXPECT_EQ(cryptomatteAttribute("CryptoObject", "name"), "cryptomatte/3ae39a5/name") << "the hash of the layer's name";
    EXPECT_EQ(cryptomatteChannel("CryptoObject", 7), "CryptoObject01.a");
}

Mattes of(std::initializer_list<Matte> some) {
    Mattes all{};
    std::copy(some.begin(), some.end(), all.begin());
    return all;
}
float weightOf(const Mattes& mattes, uint id) {
    for (const Matte& m : mattes)
        if (m.id == id) return m.weight;
    return 0;
}

TEST(JoinMattes, WeightsOfEqualIdsAddUp) {
    Mattes now = of({{7, 2}, {5, 1}});
    joinMattes(of({{5, 3}, {9, .5f}}), now);
    EXPECT_EQ(weightOf(now, 5), 4);
    EXPECT_EQ(weightOf(now, 7), 2);
    EXPECT_EQ(weightOf(now, 9), .5f);
}

/// Of more IDs than slots the heaviest stay, whichever side they come from.
TEST(JoinMattes, TheLightestLoseTheirSlots) {
    std::vector<Matte> all;
    for (uint id = 1; id <= 2 * MATTE_SLOTS; ++id) all.push_back({id, id == 3 ? 100.f : id == 4 ? -1.f : static_cast<float>(id / 2)});
    std::shuffle(all.begin(), all.end(), std::mt19937(1));
    Mattes earlier, now;
    std::copy_n(all.begin(), MATTE_SLOTS, earlier.begin());
    std::copy_n(all.begin() + MATTE_SLOTS, MATTE_SLOTS, now.begin());
    joinMattes(earlier, now);
    EXPECT_EQ(weightOf(now, 3), 100);
    EXPECT_EQ(weightOf(now, 4), 0);
    /* Beside 3: the heaviest are 32, then pairs of equal weight from 31 and 30 down to 19 and 18: 16 in all */
    for (uint id = 18; id <= 2 * MATTE_SLOTS; ++id) EXPECT_EQ(weightOf(now, id), static_cast<float>(id / 2)) << id;
    EXPECT_EQ(weightOf(now, 17), 0);
}

}  // namespace
}  // namespace eikonal
