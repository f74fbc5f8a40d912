// Which medium is around a light: as paths from the camera find it.

#include "pack/light_media.h"

#include "pbrt_reading.h"

namespace eikonal {
namespace {

class LightMediaTest : public PbrtTest {
protected:
    /// A scene with the media a (0) and b (1), seen from z = -5 through medium `around`.
    Scene sceneOf(const std::string& world, const std::string& around = "") {
        return read("MakeNamedMedium \"a\" \"string type\" \"homogeneous\"\nMakeNamedMedium \"b\" \"string type\" \"homogeneous\"\n"
                    "MediumInterface \"\" \"" + around + "\"\nLookAt 0 0 -5  0 0 0  0 1 0\nCamera \"perspective\"\nWorldBegin\n"
                    "MediumInterface \"\" \"\"\n" + world);
    }
};
const std::string ball = "AttributeBegin MediumInterface \"a\" \"\" Shape \"sphere\" AttributeEnd\n",
                  inner = "AttributeBegin MediumInterface \"b\" \"a\" Shape \"sphere\" \"float radius\" .5 AttributeEnd\n";
/// Two walls, at z = -1 and 1, with a in between.
std::string slab(const std::string& head) {
    return "AttributeBegin MediumInterface \"a\" \"\" " + head +
           "Shape \"bilinearmesh\" \"point3 P\" [9 -9 -1  -9 -9 -1  9 9 -1  -9 9 -1]\n"
           "Shape \"bilinearmesh\" \"point3 P\" [-9 -9 1  9 -9 1  -9 9 1  9 9 1] AttributeEnd\n";
}

TEST_F(LightMediaTest, IsThatOfTheNearestBoundaryOnTheWayToTheCamera) {
    const Scene scene = sceneOf(ball + inner);
    const LightMedia media(scene);
    EXPECT_EQ(media.at({0, 0, 3}), none);
    EXPECT_EQ(media.at({0, 0, .8}), 0);
    EXPECT_EQ(media.at({.1, .1, .2}), 1);
    EXPECT_EQ(media.at({3, 0, 0}), none);
    EXPECT_EQ(media.outside(), none);
    EXPECT_FALSE(media.contradiction());

    const Scene filled = sceneOf("", "b");
    EXPECT_EQ(LightMedia(filled).at({1, 2, 3}), 1);
    EXPECT_EQ(LightMedia(filled).outside(), 1);
}

/// Sides are those of kernels: of the cross product of the edges, turned by ReverseOrientation and by transforms that mirror, or those of
/// vertex normals.
TEST_F(LightMediaTest, KnowsTheSidesOfMeshes) {
    for (const char* head : {"", "Scale 1 -1 1 ", "Scale -1 1 1 "}) {
        const Scene scene = sceneOf(slab(head));
        EXPECT_EQ(LightMedia(scene).at({.3, .2, 0}), 0) << head;
        EXPECT_EQ(LightMedia(scene).at({.3, .2, 2}), none) << head;
        EXPECT_FALSE(LightMedia(scene).contradiction()) << head;
    }
    const Scene turned = sceneOf(slab("ReverseOrientation "));
    const auto contradiction = LightMedia(turned).contradiction();
    ASSERT_TRUE(contradiction);
    EXPECT_EQ(contradiction->said, 0);
    EXPECT_EQ(contradiction->found, none);

    const std::string wall = "AttributeBegin MediumInterface \"a\" \"\" Shape \"trianglemesh\" \"point3 P\" [-9 -9 0  9 -9 0  0 9 0] ",
                      normals = "\"normal N\" [0 0 -1  0 0 -1  0 0 -1] AttributeEnd";
    EXPECT_EQ(LightMedia(sceneOf(wall + "AttributeEnd")).at({0, 0, 1}), none);
    EXPECT_EQ(LightMedia(sceneOf(wall + normals)).at({0, 0, 1}), 0);
}

/// What is sunk into an opaque boundary is in what that bounds, where no path goes.
TEST_F(LightMediaTest, LooksForContradictionsWhereTheCameraSees) {
    const std::string head = "MediumInterface \"\" \"a\" ",
                      ground = "Shape \"bilinearmesh\" \"point3 P\" [-9 -1 -9  -9 -1 9  9 -1 -9  9 -1 9]\n",
                      sunk = "Shape \"bilinearmesh\" \"point3 P\" [-1 -4 2  -1 .5 2  1 -4 2  1 .5 2]\n";
    EXPECT_FALSE(LightMedia(sceneOf(head + ground + sunk, "a")).contradiction());
    EXPECT_TRUE(LightMedia(sceneOf(head + ground + sunk)).contradiction()) << "the camera is not in it";
    const std::string water = "Material \"interface\" MediumInterface \"a\" \"b\" " + ground + "Material \"diffuse\" " + head + sunk;
    EXPECT_TRUE(LightMedia(sceneOf(water)).contradiction());
}

TEST_F(LightMediaTest, MayLeaveOutALampsOwnShape) {
    const Scene scene = sceneOf(ball + inner);
    EXPECT_EQ(LightMedia(scene).at({.1, .1, .2}, &scene.shapes[1]), 0);
    EXPECT_EQ(LightMedia(scene).at({.1, .1, .2}, &scene.shapes[0]), 1);
}

TEST_F(LightMediaTest, SaysWhatItCannotTell) {
    const std::string part = "AttributeBegin MediumInterface \"a\" \"\" Shape \"sphere\" \"float zmax\" .5 AttributeEnd\n",
                      moving = "AttributeBegin ActiveTransform EndTime Translate 0 1 0 ActiveTransform All " + ball + "AttributeEnd\n",
                      object = "ObjectBegin \"o\" " + ball + "ObjectEnd ObjectInstance \"o\"\n";
    for (const std::string& shape : {part, moving, object}) {
        const Scene scene = sceneOf(shape);
        EXPECT_FALSE(LightMedia(scene).at({0, 0, 0}).has_value()) << shape;
        EXPECT_EQ(LightMedia(scene).at({5, 0, -5}), none) << shape;
    }
}

}  // namespace
}  // namespace eikonal
