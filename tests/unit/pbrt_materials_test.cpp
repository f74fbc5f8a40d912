// Materials. The defaults are those of pbrt-v4's source (materials.cpp).

#include "kinds/material_kind.h"
#include "read/pbrt/materials.h"
#include "kinds/texture_kind.h"
#include "unit/pbrt_reading.h"

#include <cmath>

namespace eikonal {
namespace {

class PbrtMaterials : public PbrtTest {
protected:
    Material material(const std::string& text) { return world("Material " + text).materials.at(0); }
    static double value(const Material& material, const std::string& input) { return material.inputs.at(input).value.value(); }
    static std::vector<std::string> inputsOf(const Material& material) {
        std::vector<std::string> names;
        for (const auto& [name, input] : material.inputs) names.push_back(name);
        return names;
    }
};

TEST_F(PbrtMaterials, defaults) {
    EXPECT_EQ(value(material("\"diffuse\""), "reflectance"), .5);
    EXPECT_TRUE(material("\"dielectric\"").remapRoughness);
    EXPECT_EQ(value(material("\"dielectric\""), "eta"), 1.5);
    EXPECT_EQ(value(material("\"thindielectric\""), "eta"), 1.5);
    EXPECT_EQ(value(material("\"diffusetransmission\""), "transmittance"), .25);
    EXPECT_THAT(warnings_, IsEmpty());
    material("\"diffusetransmission\" \"rgb reflectance\" [.6 .1 .7] \"rgb transmittance\" [.4 .9 .3]");
    material("\"diffusetransmission\" \"spectrum reflectance\" [400 .7 700 .2] \"spectrum transmittance\" [400 .3 700 .8]");
    EXPECT_THAT(warnings_, IsEmpty());
    material("\"diffusetransmission\" \"rgb reflectance\" [.6 .1 .7] \"rgb transmittance\" [.3 .95 .3]");
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("add up to more than 1: as in pbrt-v4, the material sends out more light")));
    material("\"diffusetransmission\" \"float scale\" 2.1");
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("add up to more than 1")));
    const Material coated = material("\"coateddiffuse\"");
    const std::map<std::string, double> expected = {{"reflectance", .5}, {"uroughness", 0}, {"vroughness", 0},
                                                    {"thickness", .01},  {"eta", 1.5},      {"g", 0},
                                                    {"albedo", 0},       {"maxdepth", 10},  {"nsamples", 1}};
    EXPECT_EQ(coated.inputs.size(), expected.size());
    for (const auto& [name, number] : expected) EXPECT_EQ(value(coated, name), number) << name;
}

TEST_F(PbrtMaterials, aConductorIsOfCopperOrOfAColor) {
    const Material copper = material("\"conductor\"");
    EXPECT_EQ(copper.inputs.at("eta").value.curve().values, namedSpectrum("metal-Cu-eta")->values);
    EXPECT_EQ(copper.inputs.at("k").value.curve().values, namedSpectrum("metal-Cu-k")->values);
    EXPECT_FALSE(copper.inputs.contains("reflectance"));
    EXPECT_THAT(inputsOf(material("\"conductor\" \"rgb reflectance\" [.9 .6 .4]")), ElementsAre("reflectance", "uroughness", "vroughness"));
    EXPECT_THAT(errorOfWorld("Material \"conductor\" \"rgb reflectance\" [1 1 1] \"spectrum k\" \"metal-Au-k\""),
                HasSubstr("either \"reflectance\" or \"k\""));
}

TEST_F(PbrtMaterials, aCoatedConductorHasTwoOfEachRoughness) {
    const Material copper = material("\"coatedconductor\" \"float conductor.roughness\" .2 \"float interface.uroughness\" .1");
    EXPECT_EQ(copper.kind, &coated_conductor_material);
    const std::map<std::string, double> expected = {
        {"uroughness", .1}, {"vroughness", 0}, {"metal_uroughness", .2}, {"metal_vroughness", .2}, {"thickness", .01}, {"eta", 1.5},
        {"g", 0},           {"albedo", 0},     {"maxdepth", 10},         {"nsamples", 1}};
    for (const auto& [name, number] : expected) EXPECT_EQ(value(copper, name), number) << name;
    EXPECT_EQ(copper.inputs.at("metal_k").value.curve().values, namedSpectrum("metal-Cu-k")->values);
    EXPECT_FALSE(material("\"coatedconductor\" \"rgb reflectance\" [.9 .6 .4]").inputs.contains("metal_eta"));
    EXPECT_THAT(errorOfWorld("Material \"coatedconductor\" \"rgb reflectance\" [1 1 1] \"spectrum conductor.k\" \"metal-Au-k\""),
                HasSubstr("either \"reflectance\" or \"conductor.k\""));
}

// What hair absorbs: given, or of a colour (Chiang et al. 2016, equation 9), or of melanin; brown if nothing is said.
TEST_F(PbrtMaterials, hairAbsorbsWhatItIsTold) {
    const auto absorption = [&](const std::string& parameters) {
        return material("\"hair\" " + parameters).inputs.at("sigma_a").value.albedo();
    };
    expectNear(absorption("\"rgb sigma_a\" [3 2 1]"), {3, 2, 1});
    expectNear(absorption(""), 1.3 * glm::dvec3(.419, .697, 1.37));
    expectNear(absorption("\"float eumelanin\" 2 \"float pheomelanin\" .5"),
               2. * glm::dvec3(.419, .697, 1.37) + .5 * glm::dvec3(.187, .4, 1.05));
    const double n = .3, scale = 5.969 - .215 * n + 2.532 * n * n - 10.73 * n * n * n + 5.574 * n * n * n * n + .245 * n * n * n * n * n;
    for (const char* name : {"reflectance", "color"}) {
        const double root = std::log(.5) / scale;
        expectNear(absorption("\"rgb " + std::string(name) + "\" [.5 .5 .5]"), glm::dvec3(root * root));
    }
    expectNear(absorption("\"rgb sigma_a\" [3 2 1] \"rgb color\" [.5 .5 .5] \"float eumelanin\" 1"), {3, 2, 1});
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("\"reflectance\" is ignored"), HasSubstr("\"eumelanin\" is ignored")));
}

/// The absorption of a colour is far from linear in it, so its RGB says nothing of single wavelengths: the device computes it at each.
TEST_F(PbrtMaterials, colouredHairIsAProgramOfTextures) {
    for (const char* color : {"\"rgb reflectance\" [.9 .1 .05]", "\"spectrum color\" [400 .1 700 .9]"}) {
        const Scene scene = world("Material \"hair\" " + std::string(color));
        const Input& absorption = scene.materials.at(0).inputs.at("sigma_a");
        ASSERT_NE(absorption.texture, none) << color;
        EXPECT_STREQ(scene.textures.at(static_cast<size_t>(absorption.texture)).kind->name, "absorption") << color;
    }
}

TEST_F(PbrtMaterials, texturedHairIsAProgramOfTextures) {
    const Scene scene = world("Texture \"t\" \"float\" \"constant\" \"float value\" .5\nMaterial \"hair\" \"texture eumelanin\" \"t\"");
    const Input& absorption = scene.materials.at(0).inputs.at("sigma_a");
    ASSERT_NE(absorption.texture, none);
    EXPECT_STREQ(scene.textures.at(static_cast<size_t>(absorption.texture)).kind->name, "mix");
    EXPECT_NE(scene.materials.at(0).inputs.at("h").texture, none);
}

TEST_F(PbrtMaterials, aMeasuredMaterialNeedsAFile) {
    EXPECT_THAT(errorOfWorld("Material \"measured\""), HasSubstr("needs a \"string filename\""));
    EXPECT_THAT(errorOfWorld("Material \"measured\" \"string filename\" \"no.bsdf\""), HasSubstr("there is no file \"no.bsdf\""));
    write("a.bsdf", "");
    EXPECT_EQ(material("\"measured\" \"string filename\" \"a.bsdf\"").file, path("a.bsdf"));
}

TEST_F(PbrtMaterials, roughnessGivesWhatItsDirectionsDoNot) {
    const Material rough = material("\"conductor\" \"float roughness\" .3 \"float vroughness\" .1 \"bool remaproughness\" false");
    EXPECT_EQ(value(rough, "uroughness"), .3);
    EXPECT_EQ(value(rough, "vroughness"), .1);
    EXPECT_FALSE(rough.remapRoughness);
}

TEST_F(PbrtMaterials, indicesOfRefraction) {
    EXPECT_EQ(value(material("\"dielectric\" \"float eta\" 1.3"), "eta"), 1.3);
    EXPECT_NEAR(value(material("\"dielectric\" \"spectrum eta\" \"glass-BK7\""), "eta"), 1.52, .01);
    EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(PbrtMaterials, namesMayBeUsedBeforeTheyAreMade) {
    const Scene scene = world(R"(NamedMaterial "b" Shape "sphere"
        MakeNamedMaterial "a" "string type" "diffuse"
        MakeNamedMaterial "b" "string type" "dielectric")");
    EXPECT_EQ(scene.materials[scene.shapes[0].material].name, "b");
    EXPECT_EQ(scene.materials.size(), 2u);
    EXPECT_THAT(errorOfWorld("NamedMaterial \"wood\"\nMakeNamedMaterial \"good\" \"string type\" \"diffuse\"\nShape \"sphere\""),
                HasSubstr("test.pbrt:4:1: there is no material \"wood\"; did you mean \"good\"?"));
    EXPECT_THAT(errorOfWorld("MakeNamedMaterial \"a\" \"string type\" \"diffuse\" MakeNamedMaterial \"a\" \"string type\" \"diffuse\""),
                HasSubstr("there is already a material \"a\", at test.pbrt:2:1"));
    EXPECT_THAT(errorOfWorld("MakeNamedMaterial \"a\" \"float eta\" 1"), HasSubstr("MakeNamedMaterial needs a \"string type\""));
}

TEST_F(PbrtMaterials, aShapeWithoutOneHasPbrtsDefault) { EXPECT_EQ(world("Shape \"sphere\"").shapes[0].material, none); }

TEST_F(PbrtMaterials, mixes) {
    const std::string parts = "MakeNamedMaterial \"a\" \"string type\" \"diffuse\" MakeNamedMaterial \"b\" \"string type\" \"conductor\" "
                              "MakeNamedMaterial \"air\" \"string type\" \"interface\"\n";
    const Scene scene = world(parts + "Material \"mix\" \"string materials\" [\"b\" \"a\"] Shape \"sphere\"");
    const Material& mix = scene.materials[scene.shapes[0].material];
    EXPECT_EQ(mix.kind, &mix_material);
    EXPECT_EQ(value(mix, "amount"), .5);
    EXPECT_THAT(warnings_, IsEmpty());
    const Scene whole = world(parts + "Material \"mix\" \"string materials\" [\"b\" \"a\"] \"float amount\" 2 Shape \"sphere\"");
    EXPECT_EQ(value(whole.materials[whole.shapes[0].material], "amount"), 1);
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("\"float amount\"")));
    EXPECT_EQ(scene.materials[mix.mixed[0]].name, "b");
    EXPECT_EQ(scene.materials[mix.mixed[1]].name, "a");
    EXPECT_THAT(errorOfWorld(parts + "Material \"mix\" \"string materials\" [\"a\"]"), HasSubstr("needs the names of two materials"));
    EXPECT_THAT(errorOfWorld(parts + "Material \"mix\" \"string materials\" [\"a\" \"air\"]"), HasSubstr("cannot be part of a mix"));
    EXPECT_THAT(errorOfWorld(parts + "MakeNamedMaterial \"m\" \"string type\" \"mix\" \"string materials\" [\"a\" \"m\"]"),
                HasSubstr("is a mix of itself"));
}

TEST_F(PbrtMaterials, diffuseTransmissionIsScaled) {
    const Scene scene = world(R"(Texture "t" "spectrum" "constant"
        Material "diffusetransmission" "rgb reflectance" [.2 .4 .6] "texture transmittance" "t" "float scale" .5)");
    const Material& m = scene.materials[0];
    expectNear(m.inputs.at("reflectance").value.albedo(), {.1, .2, .3});
    const Texture& scaled = scene.textures[m.inputs.at("transmittance").texture];
    EXPECT_EQ(scene.textures[scaled.operands.at(0).texture].name, "t");
    EXPECT_EQ(scaled.operands.at(1).value.value(), .5);
}

TEST_F(PbrtMaterials, bumpsAndNormals) {
    write("n.png", "an image");
    const std::string bump = "Texture \"bump\" \"float\" \"constant\" Material \"diffuse\" \"texture displacement\" \"bump\" ";
    const Scene bumpy = world(bump);
    EXPECT_EQ(bumpy.textures[bumpy.materials[0].displacement].name, "bump");
    EXPECT_THAT(warnings_, IsEmpty());
    const Scene both = world(bump + "\"string normalmap\" \"n.png\"");
    EXPECT_EQ(both.images[both.materials[0].normalMap].encoding, ColorEncoding::linear);
    EXPECT_EQ(both.materials[0].displacement, none);
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("\"displacement\" is ignored, since there is a \"normalmap\"")));
}

TEST_F(PbrtMaterials, aSpectrumMayReflectTooMuch) {
    material("\"diffuse\" \"spectrum reflectance\" [400 .5 500 1.5 600 .5]");
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("is 1.5 at 500 nm: it would reflect more than it receives; what is above 1 counts as 1")));
}

TEST_F(PbrtMaterials, interfacesInThreeSpellings) {
    EXPECT_EQ(material("\"interface\"").kind, &interface_material);
    EXPECT_THAT(warnings_, IsEmpty());
    EXPECT_EQ(material("\"\"").kind, &interface_material);
    EXPECT_EQ(material("\"none\"").kind, &interface_material);
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("deprecated")));
}

// Whatever stands in for a material that is not rendered has the inputs that its own kind has when it is asked for by name:
// nothing that comes later need know the difference.
TEST_F(PbrtMaterials, standInsAreComplete) {
    std::map<int, std::vector<std::string>> inputs;
    for (const pbrt::Kind& kind : pbrt::materialKinds().kinds()) {
        if (kind.name == "mix" || kind.name == "measured") continue;  // they need other materials, or a file
        const std::vector<std::string> names = inputsOf(material('"' + kind.name + '"'));
        EXPECT_EQ(!warnings_.empty(), kind.standIn || kind.name == "none" || kind.name.empty()) << kind.name;
        const auto [place, isNew] = inputs.try_emplace(kind.value, names);
        EXPECT_EQ(place->second, names) << kind.name;
    }
}

}  // namespace
}  // namespace eikonal
