// What the device's tables hold of a scene.

#include "kind_features.h"
#include "kinds/integrator_kind.h"
#include "render/session.h"
#include "pack/missed_light.h"
#include "pack/pack.h"

#include "measured_file.h"
#include "unit/pbrt_reading.h"

#include <fmt/format.h>

namespace eikonal {
namespace {

class Pack : public PbrtTest {
protected:
    PackedScene pack(const std::string& text) {
        Diagnostics diagnostics(LogLevel::silent, true);
        return packScene(world(text), diagnostics);
    }
};

// Nothing is tabulated unless a rough material asks for it: once for each set of widths and indices.
TEST_F(Pack, LostEnergyIsTabulatedOnRequest) {
    const auto sphere = [](const std::string& material) { return "Material " + material + "\nShape \"sphere\"\n"; };
    const std::string on = " \"bool energycompensation\" true", rough = " \"float roughness\" .3";
    for (const char* kind : {"\"conductor\"", "\"dielectric\"", "\"subsurface\""})
        for (const std::string& off : {rough, rough + " \"bool energycompensation\" false", on}) {
            const PackedScene scene = pack(sphere(kind + off));
            EXPECT_TRUE(scene.tables.energy_tables.empty() && scene.tables.energy_values.empty()) << kind << off;
            EXPECT_FALSE(scene.features.has(KindFeature::BSDF_COMPENSATED_CONDUCTOR)) << kind << off;
            EXPECT_FALSE(scene.features.has(KindFeature::BSDF_COMPENSATED_DIELECTRIC)) << kind << off;
        }
    const PackedScene scene = pack(sphere("\"conductor\"" + rough + on) + sphere("\"conductor\" \"rgb reflectance\" [1 1 1]" + rough + on) +
                                   sphere("\"dielectric\"" + rough + on) + sphere("\"subsurface\" \"float eta\" 1.5" + rough + on));
    ASSERT_EQ(scene.tables.energy_tables.size(), 2u);
    EXPECT_EQ(scene.constants.energyTables, 2);
    EXPECT_EQ(scene.tables.energy_tables[0].sides, 1u);
    EXPECT_EQ(scene.tables.energy_tables[1].sides, 2u);
    EXPECT_TRUE(scene.features.has(KindFeature::BSDF_COMPENSATED_CONDUCTOR));
    EXPECT_TRUE(scene.features.has(KindFeature::BSDF_COMPENSATED_DIELECTRIC));
    EXPECT_THAT(errorOfWorld("Material \"conductor\" \"float energycompensation\" 1"), HasSubstr("bool energycompensation"));
}

// A stretched mesh has the normals of a stretched instance of it: between two corners, the direction is that of the sum of the transformed
// normals, whose lengths differ. Under a stretch by 4 along x, (0, 0, 1) stays and (1, 0, 0) becomes a quarter as long.
TEST_F(Pack, StretchedNormalsKeepTheirShares) {
    const std::string mesh = "Shape \"trianglemesh\" \"point3 P\" [ 0 0 0  1 0 0  0 1 0 ] \"normal N\" [ 0 0 2  2 0 0  0 0 0 ]";
    const PackedScene scene = pack("Scale 4 1 1 " + mesh);
    ASSERT_EQ(scene.tables.normals.size(), 3u);
    EXPECT_FLOAT_EQ(scene.tables.normals[0].z, 1);
    EXPECT_FLOAT_EQ(scene.tables.normals[1].x, 0.25f);
    EXPECT_EQ(scene.tables.normals[2].z, 0);
    /* None is so short that its square is 0 */
    const float shortest = pack("Scale 1e30 1 1 " + mesh).tables.normals[1].x;
    EXPECT_GT(shortest * shortest, 0);
}

// A sphere of radius 4 and relief of 0.5 is the same scene as one of radius 1 and relief of 0.125: once both are of order one, a
// displacement of one constant is the same number of scene units.
TEST_F(Pack, DisplacementsAreScaledWithTheScene) {
    const auto reliefOf = [&](double radius, double height) {
        const PackedScene scene =
            pack("Texture \"relief\" \"float\" \"constant\" \"float value\" " + std::to_string(height) +
                 "\nMaterial \"diffuse\" \"texture displacement\" \"relief\"\nShape \"sphere\" \"float radius\" " + std::to_string(radius));
        const texture_program program = scene.tables.programs.at(scene.tables.materials.at(0).displacement);
        double product = 1;   // a constant, and as long as it is not 1 the scale of the scene
        for (uint i = program.first; i < program.first + program.count; ++i)
            if (scene.tables.instructions[i].kind == kind_constant_texture) product *= scene.tables.instructions[i].value.scale;
        return product;
    };
    EXPECT_EQ(reliefOf(4, 0.5), reliefOf(1, 0.125));
    EXPECT_EQ(reliefOf(4, 0.5) * pack("Shape \"sphere\" \"float radius\" 4").worldScale, 0.5);
}

// Textures of coefficients are kept as they are, numbers above 1 included, for which nothing else is built; a walk that they would lead is
// diffused.
TEST_F(Pack, CoefficientsOfBodiesMayBeTextures) {
    Diagnostics diagnostics(LogLevel::silent, false);
    const std::string body =
        "Texture \"t\" \"spectrum\" \"constant\" \"rgb value\" [3 2 .5] Material \"subsurface\" \"string method\" \"randomwalk\" ";
    const PackedScene textured =
        packScene(world(body + "\"texture sigma_a\" \"t\" \"rgb sigma_s\" [4 5 6]\nShape \"sphere\""), diagnostics);
    EXPECT_THAT(diagnostics.warnings(), ElementsAre(HasSubstr("the diffusion profile is used instead")));
    const SceneTables& tables = textured.tables;
    for (const uint index : {tables.profiles.at(0).albedo_texture, tables.profiles.at(0).path_texture}) {
        const texture_program program = tables.programs.at(index);
        ASSERT_EQ(program.count, 3u);
        EXPECT_EQ(tables.instructions[program.first].value.c0, 3);
        EXPECT_EQ(tables.instructions[program.first + 1].value.c2, 6);
    }
    EXPECT_TRUE(textured.features.has(KindFeature::TEXTURE_DIFFUSEALBEDO));
    EXPECT_TRUE(textured.features.has(KindFeature::TEXTURE_FREEPATH));
    const PackedScene plain = pack("Material \"subsurface\" \"rgb sigma_a\" [3 2 .5] \"rgb sigma_s\" [4 5 6]\nShape \"sphere\"");
    for (const Feature feature :
         {KindFeature::TEXTURE_DIFFUSEALBEDO, KindFeature::TEXTURE_FREEPATH, Feature::BODY_TEXTURES, Feature::TEXTURED})
        EXPECT_FALSE(plain.features.has(feature));
}

// Nor are metals' indices and what a hair absorbs reflectances: at wavelengths, a colour of theirs is a spectrum in [0, 1] times twice its
// largest channel.
TEST_F(Pack, TexturedCoefficientsAreNoReflectances) {
    for (const std::string material : {"\"conductor\" \"texture k\"", "\"conductor\" \"texture eta\"", "\"hair\" \"texture sigma_a\""}) {
        Diagnostics diagnostics(LogLevel::silent, true);
        Scene scene =
            world("Texture \"t\" \"spectrum\" \"constant\" \"rgb value\" [3 2 .5] Material " + material + " \"t\" Shape \"sphere\"");
        scene.colorMode = ColorMode::spectral;
        const Table<texture_instruction> instructions = packScene(scene, diagnostics).tables.instructions;
        EXPECT_EQ(std::ranges::count_if(instructions, [](const texture_instruction& i) { return i.value.scale == 6; }), 1) << material;
    }
}

// What is given as a spectrum or by its temperature, wherever it is, asks for wavelengths; metals do not, and what is not used does not.
TEST_F(Pack, SpectraAskForWavelengths) {
    const auto isSpectral = [&](const std::string& text) { return pack(text + "\nShape \"sphere\"").features.has(Feature::SPECTRAL); };
    const std::string green = "Texture \"green\" \"spectrum\" \"constant\" \"spectrum value\" [400 .1 550 .8 700 .2]\n",
                      use = "Material \"diffuse\" \"texture reflectance\" ";
    EXPECT_FALSE(isSpectral("LightSource \"infinite\" \"rgb L\" [1 1 1] Material \"diffuse\" \"rgb reflectance\" [.1 .2 .3]"));
    EXPECT_FALSE(isSpectral("Material \"conductor\" \"spectrum eta\" \"metal-Au-eta\" \"spectrum k\" \"metal-Au-k\""));
    EXPECT_FALSE(isSpectral(green));
    EXPECT_TRUE(isSpectral(green + use + "\"green\""));
    EXPECT_TRUE(
        isSpectral(green + "Texture \"mixed\" \"spectrum\" \"mix\" \"texture tex1\" \"green\" \"rgb tex2\" [0 0 1]\n" + use + "\"mixed\""));
    EXPECT_TRUE(isSpectral("Material \"diffuse\" \"spectrum reflectance\" [400 .1 550 .8 700 .2]"));
    EXPECT_TRUE(isSpectral(green + "Material \"subsurface\" \"rgb sigma_a\" [1 1 1] \"texture sigma_s\" \"green\""));
    EXPECT_TRUE(isSpectral("Material \"dielectric\" \"spectrum eta\" \"glass-BK7\""));
    EXPECT_TRUE(isSpectral("LightSource \"point\" \"blackbody I\" 3000"));
    EXPECT_TRUE(isSpectral("AreaLightSource \"diffuse\" \"spectrum L\" \"stdillum-F11\""));
    const std::string fire =
                          "MakeNamedMedium \"fire\" \"string type\" \"uniformgrid\" \"integer nx\" 1 \"integer ny\" 1 \"integer nz\" 1 "
                          "\"float density\" [1] ",
                      inside = "\nMediumInterface \"fire\" \"\" Material \"interface\"";
    EXPECT_FALSE(isSpectral(fire + inside));
    EXPECT_TRUE(isSpectral(fire + "\"float temperature\" [2000]" + inside));
}

// A film that keeps a spectrum asks for them as well, whatever the scene; where the command line has forbidden them, that is said.
TEST_F(Pack, AFilmMayAskForWavelengths) {
    Diagnostics diagnostics(LogLevel::silent, true);
    Scene scene =
        read("Film \"spectral\" \"integer nbuckets\" 30 \"float lambdamin\" 400 \"float lambdamax\" 700\nWorldBegin\nShape \"sphere\"");
    const PackedScene packed = packScene(scene, diagnostics);
    EXPECT_TRUE(packed.features.has(Feature::SPECTRAL) && packed.features.has(Feature::SPECTRAL_FILM));
    EXPECT_THAT(packed.reasons.at(Feature::SPECTRAL), HasSubstr("test.pbrt:1:1: film \"spectral\""));
    EXPECT_EQ(packed.frame().bucket_count, 30u);
    const wavelength_range& range = packed.tables.wavelengths.at(0);
    EXPECT_FLOAT_EQ(range.extent / range.inverse_pdf, range.share) << "the density within the range holds its share";
    EXPECT_FLOAT_EQ((1 - range.share) * range.inverse_pdf_beside, 470 - 300) << "and that beside it the rest";
    scene.colorMode = ColorMode::rgb;
    EXPECT_THAT([&] { packScene(scene, diagnostics); },
                testing::ThrowsMessage<SceneError>(AllOf(HasSubstr("test.pbrt:1:1: film \"spectral\""), HasSubstr("--color spectral"))));
    EXPECT_TRUE(pack("Shape \"sphere\"").tables.wavelengths.empty());
}

// Expanded, this tower of textures has 2^40 nodes: packing must neither visit nor write each of them.
TEST_F(Pack, TexturesOfTexturesEnd) {
    std::string tower = "Texture \"t0\" \"spectrum\" \"constant\" \"rgb value\" [.1 .8 .2]\n";
    for (int i = 1; i <= 40; ++i)
        tower += fmt::format("Texture \"t{0}\" \"spectrum\" \"mix\" \"texture tex1\" \"t{1}\" \"texture tex2\" \"t{1}\"\n", i, i - 1);
    try {
        pack(tower + "Material \"diffuse\" \"texture reflectance\" \"t40\"\nShape \"sphere\"");
        ADD_FAILURE() << "that is too much";
    } catch (const SceneError& error) {
        EXPECT_NE(std::string(error.what()).find("more than 65536 steps"), std::string::npos) << error.what();
    }
}

// pbrt-v4 goes on with one wavelength wherever an index is not one number: of glass, of coats, and if it is given as a colour.
TEST_F(Pack, IndicesThatDependOnTheWavelengthDisperse) {
    const std::pair<std::string, std::string> materials[] = {
        {"dielectric", "eta"}, {"thindielectric", "eta"}, {"coateddiffuse", "eta"}, {"coatedconductor", "interface.eta"}};
    for (const auto& [kind, eta] : materials) {
        const auto disperses = [&](const std::string& type, const std::string& value) {
            return pack("LightSource \"infinite\" \"spectrum L\" \"stdillum-D65\" Material \"" + kind + "\" \"" + type + " " + eta + "\" " +
                        value + " Shape \"sphere\"")
                .features.has(Feature::DISPERSION);
        };
        EXPECT_TRUE(disperses("spectrum", "\"glass-F11\"")) << kind;
        EXPECT_TRUE(disperses("rgb", "[1.2 1.5 2.2]")) << kind;
        EXPECT_FALSE(disperses("rgb", "[1.5 1.5 1.5]")) << kind;
        EXPECT_FALSE(disperses("float", "1.5")) << kind;
    }
}

// pbrt-v4's rule for microfacet widths below 0.3: doubled, at least 0.1, at most 0.3. What has none has no twin.
TEST_F(Pack, RegularizationMakesARougherTwin) {
    const auto widthOfTwin = [&](const std::string& material) {
        Diagnostics diagnostics(LogLevel::silent, true);
        const PackedScene scene = packScene(
            read("Integrator \"path\" \"bool regularize\" true\nWorldBegin\nMaterial " + material + "\nShape \"sphere\""), diagnostics);
        const material_input& last = scene.tables.material_inputs.at([&] {
            const ::eikonal::material& twin = scene.tables.materials.at(scene.tables.materials.at(0).regular);
            return twin.first_input + twin.input_count - 1;
        }());
        return last.value.scale;
    };
    const std::string conductor = "\"conductor\" \"bool remaproughness\" false \"float roughness\" ";
    EXPECT_FLOAT_EQ(widthOfTwin(conductor + "0"), 0.1f);
    EXPECT_FLOAT_EQ(widthOfTwin(conductor + ".02"), 0.1f);
    EXPECT_FLOAT_EQ(widthOfTwin(conductor + ".12"), 0.24f);
    EXPECT_FLOAT_EQ(widthOfTwin(conductor + ".2"), 0.3f);
    EXPECT_FLOAT_EQ(widthOfTwin(conductor + ".6"), 0.6f);

    Diagnostics diagnostics(LogLevel::silent, true);
    const PackedScene thin = packScene(
        read("Integrator \"path\" \"bool regularize\" true\nWorldBegin\nMaterial \"thindielectric\" Shape \"sphere\""), diagnostics);
    EXPECT_EQ(thin.tables.materials.at(0).regular, 0u);
    EXPECT_FALSE(thin.features.has(Feature::REGULARIZE));
    EXPECT_EQ(pack("Material \"conductor\" Shape \"sphere\"").tables.materials.size(), 1u);
}

// An integrator that ignores media has none around the camera either: the index would be that of another medium, of a body.
TEST_F(Pack, TheCameraIsInNoMediumThatIsIgnored) {
    const std::string fog = "MakeNamedMedium \"fog\" \"string type\" \"homogeneous\" MediumInterface \"\" \"fog\" Camera \"perspective\" ",
                      body = "WorldBegin Material \"subsurface\" \"string method\" \"randomwalk\" Shape \"sphere\"";
    Diagnostics diagnostics(LogLevel::silent);
    EXPECT_EQ(packScene(read("Integrator \"path\" " + fog + body), diagnostics).frame().view.medium, NONE);
    EXPECT_EQ(packScene(read("Integrator \"volpath\" " + fog + body), diagnostics).frame().view.medium, 0u);
}

// Light by way of smooth surfaces: a point light's is missing, a small lamp's is noisy, a large lamp's is neither; nor is any without them.
TEST_F(Pack, HardLightIsNamed) {
    const std::string glass = "Material \"dielectric\" Shape \"sphere\" ", point = "LightSource \"point\" ",
                      rough = "Material \"dielectric\" \"float roughness\" .3 Shape \"sphere\" ";
    const auto lamp = [](double radius) {
        return fmt::format("AttributeBegin AreaLightSource \"diffuse\" Translate 0 3 0 Shape \"sphere\" \"float radius\" {} AttributeEnd ",
                           radius);
    };
    EXPECT_THAT(missedLight(pack(point + glass)),
                ElementsAre(AllOf(HasSubstr("a point light"), HasSubstr("test.pbrt:"), HasSubstr("is missing"))));
    EXPECT_THAT(missedLight(pack(lamp(0.01) + glass)), ElementsAre(HasSubstr("is noisy")));
    EXPECT_EQ(missedLight(pack(point + lamp(0.01) + glass)).size(), 2u);
    for (const std::string& world : {lamp(1) + glass, point + lamp(0.01) + rough, glass})
        EXPECT_THAT(missedLight(pack(world)), IsEmpty()) << world;
    /* "auto" traces light paths where others miss light */
    for (const auto& [world, traces] :
         {std::pair(point + glass, true), {lamp(0.01) + glass, true}, {lamp(1) + glass, false}, {point + rough, false}}) {
        Diagnostics silent(LogLevel::silent, true);
        const PackedScene scene = packScene(read("Integrator \"auto\"\nWorldBegin\n" + world), silent);
        EXPECT_EQ(scene.features.has(Feature::LIGHT_PATHS), traces) << world;
        EXPECT_EQ(scene.features.has(Feature::MERGING), traces) << world;
    }
    /* Paths from both ends miss less */
    Diagnostics diagnostics(LogLevel::silent, true);
    EXPECT_THAT(missedLight(packScene(read("Integrator \"bdpt\"\nWorldBegin\n" + point + glass), diagnostics)),
                ElementsAre(HasSubstr("where they are seen by way of smooth ones, too")));
    /* Where they merge, nothing */
    for (const char* name : {"sppm", "vcm"})
        EXPECT_THAT(missedLight(packScene(read("Integrator \"" + std::string(name) + "\"\nWorldBegin\n" + point + glass), diagnostics)),
                    IsEmpty());
}

// Those that pbrt-v4 has and Eikonal has not are rendered as another one, and that is said once; with --strict it is an error.
TEST_F(Pack, IntegratorsThatAreNotRenderedAreNamedOnce) {
    for (const auto& [name, instead] : {std::pair("mlt", "\"vcm\" is used instead, which converges to the same image"),
                                       {"lightpath", "\"bdpt\" is used instead, which converges to the same image"},
                                       {"function", "\"volpath\" is used instead, which renders the scene, not the function"}}) {
        Scene scene = read("Integrator \"" + std::string(name) + "\"\nWorldBegin\nShape \"sphere\"");
        Diagnostics lax(LogLevel::silent), strict(LogLevel::silent, true);
        packScene(scene, lax);
        EXPECT_THAT(lax.warnings(), ElementsAre(AllOf(HasSubstr("test.pbrt:1:1: warning: integrator \"" + std::string(name) + "\""),
                                                      HasSubstr(instead))))
            << name;
        EXPECT_THROW(packScene(scene, strict), SceneError) << name;
    }
    Diagnostics hard(LogLevel::silent);
    packScene(read("Integrator \"lightpath\"\nWorldBegin\nLightSource \"point\" Material \"dielectric\" Shape \"sphere\""), hard);
    EXPECT_THAT(hard.warnings(), ElementsAre(HasSubstr("is missing")));

    /* What "bdpt" cannot do yet is said, too */
    const std::string smoke = "MakeNamedMedium \"m\" \"string type\" \"homogeneous\"\nMediumInterface \"\" \"m\"\n";
    for (const auto& [head, world, why] :
         {std::tuple("Integrator \"bdpt\" Option \"forcediffuse\" true", smoke + "Shape \"sphere\"", "participating media"),
          {"Integrator \"bdpt\"", smoke + "Translate 0 0 5 Shape \"sphere\"", "test.pbrt:5:17 has medium \"m\" on its side towards"},
          {"Integrator \"bdpt\" PixelFilter \"box\" \"float xradius\" .05", "Shape \"sphere\"", "its filter is so narrow"},
          {"Integrator \"bdpt\" Film \"spectral\"", "Shape \"sphere\"", "keeps spectra"},
          {"Integrator \"bdpt\" \"bool regularize\" true", "Shape \"sphere\"", "regularizes"}}) {
        Diagnostics diagnostics(LogLevel::silent);
        EXPECT_FALSE(packScene(read(std::string(head) + "\nWorldBegin\n" + world), diagnostics).features.has(Feature::LIGHT_PATHS)) << why;
        EXPECT_THAT(diagnostics.warnings(), ElementsAre(AllOf(HasSubstr("test.pbrt:1:1"), HasSubstr(why)))) << why;
    }
}

// Light paths end at subsurface bodies: they are not traced for what such a body sends on, and what it sends on is still missed with them.
TEST_F(Pack, LightPathsAreNotForWhatBodiesSendOn) {
    const std::string lit = "\nWorldBegin LightSource \"point\" ", body = "Material \"subsurface\" Shape \"sphere\" ",
                      glass = "Material \"dielectric\" Shape \"sphere\"";
    const auto packed = [&](const std::string& integrator, const std::string& world) {
        Diagnostics diagnostics(LogLevel::silent);
        return packScene(read("Integrator \"" + integrator + "\"" + lit + world), diagnostics);
    };
    EXPECT_FALSE(packed("auto", body).features.has(Feature::LIGHT_PATHS));
    EXPECT_TRUE(packed("auto", body + glass).features.has(Feature::MERGING));
    EXPECT_THAT(missedLight(packed("vcm", body)), ElementsAre(HasSubstr("that light paths do not pass, first a subsurface body")));
    EXPECT_THAT(missedLight(packed("vcm", glass)), ElementsAre());
}

// A lamp without an area is named; one that has an element with an area is not.
TEST_F(Pack, LampsWithoutAreaAreNamed) {
    const std::string lamp = "AreaLightSource \"diffuse\"\n", line = "Shape \"trianglemesh\" \"point3 P\" [0 0 1  1 0 1  2 0 1  0 1 1]";
    const auto warnings = [&](const std::string& indices) {
        Diagnostics diagnostics(LogLevel::silent);
        packScene(world(lamp + line + " \"integer indices\" [" + indices + "]"), diagnostics);
        return diagnostics.warnings();
    };
    EXPECT_THAT(warnings("0 1 2"), ElementsAre(AllOf(HasSubstr("test.pbrt:3:1"), HasSubstr("has no area"))));
    EXPECT_THAT(warnings("0 1 2 0 1 3"), ElementsAre());
}

// Vertices merge at the first radius of the scene or one that is chosen; where shapes move, paths of a pass have the same time.
TEST_F(Pack, MergingPathsShareATimeWhereShapesMove) {
    const std::string head = "Integrator \"sppm\" \"float radius\" .25\nWorldBegin\nLightSource \"point\"\n", ball = "Shape \"sphere\"",
                      moving = "ActiveTransform EndTime Translate 1 0 0 ActiveTransform All ",
                      movingCamera = moving + "Camera \"perspective\" ActiveTransform EndTime Identity ActiveTransform All\n";
    Diagnostics silent(LogLevel::silent);
    const auto packed = [&](const std::string& text) { return packScene(read(text), silent); };
    const PackedScene still = packed(head + ball), moves = packed(head + moving + ball), camera = packed(movingCamera + head + ball);
    EXPECT_FLOAT_EQ(still.frame().merge_radius, static_cast<float>(.25 / still.worldScale));
    for (const PackedScene* scene : {&still, &moves, &camera}) EXPECT_TRUE(scene->features.has(Feature::MERGING));
    EXPECT_EQ(still.frame().view.times.is_shared, 0u);
    EXPECT_EQ(camera.frame().view.times.is_shared, 0u);
    EXPECT_EQ(moves.frame().view.times.is_shared, 1u);
    EXPECT_THAT(silent.warnings(), IsEmpty());
}

// Mixes of mixes that share their parts: 2^60 ways from the first to the last.
TEST_F(Pack, EachPartOfAMixIsLookedAtOnce) {
    for (const char* kind : {"subsurface", "diffuse"}) {
        std::string text = fmt::format("MakeNamedMaterial \"m0\" \"string type\" \"{}\"\n", kind);
        for (int i = 1; i <= 60; ++i)
            text += fmt::format("MakeNamedMaterial \"m{0}\" \"string type\" \"mix\" \"string materials\" "
                                "[\"m{1}\" \"m{1}\"] \"float amount\" .{0:02}\n",
                                i, i - 1);
        Diagnostics silent(LogLevel::silent);
        const std::string head = "Integrator \"bdpt\"\nWorldBegin\nLightSource \"point\"\n";
        const PackedScene scene = packScene(read(head + text + "NamedMaterial \"m60\" Shape \"sphere\""), silent);
        EXPECT_EQ((scene.tables.shapes.front().flags & shape_is_entered) != 0, kind == std::string("subsurface"));
    }
}

// Light paths begin at a lamp in a medium where all of it is in the same one.
TEST_F(Pack, LightPathsBeginWhereTheMediumIsKnown) {
    const std::string head = "Integrator \"bdpt\"\nLookAt 0 0 -5  0 0 0  0 1 0 Camera \"perspective\"\nWorldBegin\n"
                             "MakeNamedMedium \"m\" \"string type\" \"homogeneous\"\nAttributeBegin MediumInterface \"m\" \"\" "
                             "Material \"interface\" Shape \"sphere\" AttributeEnd\n";
    const auto packed = [&](const std::string& lamp) {
        Diagnostics diagnostics(LogLevel::silent);
        const PackedScene scene = packScene(read(head + "AreaLightSource \"diffuse\" " + lamp), diagnostics);
        EXPECT_TRUE(scene.features.has(Feature::LIGHT_PATHS));
        const bool begin = scene.frame().emission_count > 0;
        EXPECT_EQ(begin, diagnostics.warnings().empty());
        return begin ? std::optional(scene.tables.lights.front().medium) : std::nullopt;
    };
    EXPECT_EQ(packed("Shape \"sphere\" \"float radius\" .1"), 0u);
    EXPECT_EQ(packed("Translate 3 0 0 Shape \"sphere\" \"float radius\" .1"), NONE);
    EXPECT_EQ(packed("ReverseOrientation Shape \"sphere\" \"float radius\" 20"), NONE) << "around all";
    EXPECT_EQ(packed("Translate .9 0 0 Shape \"disk\" \"float radius\" .5"), std::nullopt) << "half in it";
    EXPECT_EQ(packed("Translate 3 0 0 MediumInterface \"\" \"m\" Shape \"disk\""), std::nullopt) << "its shape says what is not so";
}

// Light comes in through the side of a portal from which its corners run clockwise; where camera and scene are on that side, it is said.
TEST_F(Pack, APortalThatFacesAwayIsSaid) {
    const auto warningsOf = [&](const std::string& camera, const std::string& corners) {
        Diagnostics diagnostics(LogLevel::silent);
        packScene(read(camera + "Camera \"perspective\" WorldBegin Shape \"sphere\"\nLightSource \"infinite\" \"point3 portal\" [" +
                       corners + "]"),
                  diagnostics);
        return diagnostics.warnings();
    };
    const std::string right = "-1 -1 2  -1 1 2  1 1 2  1 -1 2", wrong = "-1 -1 2  1 -1 2  1 1 2  -1 1 2";
    EXPECT_THAT(warningsOf("", right), IsEmpty());
    EXPECT_THAT(warningsOf("", wrong), ElementsAre(AllOf(HasSubstr("test.pbrt:2:1: warning: the portal"), HasSubstr("reverse order"))));
    EXPECT_THAT(warningsOf("LookAt 0 0 9  0 0 0  0 1 0\n", wrong), IsEmpty()) << "the camera sees what is lit";
}

// Six bodies in one another are what a path can remember.
TEST_F(Pack, BodiesTooDeepInOneAnotherAreSaid) {
    const auto warningsOf = [&](int count, double apart) {
        std::string text = "LightSource \"infinite\" Material \"subsurface\" \"string method\" \"randomwalk\"\n";
        for (int k = 0; k < count; ++k)
            text += fmt::format("AttributeBegin Translate {} 0 0 Shape \"sphere\" \"float radius\" {} AttributeEnd\n", k * apart, 10 - k);
        Diagnostics diagnostics(LogLevel::silent);
        packScene(world(text), diagnostics);
        return diagnostics.warnings();
    };
    EXPECT_THAT(warningsOf(6, 0), IsEmpty());
    EXPECT_THAT(warningsOf(7, 0), ElementsAre(HasSubstr("7 bodies of material \"subsurface\" lie in one another")));
    EXPECT_THAT(warningsOf(9, 21), IsEmpty()) << "side by side";
}

// A scene without light is black, and says so; not where nothing needs a light, and not where a medium shines by itself.
TEST_F(Pack, DarknessIsSaid) {
    const auto warningsOf = [&](const std::string& text) {
        Diagnostics diagnostics(LogLevel::silent);
        const Scene scene = read(text);
        warnOfDarkness(scene, packScene(scene, diagnostics), diagnostics);
        return diagnostics.warnings();
    };
    const auto dark = ElementsAre("warning: the scene has no light: the image will be black");
    const std::string fog = "MakeNamedMedium \"m\" \"string type\" \"homogeneous\" \"rgb Le\" [1 1 1] \"float Lescale\" ";
    const std::string filled = " MediumInterface \"m\" \"\" Shape \"sphere\"";
    EXPECT_THAT(warningsOf("WorldBegin\n"), dark);
    EXPECT_THAT(warningsOf("WorldBegin\nShape \"sphere\""), dark);
    EXPECT_THAT(warningsOf("WorldBegin\n" + fog + "0" + filled), dark);
    EXPECT_THAT(warningsOf("WorldBegin\n" + fog + "2" + filled), IsEmpty());
    EXPECT_THAT(warningsOf("WorldBegin\n" + fog + "2 Shape \"sphere\""), dark);
    EXPECT_THAT(warningsOf("Integrator \"ambientocclusion\"\nWorldBegin\nShape \"sphere\""), IsEmpty());

    const auto inside = [&](const std::string& sigma, const std::string& light) {
        return warningsOf("MakeNamedMedium \"m\" \"string type\" \"homogeneous\" \"rgb sigma_a\" " + sigma + " \"rgb sigma_s\" [0 0 0]\n" +
                          "MediumInterface \"\" \"m\" Camera \"perspective\" WorldBegin " + light);
    };
    EXPECT_THAT(inside("[.1 0 0]", "LightSource \"infinite\""), ElementsAre(HasSubstr("into medium \"m\", which has no end")));
    EXPECT_THAT(inside("[.1 0 0]", "LightSource \"distant\""), IsEmpty());
    EXPECT_THAT(inside("[0 0 0]", "LightSource \"infinite\""), IsEmpty());
    EXPECT_THAT(inside("[.1 0 0]", "LightSource \"infinite\" MediumInterface \"m\" \"\" Shape \"sphere\" \"float radius\" 9"), IsEmpty());
    EXPECT_THAT(warningsOf("WorldBegin\nAreaLightSource \"diffuse\" Shape \"sphere\""), IsEmpty());
}

// What asks for a feature has a place and a name, or is said in words.
TEST_F(Pack, MaterialsAreNamedAsPeopleKnowThem) {
    const auto whyDiffuse = [&](const std::string& text) { return pack(text).reasons.at(KindFeature::BSDF_DIFFUSE); };
    EXPECT_EQ(whyDiffuse("Shape \"sphere\""), "the material of shapes without one");
    EXPECT_EQ(whyDiffuse("Material \"diffuse\" Shape \"sphere\""), "test.pbrt:2:1: a material");
    EXPECT_EQ(whyDiffuse("MakeNamedMaterial \"m\" \"string type\" \"diffuse\" NamedMaterial \"m\" Shape \"sphere\""),
              "test.pbrt:2:1: material \"m\"");
}

// Integrators that render media do so without a word; the others say what they leave out, where there is something.
TEST_F(Pack, IntegratorsWithoutMediaSayWhatTheyLeaveOut) {
    const std::string smoke = "MakeNamedMedium \"m\" \"string type\" \"homogeneous\" MediumInterface \"m\" \"\" Shape \"sphere\"";
    for (const IntegratorKind* kind : integratorKindList()) {
        const char* const name = kind->name;
        const std::string head = "Integrator \"" + std::string(name) + "\"\nWorldBegin\n";
        Diagnostics empty(LogLevel::silent), smoky(LogLevel::silent);
        packScene(read(head + "Shape \"sphere\""), empty);
        EXPECT_THAT(empty.warnings(), IsEmpty()) << name;
        const bool rendersMedia = packScene(read(head + smoke), smoky).features.has(Feature::MEDIA);
        const bool startsAtLights = kind == &bdpt_integrator || kind == &sppm_integrator || kind == &vcm_integrator;
        EXPECT_EQ(rendersMedia, kind == &volpath_integrator || startsAtLights || kind == &auto_integrator) << name;
        if (rendersMedia) EXPECT_THAT(smoky.warnings(), IsEmpty()) << name;
        else EXPECT_THAT(smoky.warnings(), ElementsAre(AllOf(HasSubstr("test.pbrt:1:1"), HasSubstr("media")))) << name;
    }
}

// What does not sample lights finds them by chance, weighs that against nothing, and never meets a point.
TEST_F(Pack, IntegratorsThatSampleNoLightsHaveNone) {
    const std::string lights = "\nWorldBegin\nLightSource \"infinite\" LightSource \"point\"\nAreaLightSource \"diffuse\" Shape \"sphere\"";
    Diagnostics diagnostics(LogLevel::silent, true);
    for (const char* integrator : {"\"randomwalk\"", "\"simplepath\" \"bool samplelights\" false"}) {
        const PackedScene scene = packScene(read("Integrator " + std::string(integrator) + lights), diagnostics);
        EXPECT_FALSE(scene.features.has(Feature::LIGHTS)) << integrator;
        ASSERT_EQ(scene.tables.lights.size(), 3u) << integrator;
        for (const light& l : scene.tables.lights) EXPECT_EQ(l.pmf, 0) << integrator;
    }
    EXPECT_TRUE(packScene(read("Integrator \"simplepath\"" + lights), diagnostics).features.has(Feature::LIGHTS));
}

// Pixels that share a sequence take as many of its points as they have samples, rounded up to a power of two, and points are numbered in 32
// bits.
TEST_F(Pack, PixelsShareASequenceForBlueNoise) {
    const auto frameOf = [&](const std::string& sampler) {
        Diagnostics diagnostics(LogLevel::silent, true);
        const PackedScene scene = packScene(read("Sampler " + sampler + "\nWorldBegin\nShape \"sphere\""), diagnostics);
        EXPECT_EQ(scene.features.has(Feature::SOBOL), sampler.find("independent") == std::string::npos) << sampler;
        EXPECT_EQ(scene.features.has(Feature::JOINT_PAIRS),
                  scene.features.has(Feature::SOBOL) && sampler.find("padded") == std::string::npos)
            << sampler;
        return std::pair(scene.frame().sequence_sample_bits, scene.frame().sequence_tile_bits);
    };
    EXPECT_EQ(frameOf("\"independent\" \"integer pixelsamples\" 64"), std::pair(0u, 0u));
    EXPECT_EQ(frameOf("\"sobol\" \"integer pixelsamples\" 64"), std::pair(0u, 0u));
    EXPECT_EQ(frameOf("\"paddedsobol\" \"integer pixelsamples\" 64"), std::pair(0u, 0u));
    EXPECT_EQ(frameOf("\"zsobol\" \"integer pixelsamples\" 1"), std::pair(0u, 8u));
    EXPECT_EQ(frameOf("\"zsobol\" \"integer pixelsamples\" 64"), std::pair(6u, 8u));
    EXPECT_EQ(frameOf("\"zsobol\" \"integer pixelsamples\" 65"), std::pair(7u, 8u));
    EXPECT_EQ(frameOf("\"zsobol\" \"integer pixelsamples\" 1000000"), std::pair(20u, 6u));
}

// A sky that is the same everywhere is sampled by no light sampler where paths follow BSDFs: all samples go to the lamps, and without lamps
// there are none.
TEST_F(Pack, PathsFindAnEvenSkyByThemselves) {
    const std::string sky =
                          "\nFilm \"rgb\" \"integer xresolution\" 16 \"integer yresolution\" 16\nWorldBegin\nLightSource \"infinite\" "
                          "\"rgb L\" [1 2 3]\n",
                      lamp = "LightSource \"point\"\nShape \"sphere\"";
    Diagnostics diagnostics(LogLevel::silent, true);
    for (const char* integrator : {"\"path\"", "\"volpath\"", "\"volpath\" \"string lightsampler\" \"bvh\"",
                                   "\"volpath\" \"string lightsampler\" \"uniform\"", "\"direct\"", "\"simplepath\""}) {
        const PackedScene alone = packScene(read("Integrator " + std::string(integrator) + sky + "Shape \"sphere\""), diagnostics);
        EXPECT_FALSE(alone.features.has(Feature::LIGHTS)) << integrator;
        EXPECT_EQ(alone.constants.environments, 1) << integrator;
        const PackedScene both = packScene(read("Integrator " + std::string(integrator) + sky + lamp), diagnostics);
        ASSERT_EQ(both.tables.lights.size(), 2u) << integrator;
        for (const light& l : both.tables.lights) EXPECT_EQ(l.pmf, l.kind == kind_point_light ? 1 : 0) << integrator;
        EXPECT_EQ(both.frame().infinite_count, 0u) << integrator;
    }
    for (const char* integrator : {"\"whitted\"", "\"simplepath\" \"bool samplebsdf\" false"}) {
        const PackedScene both = packScene(read("Integrator " + std::string(integrator) + sky + lamp), diagnostics);
        for (const light& l : both.tables.lights) EXPECT_GT(l.pmf, 0) << integrator;
    }
}

// Where a render is long enough to learn where the sky is seen, there is room for what is learnt; until then nothing aims at the sky.
TEST_F(Pack, ALongRenderHasAnEnvironmentGuide) {
    const auto withSamples = [&](const std::string& integrator, int samples) {
        Diagnostics diagnostics(LogLevel::silent, true);
        return packScene(
            read("Integrator " + integrator +
                 "\nFilm \"rgb\" \"integer xresolution\" 256 \"integer yresolution\" 256\nSampler \"sobol\" \"integer pixelsamples\" " +
                 std::to_string(samples) + "\nWorldBegin\nLightSource \"infinite\"\nShape \"sphere\""),
            diagnostics);
    };
    const PackedScene guided = withSamples("\"volpath\"", 64);
    EXPECT_TRUE(guided.features.has(Feature::ENVIRONMENT_GUIDE) && guided.features.has(Feature::LIGHTS));
    EXPECT_EQ(guided.tables.lights.at(0).pmf, 0);
    EXPECT_EQ(guided.tables.light_aliases.size(), 1u);
    EXPECT_EQ(guided.tables.guide_sums.size(), size_t{GUIDE_MAP_WORDS});
    EXPECT_FALSE(withSamples("\"volpath\"", 1).features.has(Feature::ENVIRONMENT_GUIDE));
    for (const char* other : {"\"whitted\"", "\"randomwalk\"", "\"simplepath\" \"bool samplelights\" false", "\"ambientocclusion\"",
                              "\"volpath\" \"string lightsampler\" \"bvh\""})
        EXPECT_EQ(withSamples(other, 64).features.has(Feature::ENVIRONMENT_GUIDE), std::string(other).find("bvh") != std::string::npos)
            << other;
}

// A tree looks at all lights, but of many at one.
TEST_F(Pack, TreesLookAtAllOfAFewLights) {
    Diagnostics diagnostics(LogLevel::silent, true);
    const auto withLights = [&](int count) {
        std::string text = "Integrator \"whitted\"\nWorldBegin\nShape \"sphere\"\n";
        for (int i = 0; i < count; ++i) text += "LightSource \"point\"\n";
        return packScene(read(text), diagnostics);
    };
    const PackedScene few = withLights(MOST_TREE_LIGHTS), many = withLights(MOST_TREE_LIGHTS + 1);
    EXPECT_EQ(few.tables.frame.front().tree_lights, static_cast<uint>(MOST_TREE_LIGHTS));
    EXPECT_EQ(few.tables.lights.front().pmf, 1);
    EXPECT_EQ(many.tables.frame.front().tree_lights, 0u);
    EXPECT_TRUE(many.features.has(Feature::LIGHT_TREE));   /* of so many, one is chosen */
    EXPECT_FALSE(few.features.has(Feature::LIGHT_TREE));
}

// What an integrator does not look at is not packed: no kernel is built for it.
TEST_F(Pack, AmbientOcclusionNeedsNoMaterialsAndNoLights) {
    Diagnostics diagnostics(LogLevel::silent, true);
    const PackedScene scene = packScene(read("Integrator \"ambientocclusion\"\nWorldBegin\nLightSource \"infinite\" LightSource \"point\"\n"
                                             "AreaLightSource \"diffuse\" Material \"conductor\" Shape \"sphere\""), diagnostics);
    EXPECT_TRUE(scene.tables.lights.empty() && scene.tables.material_inputs.empty());
    EXPECT_EQ(scene.constants.environments, 0);
    for (const Feature f : {Feature::LIGHTS, Feature::EMITTERS, KindFeature::BSDF_CONDUCTOR, KindFeature::LIGHT_POINT})
        EXPECT_FALSE(scene.features.has(f)) << featureName(f);
}

// The reflectance of a measured file is the colour of its spectra under daylight: that of white paper, which reflects the same everywhere,
// and of what reflects only long wavelengths.
TEST_F(Pack, MeasuredSpectraBecomeColors) {
    const auto color = [&](const MeasuredFile& file) {
        file.write(path("a.bsdf"));
        const PackedScene scene = pack("Material \"measured\" \"string filename\" \"a.bsdf\" Shape \"sphere\"");
        const measured_grid grid = scene.tables.measured_files.at(0).color;
        const auto at = [&](uint channel) { return scene.tables.measured_values.at(grid.first + channel * grid.width * grid.height); };
        return glm::dvec3(at(0), at(1), at(2));
    };
    MeasuredFile file;
    expectNear(color(file), glm::dvec3(0.5), 1e-4);
    file.reflectance = [](double nm) { return nm > 600 ? 0.8 : 0.; };
    const glm::dvec3 red = color(file);
    EXPECT_GT(red.x, 0.3);   // the file has a value every 47 nm: a ramp from 595 nm to 642 nm
    EXPECT_LT(red.y, 0.1);
    EXPECT_LT(red.z, 0.1);
}

// Kernels search the longest of all files' lists: 31 intervals between 32 facets take five halves, four of brightness two, eight of
// azimuths or six of polar angles three. Only files with more than one azimuth have a grain.
TEST_F(Pack, MeasuredFilesSetTheStepsOfSearches) {
    MeasuredFile file;
    file.write(path("smooth.bsdf"));
    file.isotropic = false;
    file.write(path("brushed.bsdf"));
    const auto use = [](const std::string& name) {
        return "Material \"measured\" \"string filename\" \"" + name + ".bsdf\" Shape \"sphere\"\n";
    };
    const PackedScene one = pack(use("smooth") + use("smooth")), both = pack(use("brushed") + use("smooth"));
    EXPECT_EQ(one.constants.measuredFiles, 1);
    EXPECT_EQ(both.constants.measuredFiles, 2);
    EXPECT_FALSE(one.features.has(Feature::GRAIN));
    EXPECT_TRUE(both.features.has(Feature::GRAIN));
    for (const SceneConstants& c : {one.constants, both.constants}) {
        EXPECT_EQ(c.measuredAngleSteps, 3);
        EXPECT_EQ(c.measuredFacetSteps, 5);
        EXPECT_EQ(c.measuredBrightnessSteps, 2);
        EXPECT_EQ(SceneConstants::fromText(c.text()).text(), c.text());
    }
}

TEST_F(Pack, ABrokenMeasuredFileIsNamed) {
    write("a.bsdf", "nothing of the kind");
    try {
        pack("Material \"measured\" \"string filename\" \"a.bsdf\" Shape \"sphere\"");
        FAIL() << "the file was accepted";
    } catch (const SceneError& error) {
        EXPECT_THAT(error.what(), AllOf(HasSubstr("test.pbrt:2:21: "), HasSubstr("a.bsdf\" is not a tensor file")));
    }
}

}  // namespace
}  // namespace eikonal
