// Parameters of every type and in every way of writing them, observed in the scenes that they make.

#include "unit/pbrt_reading.h"

namespace eikonal {
namespace {

class PbrtParameters : public PbrtTest {
protected:
    /// The linear sRGB of a diffuse material's reflectance.
    glm::dvec3 reflectance(const std::string& parameter, const std::string& before = "") {
        return world(before + " Material \"diffuse\" " + parameter).materials.at(0).inputs.at("reflectance").value.albedo();
    }
    double roughness(const std::string& parameter) {
        return world("Material \"dielectric\" " + parameter).materials.at(0).inputs.at("uroughness").value.value();
    }
    bool remap(const std::string& value) {
        return world("Material \"dielectric\" \"bool remaproughness\" " + value).materials.at(0).remapRoughness;
    }
};

TEST_F(PbrtParameters, valuesWithAndWithoutBrackets) {
    EXPECT_EQ(roughness("\"float roughness\" .25"), 0.25);
    EXPECT_EQ(roughness("\"float roughness\"[.25]"), 0.25);
    EXPECT_EQ(roughness("\" float\t  roughness \" [ 25e-2 ]"), 0.25);
    EXPECT_EQ(world("Material \"coateddiffuse\" \"integer maxdepth\" 3").materials[0].inputs["maxdepth"].value.value(), 3);
}

TEST_F(PbrtParameters, booleansBareAndQuoted) {
    EXPECT_FALSE(remap("false"));
    EXPECT_FALSE(remap("[ false ]"));
    EXPECT_FALSE(remap("\"false\""));
    EXPECT_FALSE(remap("[ \"false\" ]"));
    EXPECT_TRUE(remap("true"));
    EXPECT_THAT(errorOfWorld("Material \"dielectric\" \"bool remaproughness\" 1"),
                HasSubstr("test.pbrt:2:45: \"1\" found where \"bool remaproughness\" has true or false"));
}

TEST_F(PbrtParameters, colors) {
    expectNear(reflectance("\"rgb reflectance\" [.1 .2 .3]"), {.1, .2, .3});
    // Rec. 2020's red is outside of sRGB, where green and blue would be negative; an albedo stops at 0.
    const glm::dvec3 red = reflectance("\"rgb reflectance\" [.5 0 0]", "ColorSpace \"rec2020\"");
    EXPECT_GT(red.x, 0.7);
    EXPECT_EQ(red.y, 0);
    EXPECT_THAT(errorOfWorld("Material \"diffuse\" \"rgb reflectance\" [1 2]"), HasSubstr("has 2 values; three are expected"));
    EXPECT_THAT(errorOfWorld("Material \"diffuse\" \"rgb reflectance\" [0 0 -1]"), HasSubstr("negative"));
    EXPECT_THAT(errorOfWorld("Material \"diffuse\" \"rgb reflectance\" [2 0 0]"), HasSubstr("above 1"));
}

TEST_F(PbrtParameters, colorSpacesEndWithTheirBlock) {
    const Scene scene = world("AttributeBegin ColorSpace \"aces2065-1\" AttributeEnd Material \"diffuse\" \"rgb reflectance\" [.1 .2 .3]");
    expectNear(scene.materials[0].inputs.at("reflectance").value.albedo(), {.1, .2, .3});
    EXPECT_THAT(errorOf("ColorSpace \"cmyk\" WorldBegin"), HasSubstr("it can be \"srgb\", \"dci-p3\", \"rec2020\" or \"aces2065-1\""));
}

// A spectrum of the same value at all wavelengths is grey in sRGB, whose white has the same value in all channels. The daylight
// that weighs it is not flat, but its weights sum to one.
TEST_F(PbrtParameters, spectraBySamplesByFileAndByName) {
    expectNear(reflectance("\"spectrum reflectance\" [300 .4 900 .4]"), glm::dvec3(.4), 1e-3);
    write("grey.spd", "# nm value\n300 .4\n900 .4\n");
    expectNear(reflectance("\"spectrum reflectance\" \"grey.spd\""), glm::dvec3(.4), 1e-3);
    const Scene scene = world("Material \"conductor\" \"spectrum eta\" \"metal-Ag-eta\" \"spectrum k\" [\"metal-Ag-k\"]");
    EXPECT_GT(scene.materials[0].inputs.at("k").value.value(), 2);

    EXPECT_THAT(errorOfWorld("Material \"conductor\" \"spectrum eta\" \"metal-Ag-etha\""), HasSubstr("did you mean \"metal-Ag-eta\"?"));
    EXPECT_THAT(errorOfWorld("Material \"conductor\" \"spectrum eta\" [400 1 300 1]"), HasSubstr("must ascend"));
    EXPECT_THAT(errorOfWorld("Material \"conductor\" \"spectrum eta\" [400 1 500]"), HasSubstr("pairs of a wavelength in nm and a value"));
    EXPECT_THAT(errorOfWorld("LightSource \"point\" \"spectrum I\" \"neon\""),
                AllOf(HasSubstr("it can be glass-BAF10, "), HasSubstr("stdillum-F9, or a file of wavelengths")));
    write("fallen.spd", "300 .4\n\n500 1 400 1\n");
    EXPECT_THAT(errorOfWorld("Material \"diffuse\" \"spectrum reflectance\" \"fallen.spd\""),
                HasSubstr("fallen.spd:3:7: the wavelengths of a spectrum must ascend: 400 follows 500"));
    write("bad.spd", "300 .4\n900 none\n");
    EXPECT_THAT(errorOfWorld("Material \"diffuse\" \"spectrum reflectance\" \"bad.spd\""),
                HasSubstr("bad.spd:2:5: \"none\" found where a number is expected"));
}

// As pbrt-v4 does, which looks for a file whatever its name.
TEST_F(PbrtParameters, spectrumFilesNeedNoSuffix) {
    write("grey", "300 .4\n900 .4\n");
    expectNear(reflectance("\"spectrum reflectance\" \"grey\""), glm::dvec3(.4), 1e-3);
}

TEST_F(PbrtParameters, spectraThatCannotBeMeantAreNamed) {
    const auto warningOf = [&](const std::string& curve) {
        world("LightSource \"point\" \"spectrum I\" " + curve);
        return warnings_.empty() ? std::string() : warnings_.back();
    };
    EXPECT_EQ(warningOf("[300 0 900 0]"), "");
    EXPECT_THAT(warningOf("[.4 1 .7 1]"), HasSubstr("is black: it is 0 at 360, 361, ... 830 nm"));  // micrometres
    EXPECT_THAT(warningOf("[550 1]"), HasSubstr("is black"));
    EXPECT_THAT(warningOf("[400 1 500 -2 600 -3]"), HasSubstr("is -3 at 600 nm; values below 0 count as 0"));
    EXPECT_EQ(world("LightSource \"point\" \"spectrum I\" [550 1]").lights[0].spectrum.illuminant(), glm::dvec3(0));
}

TEST_F(PbrtParameters, blackbodiesAreReddishBelowSunlight) {
    const Spectrum spectrum = world("LightSource \"point\" \"blackbody I\" 3000").lights[0].spectrum;
    EXPECT_EQ(spectrum.kelvin(), 3000);
    EXPECT_GT(spectrum.illuminant().x, spectrum.illuminant().z);
    EXPECT_THAT(errorOfWorld("LightSource \"point\" \"blackbody I\" 0"), HasSubstr("not above 0 K"));
    EXPECT_THAT(errorOfWorld("LightSource \"point\" \"blackbody I\" [3000 2]"), HasSubstr("pbrt-v3"));
}

TEST_F(PbrtParameters, theLastOfANameCounts) { EXPECT_EQ(roughness("\"float roughness\" .1 \"float roughness\" .2"), 0.2); }

TEST_F(PbrtParameters, attributeGivesWhatADirectiveDoesNot) {
    const Scene scene = world(R"(
        AttributeBegin
          Attribute "material" "float roughness" .1 "rgb reflectance" [.1 .1 .1]
          Attribute "shape" "float radius" 3
          Material "coateddiffuse"
          Material "coateddiffuse" "float roughness" .2
          Shape "sphere"
          Shape "sphere" "float radius" 4
        AttributeEnd
        Material "coateddiffuse")");
    EXPECT_THAT(warnings_, IsEmpty());
    const auto& m = scene.materials;
    ASSERT_EQ(m.size(), 3u);
    std::map<double, int> roughnesses;
    for (const Material& material : m) ++roughnesses[material.inputs.at("uroughness").value.value()];
    EXPECT_EQ(roughnesses, (std::map<double, int>{{0, 1}, {.1, 1}, {.2, 1}}));
    EXPECT_EQ(scene.shapes[0].radius, 3);
    EXPECT_EQ(scene.shapes[1].radius, 4);
    EXPECT_THAT(errorOfWorld("Attribute \"shapes\" \"float radius\" 1"),
                HasSubstr("it can be \"shape\", \"light\", \"material\", \"medium\" or \"texture\""));
}

TEST_F(PbrtParameters, attributesThatNoKindHasAreNamed) {
    EXPECT_THAT(warningsOfWorld("Attribute \"shape\" \"float raduis\" 1"),
                ElementsAre("test.pbrt:2:19: warning: \"float raduis\" is ignored, since no shape has such a parameter; did you mean "
                            "\"radius\"?"));
    EXPECT_EQ(errorOfWorld("Attribute \"shape\" \"string radius\" \"a\""),
              "test.pbrt:2:19: \"string radius\" found where a shape has \"float radius\"");
    // Area lights are lights, too.
    EXPECT_THAT(warningsOfWorld("Attribute \"light\" \"bool twosided\" true"), IsEmpty());
}

TEST_F(PbrtParameters, whatIsGivenAndNotUsedIsNamed) {
    EXPECT_THAT(warningsOfWorld("Material \"conductor\" \"float roughness\" .1 \"float uroughness\" .2 \"float vroughness\" .3"),
                ElementsAre("test.pbrt:2:22: warning: material \"conductor\": \"float roughness\" is ignored: nothing here uses it"));
    EXPECT_THAT(warningsOfWorld("Material \"conductor\" \"float roughness\" .1 \"float roughness\" .2"),
                ElementsAre("test.pbrt:2:22: warning: material \"conductor\": \"float roughness\" is ignored: it is given again, and the "
                            "last counts"));
    EXPECT_THAT(warningsOfWorld("Texture \"t\" \"float\" \"dots\" \"string mapping\" \"planar\" \"float uscale\" 2 \"float vscale\" 1"),
                ElementsAre(HasSubstr("texture \"dots\": \"float uscale\" is ignored: nothing here uses it")));
}

TEST_F(PbrtParameters, includeBetweenParametersAndInsideOfValues) {
    write("points.txt", "0 0 0  1 0 0  0 1 0");
    write("mesh.txt", "\"point3 P\" [ Include \"points.txt\" ] \"integer indices\"");
    const Scene scene = world("Shape \"trianglemesh\" Include \"mesh.txt\" [0 1 2 2 1 0] \"normal N\" [0 0 1 0 0 1 0 0 1]");
    const Mesh& mesh = *scene.shapes.at(0).mesh;
    EXPECT_EQ(mesh.positions.size(), 3u);
    EXPECT_EQ(mesh.indices.size(), 6u);
    EXPECT_EQ(mesh.normals.size(), 3u);
}

TEST_F(PbrtParameters, whatIsNoParameterIsSaidSo) {
    EXPECT_THAT(errorOfWorld("Shape \"sphere\" \"radius\" 1"),
                HasSubstr("test.pbrt:2:16: \"radius\" found where a parameter's type and name are expected"));
    EXPECT_THAT(errorOfWorld("Shape \"sphere\" \"flaot radius\" 1"), HasSubstr("did you mean \"float\"?"));
    EXPECT_THAT(errorOfWorld("Shape \"sphere\" \"float radius\" []"), HasSubstr("\"float radius\" has no value"));
    EXPECT_THAT(errorOfWorld("Shape \"sphere\" \"float radius\""),
                HasSubstr("the end of the file found where \"float radius\" has a number"));
    EXPECT_THAT(errorOfWorld("Shape \"sphere\" \"float radius\" \"1\""), HasSubstr("\"1\" found where \"float radius\" has a number"));
    EXPECT_THAT(errorOfWorld("Shape \"sphere\" \"float radius\" [1 2]"), HasSubstr("has 2 values; one is expected"));
    EXPECT_THAT(errorOfWorld("Shape \"sphere\" \"integer radius\" 1"), HasSubstr("found where shape \"sphere\" has \"float radius\""));
}

}  // namespace
}  // namespace eikonal
