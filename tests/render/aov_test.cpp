// What is known of surfaces besides their light: albedo by the rules of denoisers, normals, positions, depths, numbers.

#include "rendering.h"

#include <fmt/format.h>

namespace eikonal {
namespace {

Rendered renderAovs(const View& view, const std::string& world) {
    PackedScene scene = packScene(sceneText(view, world));
    scene.require(Feature::AOVS, "the test");
    return render(std::move(scene));
}

View view(double fov = 0.02, int size = 8) {
    View v;
    v.fov = fov;
    v.width = v.height = size;
    v.samples = 64;
    return v;
}

void expectAlbedo(const Rendered& r, glm::vec3 expected, float tolerance) {
    glm::vec3 mean(0);
    for (const glm::vec3& a : r.image.albedo) mean += a / static_cast<float>(r.image.albedo.size());
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c], expected[c], tolerance);
}

constexpr const char* wall =
    "LightSource \"point\" Material \"diffuse\" \"rgb reflectance\" [.5 .4 .3] Shape \"bilinearmesh\" \"point3 P\" [-9 -9 2  9 -9 2  -9 9 "
    "2  9 9 2]\n";

/// However it is lit, and however it is looked at.
TEST(Aovs, AlbedoIsTheReflectance) {
    expectAlbedo(renderAovs(view(), wall), {.5f, .4f, .3f}, 1e-6f);
    View oblique = view();
    oblique.lookAt = "6 1 0  0 0 2  0 1 0";
    expectAlbedo(renderAovs(oblique, wall), {.5f, .4f, .3f}, 1e-6f);
}

/// Seen in a mirror of reflectance 0.5, 0.25, 0.75 (that seen straight on is, and under 45 degrees nearly), it is what that leaves of it.
TEST(Aovs, AlbedoIsSeenInMirrors) {
    const std::string mirror =
        "LightSource \"point\" Material \"conductor\" \"rgb reflectance\" [.5 .25 .75] \"float roughness\" 0 Shape \"bilinearmesh\" "
        "\"point3 P\" [-1 -1 0  1 -1 0  -1 1 0  1 1 0]\n"
        "Material \"diffuse\" \"rgb reflectance\" [.5 .5 .5] Shape \"bilinearmesh\" \"point3 P\" [-9 -9 -9  9 -9 -9  -9 9 -9  9 9 -9]";
    const Rendered r = renderAovs(view(), mirror);
    expectAlbedo(r, {.25f, .125f, .375f}, 2e-2f);
    /* What is first stays what it is */
    EXPECT_NEAR(r.image.depth[3], 4, 1e-4);
    EXPECT_EQ(r.image.object[3], 1);
    EXPECT_EQ(r.image.material[3], 1);
}

/// Through glass in a room of one albedo there is nothing else to be seen, whichever way a path takes.
TEST(Aovs, AlbedoIsSeenThroughGlass) {
    View v = view(40, 12);
    v.maxDepth = 100;
    expectAlbedo(renderAovs(v,
                            "LightSource \"point\" Material \"dielectric\" Shape \"sphere\" Material \"diffuse\" \"rgb reflectance\" [.5 "
                            ".4 .3] Shape \"sphere\" \"float radius\" 9"),
                 {.5f, .4f, .3f}, 3e-3f);
}

/// A rough surface is seen itself, not what it mirrors; where nothing is, it is black.
TEST(Aovs, AlbedoEndsAtTheFirstRoughSurface) {
    const std::string metal =
        "LightSource \"point\" Material \"diffuse\" \"rgb reflectance\" [.5 .5 .5] Shape \"bilinearmesh\" \"point3 P\" [-9 -9 -9  9 -9 -9  "
        "-9 9 -9  9 9 -9]\n"
        "Material \"conductor\" \"rgb reflectance\" [.9 .9 .9] \"float roughness\" .4 Shape \"bilinearmesh\" \"point3 P\" [-1 -1 0  1 -1 0 "
        " -1 1 0  1 1 0]\n";
    expectAlbedo(renderAovs(view(), metal), glm::vec3(.9f), 1e-3f);
    expectAlbedo(renderAovs(view(), "LightSource \"infinite\" \"rgb L\" [1 1 1]"), glm::vec3(0), 0);
}

/// The first surface in world space, whatever the scene's own space is.
TEST(Aovs, PositionsAndNormalsAreThoseOfTheWorld) {
    View v = view();
    v.lookAt = "103 0 -4  103 0 0  0 1 0";
    const Rendered r = renderAovs(v, R"(LightSource "point" AttributeBegin Translate 100 0 0 Rotate 45 0 1 0
        Shape "trianglemesh" "integer indices" [0 1 2 0 2 3] "point3 P" [-9 -9 0  9 -9 0  9 9 0  -9 9 0]
            "normal N" [1 0 -2  1 0 -2  1 0 -2  1 0 -2] AttributeEnd)");
    const glm::vec3 p = r.image.position[9], ng = r.image.geometricNormal[9], n = r.image.normal[9];
    EXPECT_NEAR(p.x, 103, 2e-3);
    EXPECT_NEAR(p.y, 0, 2e-3);
    EXPECT_NEAR(p.z, -3, 2e-3);
    EXPECT_NEAR(r.image.depth[9], 1, 2e-3);
    /* The plane turned about y: its normal (0, 0, 1) goes to (sin 45, 0, cos 45) */
    EXPECT_NEAR(std::abs(glm::dot(ng, glm::vec3(std::sqrt(.5f), 0, std::sqrt(.5f)))), 1, 1e-5);
    const glm::vec3 shading =
        glm::normalize(glm::vec3(1 * std::sqrt(.5f) - 2 * std::sqrt(.5f), 0, -1 * std::sqrt(.5f) - 2 * std::sqrt(.5f)));
    EXPECT_NEAR(std::abs(glm::dot(n, shading)), 1, 1e-5);
}

/// Of few samples the weights of such a filter may sum to less than 0: colours are divided by the sum, and so are normals.
TEST(Aovs, NormalsKeepTheirSideUnderAFilterWithNegativeValues) {
    View v = view(40, 32);
    v.samples = 4;
    v.more = "PixelFilter \"sinc\"\n";
    const Rendered r = renderAovs(v, wall);
    const float side = r.image.normal[0].z;
    EXPECT_NEAR(std::abs(side), 1, 1e-5);
    for (size_t i = 0; i < r.image.pixelCount(); ++i) {
        if (r.image.normal[i] == glm::vec3(0)) continue;   // the weights sum to 0
        ASSERT_NEAR(r.image.normal[i].z, side, 1e-5) << i;
        ASSERT_NEAR(r.image.geometricNormal[i].z, side, 1e-5) << i;
    }
}

/// On a plane 4 away, of which a pixel of the 16 x 16 sees half a unit by half a unit: a square that goes 1 to the right and half a unit up
/// in the motion's time goes 2 pixels and -1. A shutter that is open for half of it sees half; a camera that goes along with it, or an
/// instance that goes the other way, none; and what stands still moves against the camera.
TEST(Aovs, MotionIsHowFarPointsMoveInTheImage) {
    const std::string along = " ActiveTransform EndTime Translate 1 .5 0 ActiveTransform All ",
                      back = " ActiveTransform EndTime Translate -1 -.5 0 ActiveTransform All ";
    const std::string square = "Shape \"bilinearmesh\" \"point3 P\" [-9 -9 0  9 -9 0  -9 9 0  9 9 0]\n",
                      material = "LightSource \"point\" \"point3 from\" [0 0 -3] Material \"diffuse\"\n";
    const auto motionOf = [&](const std::string& camera, const std::string& shutter, const std::string& world) {
        View v = view(90, 16);
        v.lookAt = "0 0 -4  0 0 0  0 1 0 " + camera;
        v.more = "Camera \"perspective\" \"float fov\" 90 " + shutter;
        PackedScene scene = packScene(sceneText(v, material + world));
        scene.require(Feature::AOVS, "the test");
        if (scene.features.has(Feature::MOTION)) scene.require(Feature::MOTION_VECTORS, "the test");
        return render(std::move(scene)).image.motion[5 * 16 + 9];
    };
    const auto expectMotion = [](glm::vec2 found, double x, double y) { EXPECT_NEAR(found.x, x, 1e-3); EXPECT_NEAR(found.y, y, 1e-3); };
    expectMotion(motionOf("", "", along + square), 2, -1);
    expectMotion(motionOf("", "\"float shutteropen\" .25 \"float shutterclose\" .75", along + square), 1, -.5);
    /* Camera transforms are those from the world */
    expectMotion(motionOf(back, "", along + square), 0, 0);
    expectMotion(motionOf(back, "", square), -2, 1);
    expectMotion(motionOf("", "", "ObjectBegin \"a\"" + along + square + "ObjectEnd" + back + "ObjectInstance \"a\""), 0, 0);
    expectMotion(motionOf("", "", ""), 0, 0);
}

/// Corners of a square that have (u, v) of their own, and of a triangle that has pbrt-v4's (0, 0), (1, 0), (1, 1): what is seen of them at
/// (x, y) is what lies between.
TEST(Aovs, TextureCoordinatesAreThoseOfTheShape) {
    View v = view(90, 8);
    v.lookAt = "0 0 -1  0 0 0  0 1 0";
    const auto check = [&](const std::string& shape, auto expected) {
        const Rendered r = renderAovs(v, "LightSource \"point\" \"point3 from\" [0 0 -1]\n" + shape);
        for (size_t i : {0u, 19u, 44u, 63u}) {
            const glm::vec3 p = r.image.position[i];
            const glm::vec2 e = expected(p.x, p.y);
            EXPECT_NEAR(r.image.uv[i].x, e.x, 1e-5);
            EXPECT_NEAR(r.image.uv[i].y, e.y, 1e-5);
        }
    };
    check("Shape \"bilinearmesh\" \"point3 P\" [-2 -2 0  2 -2 0  -2 2 0  2 2 0] \"point2 uv\" [3 -1  7 -1  3 1  7 1]",
          [](float x, float y) { return glm::vec2(5 + x, y / 2); });
    check("Shape \"trianglemesh\" \"point3 P\" [-4 -4 0  12 -4 0  -4 12 0]", [](float x, float y) {
        const float b = (x + 4) / 16, c = (y + 4) / 16;   /* the weights of the second and the third corner */
        return glm::vec2(b + c, c);
    });
    const Rendered nothing = renderAovs(v, "LightSource \"infinite\"");
    EXPECT_EQ(nothing.image.uv[19], glm::vec2(0));
    EXPECT_EQ(nothing.image.depthSlope[19], glm::vec2(0));
}

/// On the plane z = a + b x + c y, by the columns s = x / z and the rows t = y / z of a camera at the origin: z = a / (1 - b s - c t), so
/// that dz/ds = b z^2 / a and dz/dt = c z^2 / a; a pixel is 2 / 16 of s and t. Through an orthographic camera, that is b and c for each
/// unit. No sign is kept.
TEST(Aovs, DepthSlopesAreThoseOfThePlane) {
    constexpr double a = 4, b = .5, c = -.25;
    /* Corners at x, y = +-9; the world is turned, moved and scaled against the camera, which sees itself in camera units */
    std::string square = "LightSource \"infinite\" Shape \"bilinearmesh\" \"point3 P\" [";
    for (double y : {-9., 9.}) for (double x : {-9., 9.}) square += fmt::format("{} {} {} ", x, y, a + b * x + c * y);
    square += "]";
    View v = view(90, 16);
    const auto seenBy = [&](const std::string& camera, const std::string& world) {
        v.lookAt = "0 0 0  0 0 1  0 1 0";
        v.more = camera;
        return renderAovs(v, world);
    };
    const Rendered perspective = seenBy("", square);
    const std::string turn = "Translate 30 1 2 Rotate 50 1 2 3 ", back = "Rotate -50 1 2 3 Translate -30 -1 -2 ";
    const Rendered moved = seenBy(back + " Camera \"perspective\" \"float fov\" 90 ", turn + square);
    for (size_t i : {3u, 70u, 200u, 255u}) {
        const double z = perspective.image.position[i].z;
        EXPECT_NEAR(perspective.image.depthSlope[i].x, b * z * z / a / 8, 1e-4 * z * z) << i;
        EXPECT_NEAR(perspective.image.depthSlope[i].y, -c * z * z / a / 8, 1e-4 * z * z) << i;
        EXPECT_NEAR(moved.image.depthSlope[i].x, perspective.image.depthSlope[i].x, 1e-3 * z * z) << i;
        EXPECT_NEAR(moved.image.depthSlope[i].y, perspective.image.depthSlope[i].y, 1e-3 * z * z) << i;
    }
    const Rendered orthographic = seenBy("Camera \"orthographic\" \"float screenwindow\" [-2 2 -2 2] ", square);
    for (size_t i : {3u, 70u, 255u}) {
        EXPECT_NEAR(orthographic.image.depthSlope[i].x, b / 4, 1e-4);
        EXPECT_NEAR(orthographic.image.depthSlope[i].y, -c / 4, 1e-4);
    }
}

/// A spherical camera in the middle of a ball sees it touched by planes across its rays: a turn by an angle of a pixel moves the point by
/// radius times that (and the sine of the angle to the pole), along z by the sine of the angle to z: at a quarter of a turn from z, all of
/// it; towards z, nothing.
TEST(Aovs, DepthSlopesInAPanorama) {
    View v = view();
    v.width = 256;
    v.height = 128;
    v.samples = 16;
    v.lookAt = "0 0 0  0 0 1  0 1 0";
    v.more = "Camera \"spherical\" \"string mapping\" \"equirectangular\" ";
    const Rendered r = renderAovs(v, "LightSource \"point\" Shape \"sphere\" \"float radius\" 3");
    size_t sideways = 0;
    for (int y = 62; y < 66; ++y)
        for (int x = 0; x < 256; ++x) {
            const size_t i = static_cast<size_t>(y) * 256 + static_cast<size_t>(x);
            const glm::vec3 p = r.image.position[i];
            EXPECT_NEAR(r.image.depthSlope[i].x, 2 * M_PI / 256 * std::abs(p.x), 1e-3);
            sideways += std::abs(p.x) > 2.9f;
        }
    EXPECT_GT(sideways, 0u);
}

/// Objects are numbered as the scene lists them, instances after shapes; materials likewise; a pixel's number is that of most samples.
TEST(Aovs, ObjectsAndMaterialsHaveNumbers) {
    View v = view(60, 3);
    const std::string world =
        R"(LightSource "point" MakeNamedMaterial "a" "string type" "diffuse"
            MakeNamedMaterial "b" "string type" "diffuse" "rgb reflectance" [.2 .2 .2]
ObjectBegin "ball" NamedMaterial "b" Shape "sphere" "float radius" .4 Translate 0 0 .1 Shape "sphere" "float radius" .4 ObjectEnd
NamedMaterial "a" Shape "bilinearmesh" "point3 P" [-.2 -.2 0  .2 -.2 0  -.2 .2 0  .2 .2 0]
AttributeBegin Translate -1.54 0 0 Scale 2 2 2 ObjectInstance "ball" AttributeEnd
AttributeBegin Translate 1.54 0 0 Scale 2 2 2 ObjectInstance "ball" AttributeEnd
AttributeBegin ActiveTransform EndTime Translate 0 .1 0 ActiveTransform All Translate 0 1.54 0 NamedMaterial "b"
    Shape "sphere" "float radius" .8 AttributeEnd)";
    const Rendered r = renderAovs(v, world);
    const std::vector<float> &object = r.image.object, &material = r.image.material;
    EXPECT_EQ(object[3], 3);
    EXPECT_EQ(object[5], 4);
    EXPECT_EQ(object[1], 2);
    EXPECT_EQ(object[4], 0) << "most samples of the middle pass the small square";
    EXPECT_EQ(object[7], 0);
    EXPECT_EQ(material[3], material[5]);
    EXPECT_EQ(material[1], material[5]);
    EXPECT_NE(material[3], 0);
    EXPECT_EQ(material[7], 0);
}

}  // namespace
}  // namespace eikonal
