// Directives: transforms, blocks, other files, and the order that they come in.

#include "kinds/material_kind.h"
#include "unit/pbrt_reading.h"

#include <fmt/format.h>

#include <zlib.h>

namespace eikonal {
namespace {

class PbrtDirectives : public PbrtTest {
protected:
    /// Where the origin and the point (1, 0, 0) of a sphere end up.
    glm::dvec3 origin(const std::string& text) { return apply(world(text + " Shape \"sphere\"").shapes.at(0).worldFromObject, {0, 0, 0}); }
    glm::dvec3 unitX(const std::string& text) { return apply(world(text + " Shape \"sphere\"").shapes.at(0).worldFromObject, {1, 0, 0}); }
};

TEST_F(PbrtDirectives, theLastTransformIsAppliedFirst) {
    expectNear(unitX("Translate 0 0 5 Rotate 90 0 0 1 Scale 2 1 1"), {0, 2, 5});
    expectNear(unitX("Scale 2 1 1 Translate 0 0 5 Identity Translate 1 1 1"), {2, 1, 1});
    expectNear(unitX("Translate 9 9 9 Transform [0 1 0 0  1 0 0 0  0 0 1 0  5 6 7 1]"), {5, 7, 7});
    expectNear(unitX("Translate 1 0 0 ConcatTransform [0 1 0 0  1 0 0 0  0 0 1 0  5 6 7 1]"), {6, 7, 7});
    /* Homogeneous coordinates: twice the matrix is the same matrix; a projection is none that a scene can have */
    expectNear(unitX("Transform [0 2 0 0  2 0 0 0  0 0 2 0  10 12 14 2]"), {5, 7, 7});
    EXPECT_THROW(unitX("Transform [1 0 0 0  0 1 0 .5  0 0 1 0  0 0 0 1]"), SceneError);
    EXPECT_THROW(unitX("Transform [1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 0]"), SceneError);
}

// LookAt makes a camera's transform: it takes where the camera looks at to the +z axis, at its distance.
TEST_F(PbrtDirectives, lookAtIsTheViewOfACamera) {
    expectNear(apply(glm::inverse(read("LookAt 1 2 3  1 2 8  0 1 0 Camera \"perspective\" WorldBegin").camera.worldFromCamera), {1, 2, 8}),
               {0, 0, 5});
    // Looking along +z with y up, x is to the right: pbrt's spaces are left-handed.
    expectNear(origin("LookAt 1 2 3  1 2 8  0 1 0"), {-1, -2, -3});
    EXPECT_THAT(errorOfWorld("LookAt 0 0 0  0 1 0  0 1 0"), HasSubstr("parallel to its up vector"));
    EXPECT_THAT(errorOfWorld("Rotate 10 0 0 0"), HasSubstr("test.pbrt:2:1: Rotate has an axis of length 0"));
}

TEST_F(PbrtDirectives, aMirroredCameraStaysMirrored) {
    const Transform world = read("Scale -1 1 1 LookAt 0 0 -5  0 0 0  0 1 0 Camera \"perspective\" WorldBegin").camera.worldFromCamera;
    expectNear(apply(world, {1, 0, 0}), {-1, 0, -5});
    EXPECT_LT(glm::determinant(world), 0);
    EXPECT_THAT(errorOf("Scale 1 0 1 Camera \"perspective\" WorldBegin"), HasSubstr("cannot be inverted"));
}

TEST_F(PbrtDirectives, coordinateSystemsAreRemembered) {
    expectNear(origin("Translate 1 2 3 CoordinateSystem \"here\" Translate 5 5 5 CoordSysTransform \"here\""), {1, 2, 3});
    const Scene scene = read(
        "Translate 0 0 7 Camera \"perspective\" WorldBegin CoordSysTransform \"camera\" Shape \"sphere\" "
        "CoordSysTransform \"world\" Shape \"sphere\"");
    expectNear(apply(scene.shapes[0].worldFromObject, {0, 0, 0}), {0, 0, -7});
    expectNear(apply(scene.shapes[1].worldFromObject, {0, 0, 0}), {0, 0, 0});
    EXPECT_THAT(warningsOfWorld("CoordinateSystem \"lamp\" CoordSysTransform \"lamb\""), ElementsAre(HasSubstr("did you mean \"lamp\"?")));
}

TEST_F(PbrtDirectives, activeTransformChoosesTheTime) {
    expectNear(origin("ActiveTransform EndTime Translate 1 0 0 ActiveTransform All Translate 0 1 0"), {0, 1, 0});
    EXPECT_THAT(warnings_, IsEmpty());
    expectNear(origin("ActiveTransform StartTime Translate 1 0 0 ActiveTransform EndTime Translate 1 0 0"), {1, 0, 0});
    EXPECT_THAT(warnings_, IsEmpty());
    EXPECT_THAT(errorOfWorld("ActiveTransform Sometimes"), HasSubstr("\"Sometimes\" found where All, StartTime or EndTime is expected"));
}

TEST_F(PbrtDirectives, blocksRestoreEverything) {
    const Scene scene = world(R"(
        Material "diffuse"
        AttributeBegin
          Translate 1 1 1  ReverseOrientation  Material "conductor"  AreaLightSource "diffuse"
          MakeNamedMedium "fog" "string type" "homogeneous"  MediumInterface "fog" ""
          Shape "sphere"
        AttributeEnd
        Shape "sphere"
        TransformBegin Translate 5 0 0 TransformEnd
        Shape "sphere")");
    const Shape &inner = scene.shapes[0], &outer = scene.shapes[1];
    EXPECT_TRUE(inner.reverseOrientation);
    EXPECT_EQ(scene.materials[inner.material].kind, &conductor_material);
    EXPECT_EQ(inner.areaLight, 0);
    EXPECT_TRUE(inner.interface.has_value());
    EXPECT_FALSE(outer.reverseOrientation);
    EXPECT_EQ(scene.materials[outer.material].kind, &diffuse_material);
    EXPECT_EQ(outer.areaLight, none);
    EXPECT_FALSE(outer.interface.has_value());
    expectNear(apply(scene.shapes[2].worldFromObject, {0, 0, 0}), {0, 0, 0});
}

TEST_F(PbrtDirectives, blocksThatDoNotMatch) {
    EXPECT_THAT(errorOfWorld("AttributeEnd"), HasSubstr("test.pbrt:2:1: AttributeEnd without an AttributeBegin"));
    EXPECT_THAT(errorOfWorld("\nAttributeBegin"), HasSubstr("test.pbrt:3:1: AttributeBegin without an AttributeEnd"));
    EXPECT_THAT(errorOfWorld("ObjectBegin \"a\" AttributeEnd ObjectEnd"), HasSubstr("ObjectBegin at test.pbrt:2:1"));
    EXPECT_THAT(errorOfWorld("ObjectBegin \"a\" AttributeBegin ObjectEnd AttributeEnd ObjectEnd"),
                HasSubstr("AttributeBegin at test.pbrt:2:17"));
    EXPECT_THAT(errorOfWorld("ObjectEnd"), HasSubstr("ObjectEnd"));
}

TEST_F(PbrtDirectives, includeGoesOnInTheSameState) {
    write("inner.pbrt", "Translate 1 0 0");
    expectNear(origin("Include \"inner.pbrt\""), {1, 0, 0});
    write("settings.pbrt", "Film \"rgb\" \"integer xresolution\" 7\nWorldBegin");
    EXPECT_EQ(read("Include \"settings.pbrt\" Shape \"sphere\"").film.width, 7);
}

TEST_F(PbrtDirectives, importHasAStateOfItsOwn) {
    write("inner.pbrt", "Translate 1 0 0 Shape \"sphere\" MakeNamedMaterial \"red\" \"string type\" \"diffuse\"");
    const Scene scene = world("Translate 0 1 0 Import \"inner.pbrt\" NamedMaterial \"red\" Shape \"sphere\"");
    expectNear(apply(scene.shapes[0].worldFromObject, {0, 0, 0}), {1, 1, 0});
    expectNear(apply(scene.shapes[1].worldFromObject, {0, 0, 0}), {0, 1, 0});
    EXPECT_NE(scene.shapes[1].material, none);

    write("names.pbrt", "CoordinateSystem \"inside\"");
    world("Import \"names.pbrt\" CoordSysTransform \"inside\"");
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("there is no coordinate system \"inside\"")));

    write("open.pbrt", "AttributeBegin");
    EXPECT_THAT(errorOfWorld("Import \"open.pbrt\""), HasSubstr("open.pbrt:1:1: AttributeBegin without an AttributeEnd"));
    EXPECT_THAT(errorOf("Import \"inner.pbrt\" WorldBegin"), HasSubstr("Import is only allowed after WorldBegin"));
}

TEST_F(PbrtDirectives, filesThatIncludeThemselvesAreRefused) {
    write("loop.pbrt", "Include \"loop.pbrt\"");
    EXPECT_THAT(errorOfWorld("Include \"loop.pbrt\""), HasSubstr("includes itself"));
    write("a.pbrt", "Import \"b.pbrt\"");
    write("b.pbrt", "Import \"a.pbrt\"");
    EXPECT_THAT(errorOfWorld("Import \"a.pbrt\""), HasSubstr("includes itself"));
}

TEST_F(PbrtDirectives, compressedFilesThatSwellAreRefused) {
    const gzFile file = gzopen(path("bomb.pbrt").c_str(), "wb9");
    const std::string blanks(1 << 20, ' ');
    for (int i = 0; i < 300; ++i) gzwrite(file, blanks.data(), static_cast<unsigned>(blanks.size()));
    gzclose(file);
    EXPECT_THAT(errorOfWorld("Include \"bomb.pbrt\""), HasSubstr("is compressed more than 200 times"));
}

// A chain of imports has a limit, and so has the number of files, which 30 that each include the next twice take to a billion.
TEST_F(PbrtDirectives, filesThatMultiplyAreRefused) {
    for (int i = 0; i < 1002; ++i) write(fmt::format("deep{}.pbrt", i), fmt::format("Import \"deep{}.pbrt\"", i + 1));
    EXPECT_THAT(errorOfWorld("Import \"deep0.pbrt\""), HasSubstr("deep999.pbrt:1:1: 1000 files are nested in each other here"));
    for (int i = 0; i < 30; ++i)
        write(fmt::format("twice{}.pbrt", i), fmt::format("Include \"twice{0}.pbrt\" Include \"twice{0}.pbrt\"", i + 1));
    write("twice30.pbrt", "");
    EXPECT_THAT(errorOfWorld("Include \"twice0.pbrt\""), HasSubstr("the scene has opened 100000 files for 0 shapes"));
}

TEST_F(PbrtDirectives, deprecatedDirectivesAreNotedOnce) {
    Diagnostics diagnostics(LogLevel::info);
    testing::internal::CaptureStderr();
    readPbrtText("WorldBegin\nTransformBegin TransformEnd\nTransformBegin TransformEnd\n", "test.pbrt", ".", diagnostics);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "test.pbrt:2:1: TransformBegin is deprecated; AttributeBegin does the same\n");
}

TEST_F(PbrtDirectives, manyFilesMayPlaceManyInstances) {
    for (int i = 0; i < 16; ++i)
        write(fmt::format("twice{}.pbrt", i), fmt::format("Include \"twice{0}.pbrt\" Include \"twice{0}.pbrt\"", i + 1));
    write("twice16.pbrt", "ObjectInstance \"ball\"");
    EXPECT_EQ(world("ObjectBegin \"ball\" Shape \"sphere\" ObjectEnd Include \"twice0.pbrt\"").instances.size(), 65536u);
}

TEST_F(PbrtDirectives, compressedFilesAreReadAsTheyAre) {
    const gzFile file = gzopen(path("scene.pbrt.gz").c_str(), "wb");
    gzputs(file, "Film \"rgb\" \"integer xresolution\" 9\nWorldBegin\n");
    gzclose(file);
    Diagnostics diagnostics(LogLevel::silent);
    const Scene scene = readPbrt(path("scene.pbrt.gz"), diagnostics);
    EXPECT_EQ(scene.film.width, 9);
    EXPECT_EQ(scene.name, "scene");
}

TEST_F(PbrtDirectives, settingsComeBeforeTheWorld) {
    EXPECT_THAT(errorOfWorld("Camera \"perspective\""), HasSubstr("test.pbrt:2:1: Camera is only allowed before WorldBegin"));
    EXPECT_THAT(errorOfWorld("WorldBegin"), HasSubstr("test.pbrt:2:1: a second WorldBegin"));
    EXPECT_THAT(errorOf("Shape \"sphere\""), HasSubstr("test.pbrt:1:1: Shape is only allowed after WorldBegin"));
    EXPECT_THAT(errorOf("# nothing\n"), HasSubstr("the file ends before WorldBegin"));
    expectNear(apply(read("Translate 1 1 1 WorldBegin Shape \"sphere\"").shapes[0].worldFromObject, {0, 0, 0}), {0, 0, 0});
}

TEST_F(PbrtDirectives, options) {
    EXPECT_EQ(read("Option \"seed\" 17 WorldBegin").sampler.seed, 17);
    EXPECT_EQ(
        read("Option \"rendercoordsys\" \"world\" Option \"disable-texture-filtering\" true TransformTimes 0 1 WorldBegin").sampler.seed,
        0);
    EXPECT_THAT(warnings_, IsEmpty());
    EXPECT_TRUE(read("Option \"forcediffuse\" true WorldBegin").forcesDiffuse);
    EXPECT_FALSE(read("Option \"forcediffuse\" false WorldBegin").forcesDiffuse);
    EXPECT_THAT(warnings_, IsEmpty());
    read("Option \"disablewavelengthjitter\" true WorldBegin");
    EXPECT_THAT(warnings_, ElementsAre("test.pbrt:1:8: warning: option \"disablewavelengthjitter\": \"bool disablewavelengthjitter\" "
                                       "has no effect: spectral rendering always samples wavelengths"));
    EXPECT_THAT(errorOf("Option \"sead\" 1 WorldBegin"), HasSubstr("did you mean \"seed\"?"));
}

// All samples of a pixel are at its centre, the centre of the lens and the middle of the shutter interval; the exposure is that of the
// interval.
TEST_F(PbrtDirectives, withoutPixelJitterASampleIsInTheMiddleOfEverything) {
    const std::string camera =
        "Camera \"perspective\" \"float lensradius\" 1 \"float focaldistance\" 3 \"float shutteropen\" .25 \"float "
        "shutterclose\" .75 ";
    const Scene scene = read("Option \"disablepixeljitter\" true " + camera + "WorldBegin");
    EXPECT_EQ(scene.filter.xRadius, 0);
    EXPECT_EQ(scene.filter.yRadius, 0);
    EXPECT_EQ(scene.camera.lensRadius, 0);
    EXPECT_EQ(scene.camera.shutterOpen, .5);
    EXPECT_EQ(scene.camera.shutterClose, .5);
    EXPECT_EQ(scene.film.exposureTime, .5);
    EXPECT_THAT(warnings_, IsEmpty());
    EXPECT_EQ(read("Option \"disablepixeljitter\" false " + camera + "WorldBegin").camera.lensRadius, 1);
    write("lens.dat", "35 4 1.5 20\n0 2 0 10\n");
    read("Option \"disablepixeljitter\" true Camera \"realistic\" \"string lensfile\" \"lens.dat\" WorldBegin");
    EXPECT_THAT(warnings_,
                ElementsAre("test.pbrt:1:8: warning: option \"disablepixeljitter\": camera \"realistic\" samples its lens all the "
                            "same"));
}

TEST_F(PbrtDirectives, anErrorIsLoggedAgainstAnImageThatIsThere) {
    write("reference.pfm", "");
    const std::string image = "Option \"msereferenceimage\" \"reference.pfm\" ", log = "Option \"msereferenceout\" \"mse.txt\" ";
    const FilmDescription film = read(image + log + "WorldBegin").film;
    EXPECT_EQ(film.errorReference, path("reference.pfm"));
    EXPECT_EQ(film.errorLog, "mse.txt");
    EXPECT_EQ(errorOf(image + "WorldBegin"),
              "test.pbrt:1:8: option \"msereferenceimage\" needs a file for the errors, \"msereferenceout\"");
    EXPECT_EQ(errorOf(log + "WorldBegin"), "test.pbrt:1:8: option \"msereferenceout\" needs an \"msereferenceimage\" to compare with");
    EXPECT_EQ(errorOf("Option \"msereferenceimage\" \"none.exr\" " + log + "WorldBegin"), "test.pbrt:1:8: there is no file \"none.exr\"");
}

}  // namespace
}  // namespace eikonal
