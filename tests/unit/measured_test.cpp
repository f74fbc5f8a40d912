// Files of measured BSDFs: what is in them, and what is said about broken ones.

#include "measured_file.h"
#include "read/formats/measured_bsdf.h"
#include "read/formats/read_bytes.h"
#include "unit/temporary_folder.h"

#include <gmock/gmock.h>

#include <cstring>
#include <limits>

namespace eikonal {
namespace {

using testing::HasSubstr;
using Arrays = std::map<std::string, MeasuredFile::Array>;

class MeasuredTest : public TemporaryFolder {
protected:
    /// What is wrong with a file; "nothing" if nothing is.
    std::string problemOf(const std::string& bytes) {
        try {
            readMeasuredBsdf(write("a.bsdf", bytes));
            return "nothing";
        } catch (const ReadProblem& problem) { return problem.what(); }
    }
    std::string problemOf(const Arrays& arrays) { return problemOf(MeasuredFile::bytes(arrays)); }
    Arrays good = MeasuredFile().arrays();

    static void set(MeasuredFile::Array& array, size_t index, float value) { std::memcpy(array.bytes.data() + index * sizeof value, &value, sizeof value); }
};

TEST_F(MeasuredTest, filesAreReadAsWritten) {
    MeasuredFile file;
    file.reflectance = [](double nm) { return nm / 1000; };
    file.write(path("a.bsdf"));
    const auto bsdf = readMeasuredBsdf(path("a.bsdf"));
    EXPECT_TRUE(bsdf->isIsotropic());
    EXPECT_EQ(bsdf->theta.size(), 7u);
    EXPECT_EQ(bsdf->wavelengths.front(), 360);
    EXPECT_EQ(bsdf->visible.width, 32u);
    EXPECT_EQ(bsdf->visible.values.size(), 7u * 32 * 32);
    EXPECT_EQ(bsdf->facets.height, 2u);
    /* The wavelength comes before the grid */
    EXPECT_FLOAT_EQ(bsdf->spectra.values[25], 0.407f);
    file.isotropic = false;
    file.write(path("a.bsdf"));
    EXPECT_FALSE(readMeasuredBsdf(path("a.bsdf"))->isIsotropic());
}

TEST_F(MeasuredTest, brokenFilesAreRefused) {
    EXPECT_EQ(problemOf(good), "nothing");
    const std::string bytes = MeasuredFile::bytes(good);
    EXPECT_THAT(problemOf(std::string("hello")), HasSubstr("is not a tensor file"));
    EXPECT_THAT(problemOf(bytes.substr(0, 15)), HasSubstr("ends at byte 15"));
    for (const size_t length : {size_t(16), size_t(40), size_t(200)}) EXPECT_NE(problemOf(bytes.substr(0, length)), "nothing") << length;
    EXPECT_THAT(problemOf(bytes.substr(0, bytes.size() - 1)), HasSubstr("is cut short"));
    std::string newer = bytes;
    newer[12] = 2;
    EXPECT_THAT(problemOf(newer), HasSubstr("has version 2.0"));
    EXPECT_THROW(readMeasuredBsdf(path("nowhere.bsdf")), ReadProblem);
}

// No byte of the header can be such that the reader crashes, or reads beyond the file.
TEST_F(MeasuredTest, anyByteOfTheHeaderMayBeWrong) {
    const std::string bytes = MeasuredFile::bytes(good);
    for (size_t at = 0; at < 400; ++at)
        for (const char wrong : {'\0', '\1', '\x7f', '\xff'}) {
            std::string spoilt = bytes;
            spoilt[at] = wrong;
            problemOf(spoilt);
        }
}

TEST_F(MeasuredTest, arraysMustFitEachOther) {
    Arrays a = good;
    a.erase("vndf");
    EXPECT_THAT(problemOf(a), HasSubstr("no array \"vndf\""));
    a = good;
    a["spectra"].shape = {1, 7, 10, 5, 5};
    EXPECT_THAT(problemOf(a), HasSubstr("\"spectra\" of shape [1, 7, 10, 5, 5]"));
    a = good;
    a["ndf"].shape = {64, 1};
    EXPECT_THAT(problemOf(a), HasSubstr("at least 2 x 2 are needed"));
    a = good;
    set(a["theta_i"], 3, 0);
    EXPECT_THAT(problemOf(a), HasSubstr("\"theta_i\", which is not ascending"));
    a = good;
    set(a["sigma"], 5, std::numeric_limits<float>::quiet_NaN());
    EXPECT_THAT(problemOf(a), HasSubstr("\"sigma\" that are not finite"));
    a = good;
    set(a["ndf"], 5, -1);
    EXPECT_THAT(problemOf(a), HasSubstr("below zero in \"ndf\""));
    a = good;
    for (size_t i = 0; i < 25; ++i) set(a["luminance"], 25 + i, 0);
    EXPECT_THAT(problemOf(a), HasSubstr("a grid of zeros in \"luminance\""));
    a = MeasuredFile{.isotropic = false}.arrays();
    for (int i = 0; i < 9; ++i) set(a["phi_i"], static_cast<size_t>(i), 0.3f * static_cast<float>(i) / 8);
    EXPECT_THAT(problemOf(a), HasSubstr("of a turn only"));
}

}  // namespace
}  // namespace eikonal
