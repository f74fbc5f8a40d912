// Curves of every basis and degree become cubic Bezier segments. Points of the curves are those of the definitions of their bases.

#include "unit/pbrt_reading.h"

#include <cmath>

namespace eikonal {
namespace {

class PbrtCurves : public PbrtTest {
protected:
    Curve curve(const std::string& parameters) { return *world("Shape \"curve\" " + parameters).shapes.at(0).curve; }
    std::string error(const std::string& parameters) { return errorOfWorld("Shape \"curve\" " + parameters); }
};

glm::vec3 at(const CurveSegment& s, float u) {
    const float v = 1 - u;
    return v * v * v * s.points[0] + 3 * v * v * u * s.points[1] + 3 * v * u * u * s.points[2] + u * u * u * s.points[3];
}

const std::vector<glm::vec3> points{{0, 0, 0}, {1, 3, 0}, {2, -1, 1}, {4, 0, 2}, {5, 5, 1}, {3, 2, 0}, {1, 1, 1}};
const std::string seven = "\"point3 P\" [0 0 0  1 3 0  2 -1 1  4 0 2  5 5 1  3 2 0  1 1 1] ";

TEST_F(PbrtCurves, defaults) {
    const Curve c = curve("\"point3 P\" [0 0 0  1 0 0  2 0 0  3 0 0]");
    EXPECT_EQ(c.type, curve_flat);
    EXPECT_EQ(c.splitDepth, 3);
    ASSERT_EQ(c.segments.size(), 1u);
    EXPECT_EQ(c.segments[0].width, (std::array{1., 1.}));
}

TEST_F(PbrtCurves, bezierSegmentsShareTheirEnds) {
    const Curve cubic = curve(seven), quadratic = curve(seven + "\"integer degree\" 2");
    ASSERT_EQ(cubic.segments.size(), 2u);
    EXPECT_EQ(cubic.segments[1].points, (std::array{points[3], points[4], points[5], points[6]}));
    ASSERT_EQ(quadratic.segments.size(), 3u);
    for (size_t i = 0; i < 3; ++i)
        for (const float u : {0.f, .3f, .5f, 1.f}) {
            const glm::vec3 want = (1 - u) * (1 - u) * points[2 * i] + 2 * u * (1 - u) * points[2 * i + 1] + u * u * points[2 * i + 2];
            EXPECT_LT(glm::distance(at(quadratic.segments[i], u), want), 1e-5f);
        }
}

/// The basis functions of uniform B-splines.
TEST_F(PbrtCurves, splines) {
    const Curve cubic = curve(seven + "\"string basis\" \"bspline\""),
                quadratic = curve(seven + "\"string basis\" \"bspline\" \"integer degree\" 2");
    ASSERT_EQ(cubic.segments.size(), 4u);
    ASSERT_EQ(quadratic.segments.size(), 5u);
    for (const float u : {0.f, .3f, .5f, 1.f}) {
        const float v = 1 - u;
        for (size_t i = 0; i < 4; ++i) {
            const glm::vec3 want = (v * v * v * points[i] + (3 * u * u * u - 6 * u * u + 4) * points[i + 1] +
                                    (3 * v * v * v - 6 * v * v + 4) * points[i + 2] + u * u * u * points[i + 3]) /
                                   6.f;
            EXPECT_LT(glm::distance(at(cubic.segments[i], u), want), 1e-5f);
        }
        for (size_t i = 0; i < 5; ++i) {
            const glm::vec3 want = (v * v * points[i] + (1 + 2 * u * v) * points[i + 1] + u * u * points[i + 2]) / 2.f;
            EXPECT_LT(glm::distance(at(quadratic.segments[i], u), want), 1e-5f);
        }
    }
}

TEST_F(PbrtCurves, widthsAndNormalsGoFromEndToEnd) {
    const Curve c = curve(seven + "\"string type\" \"ribbon\" \"normal N\" [0 0 1  0 1 0  1 0 0] \"float width\" 3 \"float width1\" 1");
    EXPECT_EQ(c.type, curve_ribbon);
    EXPECT_EQ(c.segments[0].width, (std::array{3., 2.}));
    EXPECT_EQ(c.segments[1].width, (std::array{2., 1.}));
    EXPECT_EQ(c.segments[1].normals, (std::array{glm::vec3(0, 1, 0), glm::vec3(1, 0, 0)}));
}

TEST_F(PbrtCurves, AWidthThatBothEndsReplaceIsWarnedOf) {
    EXPECT_EQ(curve(seven + "\"float width\" 3 \"float width0\" 2 \"float width1\" 1").segments[1].width, (std::array{1.5, 1.}));
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("\"float width\" is ignored: nothing here uses it")));
}

TEST_F(PbrtCurves, AWidthOfZeroIsWarnedOf) {
    curve(seven + "\"float width\" 0");
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("shape \"curve\" has a width of 0, so it is not seen")));
    curve(seven + "\"float width0\" 0 \"float width1\" 1");
    EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(PbrtCurves, errors) {
    EXPECT_THAT(error(""), HasSubstr("needs its control points, \"point3 P\""));
    EXPECT_THAT(error("\"point3 P\" [0 0 0 1 0 0 2 0 0 3 0 0 4 0 0]"),
                HasSubstr("has 5 control points; of degree 3 in the basis \"bezier\" it has 4, and 3 for each further segment"));
    EXPECT_THAT(error("\"string basis\" \"bspline\" \"point3 P\" [0 0 0 1 0 0 2 0 0]"),
                HasSubstr("has 3 control points; of degree 3 in the basis \"bspline\" it has 4 or more"));
    EXPECT_THAT(error(seven + "\"integer degree\" 4"), HasSubstr("\"integer degree\" is 4; it must be in [2, 3]"));
    EXPECT_THAT(error(seven + "\"string basis\" \"catmull\""), HasSubstr("it can be \"bezier\" or \"bspline\""));
    EXPECT_THAT(error(seven + "\"string type\" \"ribbon\" \"normal N\" [0 0 1]"),
                HasSubstr("at both ends of each segment: 3 normals, not 1"));
}

TEST_F(PbrtCurves, whatMakesNoSenseIsNamed) {
    EXPECT_THAT(error(seven + "\"string type\" \"tube\""), HasSubstr("it can be \"flat\", \"cylinder\" or \"ribbon\""));
    curve(seven + "\"normal N\" [0 0 1  0 1 0  1 0 0]");
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("only curves of type \"ribbon\" have normals")));
    EXPECT_EQ(world("AreaLightSource \"diffuse\" Shape \"curve\" " + seven).shapes[0].areaLight, none);
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("a curve cannot emit")));
}

}  // namespace
}  // namespace eikonal
