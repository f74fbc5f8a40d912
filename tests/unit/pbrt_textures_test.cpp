// Textures. The defaults are those of pbrt-v4's source (textures.cpp).

#include "kinds/texture_kind.h"
#include "unit/pbrt_reading.h"

namespace eikonal {
namespace {

class PbrtTextures : public PbrtTest {
protected:
    PbrtTextures() {
        write("a.png", "an image");
        write("a.PNG", "an image");
        write("a.jpg", "an image");
    }
    Texture texture(const std::string& text) { return world("Texture \"t\" " + text).textures.at(0); }
    double operand(const std::string& text, size_t which) { return texture(text).operands.at(which).value.value(); }
    ImageFile image(const std::string& parameters) { return world("Texture \"t\" \"spectrum\" \"imagemap\" " + parameters).images.at(0); }
};

TEST_F(PbrtTextures, defaults) {
    EXPECT_EQ(operand("\"float\" \"constant\"", 0), 1);
    EXPECT_EQ(operand("\"spectrum\" \"scale\"", 0), 1);
    EXPECT_EQ(operand("\"spectrum\" \"mix\"", 0), 0);
    EXPECT_EQ(operand("\"spectrum\" \"mix\"", 1), 1);
    EXPECT_EQ(operand("\"spectrum\" \"mix\"", 2), .5);
    const Texture board = texture("\"float\" \"checkerboard\"");
    EXPECT_EQ(board.operands.at(0).value.value(), 1);
    EXPECT_EQ(board.operands.at(1).value.value(), 0);
    EXPECT_EQ(board.dimensions, 2);
    EXPECT_EQ(board.mapping.kind, mapping_uv);
    EXPECT_EQ(board.mapping.uScale, 1);
}

TEST_F(PbrtTextures, patterns) {
    const Texture bilerp = texture(R"("spectrum" "bilerp" "rgb v10" [.1 .2 .3] "float vscale" 2)");
    EXPECT_EQ(bilerp.operands.at(0).value.value(), 0);
    EXPECT_EQ(bilerp.operands.at(1).value.value(), 1);
    expectNear(bilerp.operands.at(2).value.albedo(), {.1, .2, .3});
    EXPECT_EQ(bilerp.operands.at(3).value.value(), 1);
    EXPECT_EQ(bilerp.mapping.vScale, 2);
    const Texture dots = texture("\"float\" \"dots\"");
    EXPECT_EQ(dots.operands.at(0).value.value(), 0);   // the parameters are exchanged, as in pbrt-v4
    EXPECT_EQ(dots.operands.at(1).value.value(), 1);
    const Texture mix = world("Rotate 90 1 0 0 Scale 2 2 2 Texture \"t\" \"float\" \"directionmix\"").textures.at(0);
    EXPECT_EQ(mix.operands.at(0).value.value(), 0);
    EXPECT_EQ(mix.operands.at(1).value.value(), 1);
    expectNear(mix.direction, {0, 0, 1});
    EXPECT_THAT(errorOfWorld("Texture \"t\" \"float\" \"directionmix\" \"vector3 dir\" [0 0 0]"), HasSubstr("has no length"));
}

TEST_F(PbrtTextures, noise) {
    const Texture fbm = texture("\"float\" \"fbm\"");
    EXPECT_EQ(fbm.kind->value, kind_fbm_texture);
    EXPECT_EQ(fbm.octaves, 8);
    EXPECT_EQ(fbm.roughness, .5);
    EXPECT_EQ(texture("\"float\" \"wrinkled\" \"integer octaves\" 3").octaves, 3);
    EXPECT_EQ(texture("\"float\" \"windy\"").kind->value, kind_windy_texture);
    const Texture marble = texture("\"spectrum\" \"marble\" \"float scale\" 2");
    EXPECT_EQ(marble.kind->value, kind_marble_texture);
    EXPECT_EQ(marble.scale, 2);
    EXPECT_EQ(marble.variation, .2);
    EXPECT_THAT(errorOfWorld("Texture \"t\" \"float\" \"fbm\" \"integer octaves\" 40"),
                HasSubstr("\"integer octaves\" is 40; it can be 0 to 32"));
    EXPECT_THAT(errorOfWorld("Texture \"t\" \"spectrum\" \"fbm\""), HasSubstr("fbm"));
}

TEST_F(PbrtTextures, imagemaps) {
    const Texture map = texture(
        R"("spectrum" "imagemap" "string filename" "a.png" "float scale" 2 "bool invert" true "float uscale" 3 "float vdelta" .5)");
    EXPECT_EQ(map.scale, 2);
    EXPECT_TRUE(map.invert);
    EXPECT_EQ(map.mapping.uScale, 3);
    EXPECT_EQ(map.mapping.vOffset, .5);
    EXPECT_THAT(errorOfWorld("Texture \"t\" \"float\" \"imagemap\""), HasSubstr("needs a \"string filename\""));

    const ImageFile file = image("\"string filename\" \"a.png\"");
    EXPECT_EQ(file.path, path("a.png"));
    EXPECT_EQ(file.encoding, ColorEncoding::automatic);
    EXPECT_EQ(file.wrap, wrap_repeat);
    EXPECT_EQ(file.filter, filter_bilinear);
    EXPECT_EQ(image("\"string filename\" \"a.png\" \"string wrap\" \"octahedralsphere\" \"string filter\" \"point\"").wrap,
              wrap_octahedral);
    EXPECT_EQ(image("\"string filename\" \"a.png\" \"string filter\" \"point\"").filter, filter_nearest);
    EXPECT_EQ(image("\"string filename\" \"a.png\" \"string filter\" \"ewa\"").filter, filter_bilinear);
    EXPECT_THAT(errorOfWorld("Texture \"t\" \"float\" \"imagemap\" \"string filename\" \"a.png\" \"string wrap\" \"mirror\""),
                HasSubstr("it can be \"repeat\", \"black\", \"clamp\" or \"octahedralsphere\""));
}

// pbrt-v4 passes the encoding to its reader of PNG files alone; other files of integers are sRGB.
TEST_F(PbrtTextures, encodingsAreOfPngs) {
    EXPECT_EQ(image("\"string filename\" \"a.png\" \"string encoding\" \"linear\"").encoding, ColorEncoding::linear);
    EXPECT_EQ(image("\"string filename\" \"a.PNG\" \"string encoding\" \"sRGB\"").encoding, ColorEncoding::srgb);
    EXPECT_EQ(image("\"string filename\" \"a.png\" \"string encoding\" \"gamma 2.2\"").gamma, 2.2);
    EXPECT_EQ(image("\"string filename\" \"a.jpg\" \"string encoding\" \"linear\"").encoding, ColorEncoding::automatic);
    EXPECT_THAT(warnings_,
                ElementsAre(HasSubstr("warning: \"string encoding\" \"linear\" is ignored: only that of PNG files can be chosen, as in "
                                      "pbrt-v4; this file is sRGB")));
    image("\"string filename\" \"a.jpg\" \"string encoding\" \"sRGB\"");
    EXPECT_THAT(warnings_, IsEmpty());
    EXPECT_THAT(errorOfWorld("Texture \"t\" \"float\" \"imagemap\" \"string filename\" \"a.png\" \"string encoding\" \"log\""),
                HasSubstr("\"gamma 2.2\""));
}

TEST_F(PbrtTextures, anImageIsKeptOnce) {
    const Scene scene = world(
        "Texture \"a\" \"float\" \"imagemap\" \"string filename\" \"a.png\" Texture \"b\" \"spectrum\" \"imagemap\" \"string filename\" "
        "\"a.png\"");
    EXPECT_EQ(scene.textures.size(), 2u);
    EXPECT_EQ(scene.images.size(), 1u);
}

TEST_F(PbrtTextures, mappingsFollowTheTransform) {
    const Scene scene = world(
        "Translate 1 2 3 Texture \"t\" \"float\" \"checkerboard\" \"string mapping\" \"planar\" \"vector3 v1\" [0 0 2] \"float udelta\" 4");
    const Mapping& mapping = scene.textures[0].mapping;
    EXPECT_EQ(mapping.kind, mapping_planar);
    expectNear(mapping.planeU, {0, 0, 2});
    expectNear(mapping.planeV, {0, 1, 0});
    EXPECT_EQ(mapping.uOffset, 4);
    expectNear(apply(mapping.worldFromTexture, {0, 0, 0}), {1, 2, 3});
    EXPECT_EQ(texture("\"float\" \"checkerboard\" \"string mapping\" \"spherical\"").mapping.kind, mapping_spherical);
    EXPECT_EQ(texture("\"float\" \"checkerboard\" \"string mapping\" \"cylindrical\"").mapping.kind, mapping_cylindrical);
    EXPECT_THAT(errorOfWorld("Texture \"t\" \"float\" \"checkerboard\" \"string mapping\" \"cubic\""),
                HasSubstr("it can be \"uv\", \"spherical\""));
    EXPECT_THAT(errorOfWorld("Texture \"t\" \"float\" \"checkerboard\" \"integer dimension\" 4"), HasSubstr("it can be 2 or 3"));
}

TEST_F(PbrtTextures, texturesAreMadeOfTextures) {
    const Scene scene = world(R"(Texture "s" "spectrum" "scale" "texture tex" "t" "texture scale" "f"
        Texture "t" "spectrum" "constant" "rgb value" [.1 .2 .3]
        Texture "f" "float" "constant" "float value" .5
        Material "diffuse" "texture reflectance" "s")");
    const Texture& scale = scene.textures[scene.materials[0].inputs.at("reflectance").texture];
    EXPECT_EQ(scene.textures[scale.operands.at(0).texture].name, "t");
    EXPECT_TRUE(scene.textures[scale.operands.at(1).texture].isFloat);
}

TEST_F(PbrtTextures, floatAndSpectrumTexturesHaveNamesOfTheirOwn) {
    const std::string both = "Texture \"t\" \"float\" \"constant\" Texture \"t\" \"spectrum\" \"constant\" ";
    EXPECT_EQ(world(both).textures.size(), 2u);
    EXPECT_THAT(errorOfWorld(both + "Texture \"t\" \"float\" \"mix\""),
                HasSubstr("there is already a float texture \"t\", at test.pbrt:2:1"));
    EXPECT_THAT(errorOfWorld("Texture \"u\" \"float\" \"constant\" Material \"diffuse\" \"texture reflectance\" \"u\""),
                HasSubstr("there is no spectrum texture \"u\": \"u\" is a float texture"));
    EXPECT_THAT(errorOfWorld("Texture \"wood\" \"spectrum\" \"constant\" Material \"diffuse\" \"texture reflectance\" \"woood\""),
                HasSubstr("did you mean \"wood\"?"));
    EXPECT_THAT(errorOfWorld("Texture \"t\" \"spectrum\" \"scale\" \"texture tex\" \"t\""), HasSubstr("refers to itself"));
    EXPECT_THAT(errorOfWorld("Texture \"t\" \"color\" \"constant\""), HasSubstr("pbrt-v3"));
}

TEST_F(PbrtTextures, whatIsNotRenderedIsNamedOnce) {
    world(R"(Texture "a" "float" "ptex" Texture "b" "float" "ptex" "float scale" 3)");
    EXPECT_THAT(warnings_, ElementsAre(AllOf(HasSubstr("test.pbrt:2:1"),
                                             HasSubstr("texture \"ptex\" is not rendered yet; a constant 0.5 stands in for it"))));
}

}  // namespace
}  // namespace eikonal
