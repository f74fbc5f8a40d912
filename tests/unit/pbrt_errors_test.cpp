// What is said about scenes that are wrong: where, what, and what would have worked. And that nothing else happens, whatever
// the text.

#include "image/image_data.h"
#include "pack/pack.h"
#include "unit/pbrt_reading.h"

#include <fmt/format.h>

#include <functional>
#include <random>

namespace eikonal {
namespace {

using PbrtErrors = PbrtTest;

int lines(const std::string& text) { return static_cast<int>(std::count(text.begin(), text.end(), '\n')) + 1; }

TEST_F(PbrtErrors, unknownKindsNameTheKnownOnes) {
    EXPECT_THAT(errorOfWorld("  Shape \"shpere\""),
                AllOf(HasSubstr("test.pbrt:2:3: there is no shape \"shpere\""), HasSubstr("did you mean \"sphere\"?")));
    EXPECT_THAT(errorOf("PixelFilter \"lanczos\" WorldBegin"),
                HasSubstr("it can be \"box\", \"triangle\", \"gaussian\", \"mitchell\" or \"sinc\""));
    EXPECT_THAT(errorOfWorld("Shpae \"sphere\""), HasSubstr("did you mean \"Shape\"?"));
    EXPECT_THAT(errorOfWorld("\"Shape\" \"sphere\""), HasSubstr("found where a directive is expected"));
    EXPECT_THAT(errorOfWorld("]"), HasSubstr("\"]\" found where a directive is expected"));
}

TEST_F(PbrtErrors, unknownParametersNameTheKnownOnes) {
    EXPECT_THAT(warningsOfWorld("Shape \"disk\" \"float raduis\" 1"),
                ElementsAre(AllOf(HasSubstr("test.pbrt:2:14: warning: \"float raduis\" is ignored"), HasSubstr("did you mean \"radius\"?"),
                                  HasSubstr("it has radius, innerradius, height, phimax, alpha"))));
    EXPECT_THAT(errorOfWorld("Shape \"disk\" \"float raduis\" 1", true), HasSubstr("test.pbrt:2:14: \"float raduis\" is ignored"));
}

TEST_F(PbrtErrors, whatIsNotRenderedIsAnErrorIfAskedFor) {
    const std::string text =
        "AttributeBegin ActiveTransform EndTime Translate 1 0 0\nLightSource \"point\" AttributeEnd\nTexture \"a\" \"float\" "
        "\"ptex\"\nTexture \"b\" \"float\" \"ptex\"";
    EXPECT_EQ(warningsOfWorld(text).size(), 2u);
    EXPECT_THAT(errorOfWorld(text, true),
                AllOf(HasSubstr("test.pbrt:3:1: a moving light is not rendered yet"), HasSubstr("\ntest.pbrt:4:1: texture \"ptex\"")));
}

// What a scene gives an empty name is missing where it is needed, and left out where it is not.
TEST_F(PbrtErrors, emptyNamesOfFilesCountAsNotGiven) {
    EXPECT_THAT(errorOf("Camera \"realistic\" \"string lensfile\" \"\" WorldBegin"),
                HasSubstr("test.pbrt:1:1: camera \"realistic\" needs"));
    for (const char* needed : {"Shape \"plymesh\" \"string filename\" \"\"", "LightSource \"goniometric\" \"string filename\" \"\"",
                               "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"\"",
                               "MakeNamedMedium \"m\" \"string type\" \"nanovdb\" \"string filename\" \"\""})
        EXPECT_THAT(errorOfWorld(needed), HasSubstr("test.pbrt:2:1: ")) << needed;
    for (const auto& [inherited, own] : {std::pair("a.exr", ""), {"", ""}})
        EXPECT_EQ(read(fmt::format("WorldBegin Attribute \"light\" \"string filename\" \"{}\"\nLightSource \"infinite\" "
                                   "\"string filename\" \"{}\"", inherited, own)).lights.size(), 1u);
    EXPECT_THAT(warningsOfWorld("Attribute \"light\" \"string filename\" \"\" LightSource \"infinite\""),
                ElementsAre(HasSubstr("is empty")));
    EXPECT_THAT(warningsOfWorld("Material \"diffuse\" \"string normalmap\" \"\" Shape \"sphere\""),
                ElementsAre(HasSubstr("test.pbrt:2:20: warning: material \"diffuse\": \"string normalmap\" is empty, and counts as")));
}

// Chains of textures and of mixed materials are followed by code that recurses, whichever end is defined first.
TEST_F(PbrtErrors, longChainsAreRefused) {
    const auto chain = [&](int links, bool fromItsEnd, const std::function<std::string(int)>& link) {
        std::string text;
        for (int i = 1; i <= links; ++i) text += link(fromItsEnd ? i : links + 1 - i) + "\n";
        return text;
    };
    const auto texture = [](int i) { return fmt::format("Texture \"t{}\" \"float\" \"scale\" \"texture tex\" \"t{}\"", i, i - 1); };
    const auto mix = [](int i) {
        return fmt::format("MakeNamedMaterial \"m{}\" \"string type\" \"mix\" \"string materials\" [\"m{}\" \"m0\"]", i, i - 1);
    };
    const std::string first = "Texture \"t0\" \"float\" \"constant\" MakeNamedMaterial \"m0\" \"string type\" \"diffuse\"\n";
    for (const bool fromItsEnd : {true, false}) {
        EXPECT_EQ(read("WorldBegin " + first + chain(900, fromItsEnd, texture)).textures.size(), 901u);
        EXPECT_EQ(read("WorldBegin " + first + chain(900, fromItsEnd, mix)).materials.size(), 901u);
        const std::string ball = " Shape \"sphere\" ",
                          used = "Material \"conductor\" \"texture roughness\" \"t990\"" + ball + "NamedMaterial \"m990\"" + ball;
        Diagnostics silent(LogLevel::silent);
        packScene(read("WorldBegin LightSource \"point\" " + first + chain(990, fromItsEnd, texture) + chain(990, fromItsEnd, mix) + used),
                  silent);
        EXPECT_THAT(errorOfWorld(first + chain(50'000, fromItsEnd, texture)), HasSubstr(":1: textures are nested in each other 1000"));
        EXPECT_THAT(errorOfWorld(first + chain(50'000, fromItsEnd, mix)), HasSubstr(":1: materials are nested in each other 1000 times"));
    }
}

TEST_F(PbrtErrors, allThatIsWrongIsListed) {
    const std::string error = errorOfWorld("Shape \"a\"\nMaterial \"b\"\nRotate 1 0 0 0\nLightSource \"point\" \"float from\" 1");
    for (const char* place : {"test.pbrt:2:1: ", "test.pbrt:3:1: ", "test.pbrt:4:1: ", "test.pbrt:5:21: "})
        EXPECT_THAT(error, HasSubstr(place));
    EXPECT_EQ(lines(error), 4);

    std::string many;
    for (int i = 0; i < 30; ++i) many += "Shape \"a\"\n";
    EXPECT_THAT(errorOfWorld(many), HasSubstr("and 10 more"));
}

TEST_F(PbrtErrors, allMissingFilesAreListedOnce) {
    const std::string error = errorOfWorld(R"(Include "a.pbrt"
        Import "b.pbrt"
        Shape "plymesh" "string filename" "c.ply"
        Shape "plymesh" "string filename" "c.ply"
        Texture "t" "float" "imagemap" "string filename" "d.png"
        Material "diffuse" "spectrum reflectance" "e.spd" "string normalmap" "f.png"
        LightSource "infinite" "string filename" "g.exr")");
    for (const char* name : {"a.pbrt", "b.pbrt", "c.ply", "d.png", "e.spd", "f.png", "g.exr"})
        EXPECT_THAT(error, HasSubstr("there is no file \"" + std::string(name) + "\""));
    EXPECT_EQ(lines(error), 7);
}

TEST_F(PbrtErrors, missingFilesMayBeMagentaOrLeftOut) {
    missing_ = MissingFiles::magenta;
    const Scene scene = world(R"(Shape "plymesh" "string filename" "c.ply"
        Texture "t" "spectrum" "imagemap" "string filename" "d.png"
        Material "diffuse" "texture reflectance" "t" "string normalmap" "f.png" Shape "sphere"
        LightSource "infinite" "string filename" "g.exr")");
    EXPECT_EQ(scene.shapes.size(), 1u);
    ASSERT_EQ(scene.images.size(), 1u);
    EXPECT_THAT(scene.images[0].pixels->floats, ElementsAre(1, 0, 1));
    EXPECT_THAT(warnings_,
                testing::UnorderedElementsAre(HasSubstr("no file \"c.ply\"; the shape is left out"),
                                              HasSubstr("no file \"d.png\"; the texture is magenta"),
                                              HasSubstr("no file \"f.png\"; the surface has no normal map"),
                                              HasSubstr("no file \"g.exr\"; the light is left out")));
    /* What a scene cannot do without */
    EXPECT_THAT(errorOfWorld("Include \"a.pbrt\""), HasSubstr("there is no file \"a.pbrt\""));
}

TEST_F(PbrtErrors, filesOfOtherMachinesAreFoundBesideTheScene) {
    std::filesystem::create_directory(folder_ / "Textures");
    write("Textures/Wood.PNG", "an image");
    write("brick.png", "an image");
    const auto found = [&](const std::string& name) {
        const Scene scene = world("Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"" + name + "\"");
        return std::filesystem::path(scene.images.at(0).path).filename().string();
    };
    EXPECT_EQ(found("brick.png"), "brick.png");
    EXPECT_THAT(warnings_, IsEmpty());
    for (const char* name : {"wood.png", "C:/Users/me/tex/wood.png", "textures\\\\wood.png", "/home/me/WOOD.png", "Textures/wood.png"}) {
        EXPECT_EQ(found(name), "Wood.PNG") << name;
        EXPECT_THAT(warnings_, ElementsAre(HasSubstr("Wood.PNG\" is read instead"))) << name;
        EXPECT_THAT(errorOf("WorldBegin\nTexture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"" + std::string(name) + "\"", true),
                    HasSubstr("Wood.PNG\" is read instead (an error because of --strict)"));
    }
    EXPECT_EQ(found("D:/x/Brick.png"), "brick.png");
    EXPECT_THAT(errorOfWorld("Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"oak.png\""),
                HasSubstr("there is no file \"oak.png\""));
}

// What a missing file would have held is not known, so nothing is wrong with the list that includes it, nor with its directive.
TEST_F(PbrtErrors, aFileThatIsMissingWithinAListIsAllThatIsWrongWithIt) {
    const std::string error = errorOfWorld(R"(Shape "sphere" "float radius" [ Include "a.inc" ]
        Shape "trianglemesh" "integer indices" [0 1 2] "point3 P" [0 0 0 Include "b.inc"]
        MakeNamedMaterial "m" "string type" "diffuse" "rgb reflectance" [ .5 Include "c.inc" ]
        NamedMaterial "m"
        Shape "plymesh" "string filename" "d.ply"
        Texture "t" "spectrum" "imagemap" "string filename" "e.png")");
    for (const char* place : {"2:41: there is no file \"a.inc\"", "3:82: there is no file \"b.inc\"", "4:86: there is no file \"c.inc\""})
        EXPECT_THAT(error, HasSubstr(std::string("test.pbrt:") + place));
    for (const char* name : {"d.ply", "e.png"}) EXPECT_THAT(error, HasSubstr(name));
    EXPECT_EQ(lines(error), 5) << error;
}

TEST_F(PbrtErrors, aFolderIsNoFile) {
    EXPECT_EQ(errorOfWorld("Shape \"plymesh\" \"string filename\" \"/tmp\""), "test.pbrt:2:17: \"/tmp\" is a folder; a file is expected");
}

TEST_F(PbrtErrors, aSceneThatIsNotThere) {
    Diagnostics diagnostics(LogLevel::silent);
    try {
        readPbrt(path("nothing.pbrt"), diagnostics);
        FAIL() << "read a file that is not there";
    } catch (const SceneError& error) { EXPECT_THAT(error.what(), AllOf(HasSubstr("nothing.pbrt"), HasSubstr("cannot be opened"))); }
}

TEST_F(PbrtErrors, filesAreFoundFromTheSceneAndFromWhoNamesThem) {
    std::filesystem::create_directory(folder_ / "parts");
    write("parts/inner.pbrt", "Include \"rest.pbrt\" Include \"outer.pbrt\"");
    write("parts/rest.pbrt", "Translate 1 0 0");
    write("outer.pbrt", "Translate 0 1 0");
    expectNear(apply(world("Include \"parts/inner.pbrt\" Shape \"sphere\"").shapes[0].worldFromObject, {0, 0, 0}), {1, 1, 0});
}

TEST_F(PbrtErrors, version3IsRecognised) {
    const std::string advice = "Eikonal reads pbrt-v4. Convert the scene with pbrt-v4's own program: pbrt --upgrade";
    EXPECT_THAT(errorOfWorld("Material \"matte\" \"rgb Kd\" [1 1 1]"),
                AllOf(HasSubstr("test.pbrt:2:1: material \"matte\" belongs to pbrt-v3"), HasSubstr("\"diffuse\""), HasSubstr(advice)));
    EXPECT_THAT(errorOfWorld("WorldEnd"), HasSubstr(advice));
    EXPECT_THAT(errorOf("Film \"image\" WorldBegin"), HasSubstr("pbrt-v4 has \"rgb\""));
    EXPECT_THAT(errorOf("SurfaceIntegrator \"path\""), HasSubstr(advice));
    EXPECT_THAT(errorOfWorld("LightSource \"infinite\" \"string mapname\" \"a.exr\""), HasSubstr("\"string filename\""));
    EXPECT_THAT(errorOfWorld("Material \"diffuse\" \"color reflectance\" [1 1 1]"), HasSubstr("pbrt-v4 has \"rgb\""));
    // One such word is enough: what else is wrong would only mislead.
    EXPECT_EQ(lines(errorOfWorld("Shape \"plymesh\" \"string filename\" \"none.ply\"\nMaterial \"matte\"")), 1);
}

// A scene that has a bit of everything.
const std::string scene = R"(LookAt 3 4 1.5  .5 .5 0  0 0 1  # a comment
Camera "perspective" "float fov" 45 "float screenwindow" [ -1 1 -1 1 ]
Sampler "halton" "integer pixelsamples" 128
Film "rgb" "string filename" "simple.png" "integer xresolution" [400] "integer yresolution" [400]
WorldBegin
LightSource "infinite" "rgb L" [ .4 .45 .5 ]
LightSource "distant" "point3 from" [ -30 40 100 ] "blackbody L" 3000 "float scale" 1.5
AttributeBegin
  Texture "t" "spectrum" "checkerboard" "float uscale" 16 "rgb tex1" .1 "texture tex2" "u"
  Material "dielectric" "bool remaproughness" "true" "spectrum eta" [ 300 1.5 800 1.4 ]
  ReverseOrientation
  MakeNamedMedium "m" "string type" "uniformgrid" "integer nx" 2 "float density" [ 0 1 ]
  MediumInterface "m" ""
  Shape "sphere" "float radius" 1 "texture alpha" "a"
AttributeEnd
ObjectBegin "o"
  Shape "bilinearmesh" "point3 P" [ -20 -20 0  20 -20 0  -20 20 0  20 20 0 ] "point2 uv" [ 0 0 1 0 1 1 0 1 ]
ObjectEnd
ConcatTransform [ 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 ]
ObjectInstance "o"
Include "scene.pbrt" Import "other.pbrt")";

TEST_F(PbrtErrors, noTextEndsInAnythingButASceneOrASceneError) {
    write("other.pbrt", "AttributeBegin Import \"scene.pbrt\"");
    write("scene.pbrt", scene);
    for (size_t length = 0; length <= scene.size(); ++length) errorOf(scene.substr(0, length));

    std::mt19937 random(1);
    const auto below = [&](size_t n) { return random() % n; };
    for (int i = 0; i < 1000; ++i) {
        std::string text = scene;
        for (int edits = 1 + below(3); edits > 0; --edits) {
            const size_t at = below(text.size()), length = below(std::min<size_t>(text.size() - at, 20));
            switch (below(4)) {
                case 0: text[at] = static_cast<char>(random()); break;
                case 1: text.erase(at, length); break;
                case 2: text.insert(below(text.size()), text.substr(at, length)); break;
                default: text[at] = "[]\"\\#-.9\n "[below(10)];
            }
        }
        EXPECT_FALSE(errorOf(text, below(2)).empty()) << text;
    }
}

}  // namespace
}  // namespace eikonal
