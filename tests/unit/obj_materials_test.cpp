// Materials of MTL files: what docs/obj.md promises.

#include "kinds/material_kind.h"
#include "image/image_data.h"
#include "unit/obj_fixture.h"

#include <gtest/gtest.h>

#include <cmath>

namespace eikonal {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class ObjMaterials : public ObjTest {
protected:
    /// The material of the square's one shape.
    static const Material& materialOf(const Scene& scene) {
        return scene.materials.at(static_cast<std::size_t>(scene.shapes.at(0).material));
    }
    static double number(const Material& material, const std::string& input) { return material.inputs.at(input).value.value(); }
    static glm::dvec3 color(const Material& material, const std::string& input) { return material.inputs.at(input).value.albedo(); }
    static const Texture& textureOf(const Scene& scene, const Input& input) {
        return scene.textures.at(static_cast<std::size_t>(input.texture));
    }

    /// A grey image of 2 x 1 texels, as the simplest file that OpenImageIO reads.
    std::string writeImage(const std::string& name, const std::string& texels = "0 0 0 255 255 255") const {
        return write(name, "P3\n2 1\n255\n" + texels + "\n");
    }
};

TEST_F(ObjMaterials, areDiffuseWithoutAHighlight) {
    for (const char* statements : {"Kd .2 .4 .6\n", "Kd .2 .4 .6\nKs 0 0 0\nNs 100\nillum 2\n", "kd .2 .4 .6\nKs 1 1 1\nillum 1\n"}) {
        const Scene scene = loadMaterial(statements);
        EXPECT_EQ(materialOf(scene).kind, &diffuse_material) << statements;
        EXPECT_EQ(color(materialOf(scene), "reflectance"), glm::dvec3(.2, .4, .6)) << statements;
        EXPECT_EQ(scene.shapes[0].areaLight, none);
    }
    EXPECT_EQ(number(materialOf(loadMaterial("Kd .3\n")), "reflectance"), .3);          // one number is a grey
    EXPECT_EQ(color(materialOf(loadMaterial("illum 2\n")), "reflectance"), glm::dvec3(.5));  // nothing said: grey
    EXPECT_EQ(materialOf(load(square + "f 1 2 3\n")).kind, &diffuse_material);
}

// Ks on a colored base is a coat, as wide as the exponent says: alpha^2 = 2 / (Ns + 2). Ks = 0.5 grey is the plastic of index 1.5.
TEST_F(ObjMaterials, withAHighlightAreCoated) {
    const Scene scene = loadMaterial("Kd .2 .4 .6\nKs .5 .5 .5\nNs 198\nillum 2\n");
    const Material& material = materialOf(scene);
    EXPECT_EQ(material.kind, &coated_diffuse_material);
    EXPECT_NEAR(number(material, "uroughness"), .1, 1e-9);
    EXPECT_NEAR(number(material, "eta"), 1.5, 1e-9);
    EXPECT_FALSE(material.remapRoughness);
}

TEST_F(ObjMaterials, withOnlyAHighlightAreMetal) {
    const Scene glossy = loadMaterial("Kd 0 0 0\nKs .9 .8 .7\nNs 198\n"), mirror = loadMaterial("Kd 0 0 0\nKs .9 .8 .7\nNs 198\nillum 3\n");
    EXPECT_EQ(materialOf(glossy).kind, &conductor_material);
    EXPECT_NEAR(number(materialOf(glossy), "vroughness"), .1, 1e-9);
    EXPECT_EQ(color(materialOf(glossy), "reflectance"), glm::dvec3(.9, .8, .7));
    EXPECT_EQ(materialOf(mirror).kind, &conductor_material);
    EXPECT_EQ(number(materialOf(mirror), "uroughness"), 0);
}

// A mirror (illum 3, 5, 8) over a color shows both, in the ratio of Ks to Kd.
TEST_F(ObjMaterials, thatMirrorAndScatterAreMixed) {
    const Scene scene = loadMaterial("Kd .6 .6 .6\nKs .2 .2 .2\nillum 5\n");
    const Material& material = materialOf(scene);
    ASSERT_EQ(material.kind, &mix_material);
    EXPECT_NEAR(number(material, "amount"), .25, 1e-9);
    EXPECT_EQ(scene.materials.at(static_cast<std::size_t>(material.mixed[0])).kind, &diffuse_material);
    EXPECT_EQ(scene.materials.at(static_cast<std::size_t>(material.mixed[1])).kind, &conductor_material);
}

TEST_F(ObjMaterials, thatRefractAreGlass) {
    for (const char* statements : {"illum 7\nNi 1.33\n", "illum 6\nKd .5 .5 .5\nNi 1.33\n", "illum 4\nKd 0 0 0\nNi 1.33\n",
                                   "Kd 0 0 0\nKs 1 1 1\nNi 1.33\nd 0\n", "Kd 0 0 0\nNi 1.33\nTr 1\n"}) {
        const Scene scene = loadMaterial(statements);
        EXPECT_EQ(materialOf(scene).kind, &dielectric_material) << statements;
        EXPECT_EQ(number(materialOf(scene), "eta"), 1.33) << statements;
        EXPECT_EQ(scene.shapes[0].alpha.value.value(), 1) << statements;
    }
    loadMaterial("illum 7\nNi 1.5\nTf 1 .2 .2\n");
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("model.mtl:4:1: warning: colored transmission")));
}

// What is see-through but has a color of its own is covered only in part: d, or 1 - Tr. Where both stand, d counts: exporters disagree
// about Tr.
TEST_F(ObjMaterials, thatDissolveCoverInPart) {
    EXPECT_NEAR(loadMaterial("Kd 1 0 0\nd .25\n").shapes[0].alpha.value.value(), .25, 1e-9);
    EXPECT_NEAR(loadMaterial("Kd 1 0 0\nTr .25\n").shapes[0].alpha.value.value(), .75, 1e-9);
    EXPECT_NEAR(loadMaterial("Kd 1 0 0\nd 1\nTr 1\n").shapes[0].alpha.value.value(), 1, 1e-9);
    EXPECT_NEAR(loadMaterial("Kd 1 0 0\nd -halo .5\n").shapes[0].alpha.value.value(), .5, 1e-9);
}

// The extension of physically based exporters: widths are squares of the roughness.
TEST_F(ObjMaterials, withPrAndPmArePrincipledOrMetal) {
    const Scene metal = loadMaterial("Kd .9 .6 .3\nPm 1\nPr .4\n"), plastic = loadMaterial("Kd .9 .6 .3\nPm 0\nPr .4\nNi 1.6\n"),
                half = loadMaterial("Kd .9 .6 .3\nPm .3\nPr .4\n");
    EXPECT_EQ(materialOf(metal).kind, &conductor_material);
    EXPECT_NEAR(number(materialOf(metal), "uroughness"), .16, 1e-9);
    EXPECT_EQ(color(materialOf(metal), "reflectance"), glm::dvec3(.9, .6, .3));
    EXPECT_EQ(materialOf(plastic).kind, &principled_material);
    EXPECT_EQ(number(materialOf(plastic), "eta"), 1.6);
    EXPECT_EQ(number(materialOf(plastic), "metallic"), 0);
    EXPECT_EQ(materialOf(half).kind, &principled_material);
    EXPECT_NEAR(number(materialOf(half), "metallic"), .3, 1e-9);
    EXPECT_EQ(color(materialOf(half), "base"), glm::dvec3(.9, .6, .3));

    const Scene coated = loadMaterial("Kd .9 .6 .3\nPm 1\nPr .4\nPc .5\nPcr .2\nPs .7\naniso .5\n");
    EXPECT_EQ(materialOf(coated).kind, &principled_material);
    EXPECT_NEAR(number(materialOf(coated), "coat"), .5, 1e-9);
    EXPECT_NEAR(number(materialOf(coated), "coatroughness"), .04, 1e-9);
    EXPECT_NEAR(number(materialOf(coated), "sheen"), .7, 1e-9);
    EXPECT_NEAR(number(materialOf(coated), "uroughness") * number(materialOf(coated), "vroughness"), .16 * .16, 1e-9);
    EXPECT_GT(number(materialOf(coated), "uroughness"), number(materialOf(coated), "vroughness"));
    EXPECT_THAT(warnings_, IsEmpty());
}

// A flat lamp shines to both sides; a closed one only outwards, where its light can go.
TEST_F(ObjMaterials, withKeEmit) {
    const Scene flat = loadMaterial("Kd 0 0 0\nKe 17 12 4\n");
    ASSERT_NE(flat.shapes[0].areaLight, none);
    const AreaLight& light = flat.areaLights.at(static_cast<std::size_t>(flat.shapes[0].areaLight));
    EXPECT_EQ(light.L.illuminant(), glm::dvec3(17, 12, 4));
    EXPECT_TRUE(light.twoSided);
    EXPECT_THAT(flat.lights, IsEmpty());  // no sky

    const Scene closed = load("mtllib model.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    EXPECT_FALSE(closed.areaLights.at(static_cast<std::size_t>(closed.shapes[0].areaLight)).twoSided);
}

TEST_F(ObjMaterials, haveImagesWithOptions) {
    writeImage("my image.ppm");
    const Scene scene = loadMaterial("Kd .5 .5 .5\nmap_Kd -s 2 3 1 -o .25 .5 -clamp on my image.ppm\n");
    const Texture& scale = textureOf(scene, materialOf(scene).inputs.at("reflectance"));
    EXPECT_EQ(scale.operands.at(1).value.albedo(), glm::dvec3(.5));
    const Texture& map = textureOf(scene, scale.operands.at(0));
    EXPECT_EQ(map.mapping.uScale, 2);
    EXPECT_EQ(map.mapping.vScale, 3);
    EXPECT_EQ(map.mapping.uOffset, .25);
    EXPECT_EQ(map.mapping.vOffset, .5);
    const ImageFile& image = scene.images.at(static_cast<std::size_t>(map.image));
    EXPECT_EQ(image.path, path("my image.ppm"));
    EXPECT_EQ(image.wrap, wrap_clamp);
    EXPECT_EQ(image.encoding, ColorEncoding::automatic);
    EXPECT_THAT(warnings_, IsEmpty());
}

// Paths of other people's machines: folders that are not there, written with backslashes.
TEST_F(ObjMaterials, findImagesBesideTheLibrary) {
    writeImage("wood.ppm");
    const Scene scene = loadMaterial("map_Kd \"C:\\work\\textures\\wood.ppm\"\n");
    EXPECT_EQ(scene.images.at(0).path, path("wood.ppm"));
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("model.mtl:2:8: warning: there is no file \"C:\\work\\textures\\wood.ppm\"; ")));
}

// A file that is there under nearly the same name is a guess: a warning, and under --strict an error. The name itself is none.
TEST_F(ObjMaterials, warnOfFilesUnderOtherNames) {
    std::filesystem::create_directory(folder_ / "tex");
    writeImage("tex/Wood.ppm");
    for (const std::string name : {"tex/wood.ppm", "tex\\Wood.ppm", "D:/models/tex/Wood.ppm", "../elsewhere/tex/Wood.ppm"}) {
        EXPECT_EQ(loadMaterial("map_Kd " + name + "\n").images.at(0).path, path("tex/Wood.ppm")) << name;
        EXPECT_THAT(warnings_,
                    ElementsAre(HasSubstr("there is no file \"" + name + "\"; \"" + path("tex/Wood.ppm") + "\" is read instead")));
        EXPECT_THAT(strictErrorIn("mtllib model.mtl\nusemtl m\n" + square + "vt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\n"),
                    AllOf(HasSubstr("model.mtl:2:8: there is no file \"" + name), HasSubstr("(an error because of --strict)")));
    }
    loadMaterial("map_Kd tex/Wood.ppm\n");
    EXPECT_THAT(warnings_, IsEmpty());

    write("Other.mtl", "newmtl m\nKd 1 0 0\n");
    const std::string content = "mtllib other.MTL\nusemtl m\n" + square + "f 1 2 3\n";
    load(content);
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("model.obj:1:8: warning: there is no file \"other.MTL\"; ")));
    EXPECT_THAT(strictErrorIn(content), HasSubstr("model.obj:1:8: there is no file \"other.MTL\"; "));
}

// Faces without a material are grey, which is said once: before any usemtl, of a material that is not there, and without a library.
TEST_F(ObjMaterials, thatAreMissingAreGreyWithAWarning) {
    const std::string faces = square + "f 1 2 3\nf 1 3 4\n";
    const auto expectWarning = [&](const std::string& content, const std::string& place, const std::string& message) {
        const Scene scene = load(content);
        EXPECT_EQ(materialOf(scene).kind, &diffuse_material);
        EXPECT_THAT(warnings_, ElementsAre(HasSubstr("model.obj:" + place + ": warning: " + message)));
        EXPECT_THAT(strictErrorIn(content), AllOf(HasSubstr("model.obj:" + place + ": " + message), HasSubstr("--strict")));
    };
    write("model.mtl", "newmtl m\nKd 1 0 0\n");
    expectWarning(faces, "5:1", "faces have no material (\"usemtl\"); they are grey");
    expectWarning("mtllib model.mtl\n" + faces, "6:1", "faces have no material (\"usemtl\"); they are grey");
    expectWarning("usemtl wood\n" + faces, "1:1", "there is no material \"wood\"; its faces are grey");
    expectWarning("mtllib gone.mtl\nusemtl wood\n" + faces, "1:8",
                  "there is no material library \"gone.mtl\"; faces without a material are grey");
}

TEST_F(ObjMaterials, findImagesInOtherCaseAndMayDoWithout) {
    writeImage("Wood.ppm");
    EXPECT_EQ(loadMaterial("map_Kd WOOD.PPM\n").images.at(0).path, path("Wood.ppm"));
    ObjOptions options;
    options.missingFiles = MissingFiles::magenta;
    write("model.mtl", "newmtl m\nmap_Kd oak.png\nmap_Bump bumps.png\n");
    const Scene scene = load("mtllib model.mtl\n" + square + "vt 0 0\nvt 1 0\nvt 1 1\nusemtl m\nf 1/1 2/2 3/3\n", options);
    EXPECT_THAT(scene.images.at(0).pixels->floats, testing::ElementsAre(1, 0, 1));
    EXPECT_EQ(materialOf(scene).displacement, none);
    EXPECT_THAT(warnings_, testing::UnorderedElementsAre(HasSubstr("no image \"oak.png\"; the texture is magenta"),
                                                         HasSubstr("no image \"bumps.png\"; the map is left out")));
}

TEST_F(ObjMaterials, haveAlphaBumpAndNormalMaps) {
    writeImage("grey.ppm");
    writeImage("normal.ppm", "128 128 255 120 130 250");
    const Scene scene = loadMaterial("Kd .5 .5 .5\nmap_d grey.ppm\nmap_Bump -bm .5 grey.ppm\n");
    EXPECT_NE(scene.shapes[0].alpha.texture, none);
    const int bump = materialOf(scene).displacement;
    ASSERT_NE(bump, none);
    // White is 2 % of the texture's side high; the texture is 1 wide here, and -bm halves it.
    EXPECT_NEAR(scene.textures.at(static_cast<std::size_t>(bump)).scale, .01, 1e-9);
    EXPECT_EQ(materialOf(scene).normalMap, none);

    for (const char* statement : {"map_Bump normal.ppm\n", "norm normal.ppm\n"}) {
        const Scene other = loadMaterial(std::string("Kd .5 .5 .5\n") + statement);
        EXPECT_EQ(materialOf(other).displacement, none) << statement;
        ASSERT_NE(materialOf(other).normalMap, none) << statement;
        EXPECT_EQ(other.images.at(static_cast<std::size_t>(materialOf(other).normalMap)).encoding, ColorEncoding::linear);
    }
}

TEST_F(ObjMaterials, warnOfWhatIsMissingOrUnknown) {
    const Scene noLibrary = load("mtllib a.mtl b.mtl\n" + square + "usemtl x\nf 1 2 3\n");
    EXPECT_EQ(materialOf(noLibrary).kind, &diffuse_material);
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("model.obj:1:8: warning: there is no material library \"a.mtl\""),
                                       HasSubstr("model.obj:1:14: warning: there is no material library \"b.mtl\"")));
    write("model.mtl", "newmtl m\nKd 1 1 1\nwobble 3\n");
    load("mtllib model.mtl\n" + square + "usemtl n\nf 1 2 3\nusemtl m\nf 1 2 4\n");
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("model.obj:6:1: warning: there is no material \"n\""),
                                       HasSubstr("model.mtl:3:1: warning: \"wobble\" is not supported")));
    writeImage("grey.ppm");
    loadMaterial("map_Kd -t .1 .1 .1 grey.ppm\n");
    EXPECT_THAT(warnings_, Contains(HasSubstr("the option \"-t .1 .1 .1\" is not supported")));
}

// One warning for a statement, at its first number that means nothing, with what counts instead.
TEST_F(ObjMaterials, warnOfNumbersThatMeanNothing) {
    const Scene scene = loadMaterial("Kd 2 -1 0.5\nKs 1\nNs -5\nNi 0\nd -halo -1\nillum 99\nKe 1e30 0 -1\nPr 5\n");
    EXPECT_THAT(warnings_,
                testing::UnorderedElementsAre(
                    HasSubstr("model.mtl:2:4: warning: \"Kd\" is 2 -1 0.5; it counts as 1 0 0.5, since each number must be from 0 to 1"),
                    HasSubstr("model.mtl:4:4: warning: \"Ns\" is -5; it counts as 0, since it must be at least 0"),
                    HasSubstr("model.mtl:5:4: warning: \"Ni\" is 0; it counts as 1, since it must be from 0.001 to 10"),
                    HasSubstr("model.mtl:6:9: warning: \"d\" is -1; it counts as 0, since it must be from 0 to 1"),
                    HasSubstr("model.mtl:7:7: warning: \"illum\" is 99; it counts as 2, since it must be a whole number from 0 to 10"),
                    HasSubstr("model.mtl:8:11: warning: \"Ke\" is 1e30 0 -1; it counts as 1e30 0 0, since each number must be at least 0"),
                    HasSubstr("model.mtl:9:4: warning: \"Pr\" is 5; it counts as 1, since it must be from 0 to 1")));
    EXPECT_EQ(color(materialOf(scene), "base"), glm::dvec3(1, 0, .5));
    EXPECT_EQ(number(materialOf(scene), "uroughness"), 1);
    EXPECT_EQ(scene.areaLights.at(0).L.color(), glm::dvec3(1e30, 0, 0));

    loadMaterial("Kd .2 .4 .6\nKs 0\nNs 0\nNi 1\nd 1\nTr 0\nillum 2\nKe 0 0 0\nPr 0\nPm 1\nPs 0\nPc 1\nPcr 0\naniso 0\nTf 1 1 1\n");
    EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(ObjMaterials, warnOfExtraWords) {
    const Scene scene = loadMaterial("Kd .5 .4 .3 .2 .1\nKs 0 0 0 # black\nd -halo 1 1\nillum 2 x\nKe 0\n");
    EXPECT_EQ(color(materialOf(scene), "reflectance"), glm::dvec3(.5, .4, .3));
    EXPECT_THAT(warnings_,
                testing::UnorderedElementsAre(
                    HasSubstr("model.mtl:2:13: warning: \"Kd\" takes three numbers: \".2\" after them does not count"),
                    HasSubstr("model.mtl:4:11: warning: \"d\" takes one number: \"1\" after it does not count"),
                    HasSubstr("model.mtl:5:9: warning: \"illum\" takes one number: \"x\" after it does not count")));
    EXPECT_THAT(strictErrorIn("mtllib model.mtl\n" + square + "usemtl m\nf 1 2 3\n"), HasSubstr("--strict"));
    loadMaterial("Kd .5 .4 .3 # a comment\nKe 0\nNs 10 # another\nd -halo 1\nTf 1 1 1\nillum 1\n");
    EXPECT_THAT(warnings_, IsEmpty());
}

// Of two materials with one name the first counts, in one library or two. A library that is named twice is read once.
TEST_F(ObjMaterials, warnOfASecondOneWithTheirName) {
    write("a.mtl", "newmtl x\nKd 1 0 0\nnewmtl x\nKd 0 1 0\n");
    write("b.mtl", "newmtl y\nKd 1 1 0\n");
    write("c.mtl", "# another\nnewmtl y\nKd 0 0 1\n");
    const std::string faces = square + "usemtl x\nf 1 2 3\n";
    const Scene scene = load("mtllib a.mtl a.mtl\n" + faces);
    EXPECT_EQ(color(materialOf(scene), "reflectance"), glm::dvec3(1, 0, 0));
    const std::string message = "material \"x\" is there already, at " + path("a.mtl") + ":1:1; that one counts, and this one is skipped";
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("a.mtl:3:1: warning: " + message)));
    EXPECT_THAT(strictErrorIn("mtllib a.mtl\n" + faces), HasSubstr("a.mtl:3:1: material \"x\" is there already"));
    load("mtllib b.mtl c.mtl\n" + square + "usemtl y\nf 1 2 3\n");
    EXPECT_THAT(warnings_, ElementsAre(AllOf(HasSubstr("c.mtl:2:1: warning: material \"y\""), HasSubstr("b.mtl:1:1; that one counts"))));
}

TEST_F(ObjMaterials, warnOfStatementsWithoutAMaterial) {
    const std::string faces = square + "usemtl m\nf 1 2 3\n";
    write("model.mtl", "# a library\n Kd 1 0 0\nKs 1 1 1\nnewmtl m\nKd 0 1 0\nnewmtl # m\nKd 0 0 1\n");
    const Scene scene = load("mtllib model.mtl\n" + faces);
    EXPECT_EQ(color(materialOf(scene), "reflectance"), glm::dvec3(0, 1, 0));
    EXPECT_THAT(warnings_,
                testing::UnorderedElementsAre(
                    HasSubstr("model.mtl:2:2: warning: \"Kd\" belongs to no material and is skipped; it must follow a \"newmtl\""),
                    HasSubstr("model.mtl:6:1: warning: \"newmtl\" needs the name of a material; this one is skipped")));
    EXPECT_THAT(strictErrorIn("mtllib model.mtl\n" + faces), HasSubstr("model.mtl:6:1: \"newmtl\" needs the name"));

    // Faces before any "usemtl" do not have the material without a name.
    load("mtllib model.mtl\n" + square + "f 1 2 3\n");
    EXPECT_THAT(warnings_, Contains(HasSubstr("faces have no material")));
}

TEST_F(ObjMaterials, warnOfALibraryWithoutAny) {
    write("part.obj", square + "f 1 2 3\n");
    const std::string content = "mtllib part.obj\n" + square + "usemtl m\nf 1 2 3\n";
    load(content);
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("model.obj:1:8: warning: the material library \"" + path("part.obj") +
                                                 "\" has no material (\"newmtl NAME\")"),
                                       HasSubstr("there is no material \"m\"")));
    EXPECT_THAT(strictErrorIn(content), HasSubstr("has no material (\"newmtl NAME\") (an error because of --strict)"));
}

TEST_F(ObjMaterials, saysWhereTheyAreWrong) {
    const auto errorIn = [&](const std::string& statements) { return errorOf([&] { loadMaterial(statements); }); };
    EXPECT_EQ(errorIn("Kd 1 0\n"), "model.mtl:2:1: \"Kd\" needs three numbers, and has 2");
    EXPECT_EQ(errorIn("Kd red\n"), "model.mtl:2:4: \"red\" is not a finite number");
    EXPECT_EQ(errorIn("Kd nan 0 0\n"), "model.mtl:2:4: \"nan\" is not a finite number");
    EXPECT_EQ(errorIn("kd 1e50 0 0\n"), "model.mtl:2:4: \"1e50\" is too large: single precision ends at about 3.4e38");
    EXPECT_EQ(errorIn("KD xyz 1 1 1 1\n"), "model.mtl:2:4: \"KD\" as \"xyz\" cannot be read; give red, green and blue");
    EXPECT_EQ(errorIn("Ns\n"), "no error");  // Ns counts only where there is a highlight
    EXPECT_EQ(errorIn("Kd .5 .5 .5\nKs 1 1 1\nNs\n"), "model.mtl:4:1: \"Ns\" needs a number");
    EXPECT_EQ(errorIn("map_Kd -bm\n"), "model.mtl:2:8: \"-bm\" needs 1 more word");
    EXPECT_EQ(errorIn("map_Kd -s 2 2 2\n"), "model.mtl:2:1: \"map_Kd\" names no image");
    writeImage("wood.ppm");
    EXPECT_EQ(errorIn("map_Kd wod.ppm\nmap_Ks stone.png\nKs 1 1 1\n"),
              "model.mtl:2:8: there is no image \"wod.ppm\"; did you mean \"wood.ppm\"?\nmodel.mtl:3:8: there is no image \"stone.png\"");
}

}  // namespace
}  // namespace eikonal
