// What stands between a light and the eye: holes, panes and mixes.

#include "lit_floor.h"

#include <fmt/format.h>

namespace eikonal {
namespace {

const std::string brightWall =
    "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [4 4 4] Material \"diffuse\" \"rgb reflectance\" [0 0 0]\n"
    "Shape \"trianglemesh\" \"point3 P\" [-50 -50 5  -50 50 5  50 50 5  50 -50 5] \"integer indices\" [0 1 2 0 2 3] AttributeEnd\n";
const std::string card = "Shape \"trianglemesh\" \"point3 P\" [-9 -9 Z  9 -9 Z  9 9 Z  -9 9 Z] \"integer indices\" [0 1 2 0 2 3]\n";
std::string cardAt(double z, const std::string& material, const std::string& more = "") {
    std::string text = card;
    for (size_t at; (at = text.find('Z')) != std::string::npos;) text.replace(at, 1, fmt::format("{}", z));
    text.pop_back();
    return "AttributeBegin Material " + material + "\n" + text + " " + more + " AttributeEnd\n";
}
Rendered throughCards(const std::string& cards, int maxDepth = 100) {
    View view;
    view.maxDepth = maxDepth;
    return render(sceneText(view, brightWall + cards), surfaces());
}

// Black paper with half of it (at random) not there, twice: a quarter of the wall is seen.
TEST(Light, HalfOfAlphaIsHalfOfTheLight) {
    const std::string black = "\"diffuse\" \"rgb reflectance\" [0 0 0]";
    expectRadiance(throughCards(cardAt(0, black, "\"float alpha\" .5")), Le / 2);
    expectRadiance(throughCards(cardAt(0, black, "\"float alpha\" .5") + cardAt(1, black, "\"float alpha\" .5")), Le / 4, 0.02);
}

// Shadow rays see the same holes.
TEST(Light, AlphaLetsShadowRaysPass) {
    expectRadiance(onTheFloor("LightSource \"point\" \"rgb I\" [3 3 3] \"point3 from\" [0 2 0]\nAttributeBegin Material \"diffuse\" "
                              "Translate 0 1.5 0 Rotate 90 1 0 0 "
                              "Shape \"disk\" \"float radius\" .2 \"float alpha\" .25 AttributeEnd"),
                   rho / pi * 3. / 4 * 0.75);
}

// The pattern of an object's alpha moves with its instances, also where it depends on the point. Unit cells, opaque and not, the middle one
// at the origin: as it is, the card is seen there, one cell to the side it is not.
TEST(Light, AlphaMovesWithItsObject) {
    const std::string texture = "AttributeBegin Translate -.5 -.5 0 Texture \"cells\" \"float\" \"checkerboard\" \"integer dimension\" 3 "
                                "\"float tex1\" 1 \"float tex2\" 0 AttributeEnd Material \"diffuse\" \"rgb reflectance\" [0 0 0]\n",
                      square = "Shape \"bilinearmesh\" \"point3 P\" [-3 -2 .5  2 -2 .5  -3 2 .5  2 2 .5] \"texture alpha\" \"cells\"\n",
                      object = texture + "ObjectBegin \"card\" " + square + "ObjectEnd\n",
                      elsewhere = "AttributeBegin Translate 0 30 0 Scale 2 1 1 ObjectInstance \"card\" AttributeEnd\n";
    for (const auto& [cells, expected] : {std::pair{0, 0.}, {1, Le}, {2, 0.}}) {
        const std::string aside = fmt::format("Translate {} 0 0 ", cells), at = aside + "ObjectInstance \"card\"\n",
                          moving = "ActiveTransform EndTime Translate 0 0 .01 ActiveTransform All ";
        for (const std::string& cards : {object + at, object + elsewhere + at, texture + aside + moving + square})
            expectRadiance(throughCards(cards), expected);
    }
}

// So does an alpha that depends on the direction of the surface: it follows the object as it was defined, however often it is placed. The
// cosine of the card and the direction is .8.
TEST(Light, AlphaByDirectionFollowsItsObject) {
    const std::string object = R"(Texture "turn" "float" "directionmix" "float tex1" 1 "float tex2" .25 "vector3 dir" [0 .6 .8]
        Material "diffuse" "rgb reflectance" [0 0 0]
        ObjectBegin "card" Shape "bilinearmesh" "point3 P" [-3 -2 .5  2 -2 .5  -3 2 .5  2 2 .5] "texture alpha" "turn" ObjectEnd
        AttributeBegin Rotate 60 1 0 0 Scale 1 2 1 ObjectInstance "card" AttributeEnd
        )",
                      again = "AttributeBegin Translate 0 30 0 ObjectInstance \"card\" AttributeEnd\n";
    const double alpha = .8 * 1 + .2 * .25;
    for (const std::string& cards : {object, object + again}) expectRadiance(throughCards(cards), Le * (1 - alpha), 0.02);
}

// Shadow rays pass as many null interfaces as paths do.
TEST(Light, ShadowRaysPassHundredsOfInterfaces) {
    std::string sheets = "MakeNamedMedium \"air\" \"string type\" \"homogeneous\" \"rgb sigma_a\" [1e-6 1e-6 1e-6] "
                         "\"rgb sigma_s\" [0 0 0]\nMediumInterface \"air\" \"\" Material \"interface\" "
                         "Shape \"trianglemesh\" \"point3 P\" [",
                indices;
    for (int i = 0; i < 600; ++i) {
        for (const char* corner : {"-9 {0} -9 ", "9 {0} -9 ", "0 {0} 9 "}) sheets += fmt::format(fmt::runtime(corner), 1 + i * .001);
        indices += fmt::format("{} {} {} ", 3 * i, 3 * i + 1, 3 * i + 2);
    }
    View view = atTheOrigin();
    view.lookAt = "0 .5 -1  0 0 0  0 1 0";
    const std::string light = "LightSource \"point\" \"rgb I\" [3 3 3] \"point3 from\" [0 2 0]\n" + floorShape;
    expectRadiance(render(sceneText(view, light + sheets + "] \"integer indices\" [" + indices + "]\n"), media()), rho / pi * 3. / 4);
}

// Glass is in the way of light samples, as in pbrt-v4: a point behind it lights nothing; a lamp only by the rays that find it through the
// pane.
TEST(Light, GlassBlocksLightSamples) {
    const std::string pane =
        "AttributeBegin Material \"thindielectric\" \"float eta\" 1.5 Translate 0 1.5 0 Rotate 90 1 0 0 Shape \"disk\" \"float radius\" .2 "
        "AttributeEnd\n";
    expectRadiance(onTheFloor("LightSource \"point\" \"rgb I\" [3 3 3] \"point3 from\" [0 2 0]\n" + pane), 0);
    /* Straight above and small, through both of its sides: (1 - R) / (1 + R); at a depth of two */
    expectRadiance(render(sceneText(atTheOrigin(2), pane + emitter("Translate 0 2 0 Rotate 90 1 0 0 Shape \"disk\" \"float radius\" .2") +
                                                        "\n" + floorShape),
                          surfaces()),
                   rho * Le * .04 / (.04 + 4) * .96 / 1.04, 0.06);
}

// Straight on, a boundary reflects R = ((eta - 1) / (eta + 1))^2 = 0.04 for eta = 1.5; between two of them light goes to and fro, so that
// (1 - R)^2 (1 + R^2 + R^4 + ...) = (1 - R) / (1 + R) gets through. One thin sheet is the same as a slab of two boundaries.
TEST(Light, APaneTransmitsWhatTwoBoundariesDo) {
    const double R = 0.04, T = (1 - R) / (1 + R);
    expectRadiance(throughCards(cardAt(0, "\"thindielectric\" \"float eta\" 1.5")), Le * T);
    expectRadiance(throughCards("AttributeBegin Material \"dielectric\" \"float eta\" 1.5 Scale 9 9 .5 Shape \"trianglemesh\" \"integer "
                                "indices\" [0 1 2 0 2 3 4 6 5 4 7 6] "
                                "\"point3 P\" [-1 -1 -1  -1 1 -1  1 1 -1  1 -1 -1  -1 -1 1  -1 1 1  1 1 1  1 -1 1] AttributeEnd"),
                   Le * T);
}

// Null interfaces do not count as bounces, but a ray that crosses more than a thousand is terminated: between two touching surfaces it
// could cross them endlessly.
TEST(Light, AThousandInterfacesArePassed) {
    const auto pile = [](int count) {
        std::string points, indices;
        for (int i = 0; i < count; ++i) {
            const double z = i / 250.;
            points += fmt::format("-9 -9 {0} 9 -9 {0} 9 9 {0} -9 9 {0} ", z);
            indices += fmt::format("{} {} {} {} {} {} ", 4 * i, 4 * i + 1, 4 * i + 2, 4 * i, 4 * i + 2, 4 * i + 3);
        }
        return "AttributeBegin Material \"interface\" Shape \"trianglemesh\" \"point3 P\" [" + points + "] \"integer indices\" [" +
               indices + "] AttributeEnd\n";
    };
    /* Without a medium anywhere there are no interfaces */
    const std::string fog = "MakeNamedMedium \"fog\" \"string type\" \"homogeneous\"\n"
        "AttributeBegin Material \"interface\" MediumInterface \"fog\" \"\" Translate 0 20 0 Shape \"sphere\" AttributeEnd\n";
    const auto through = [&](int count) { return render(sceneText(View{.maxDepth = 1}, brightWall + fog + pile(count)), media()); };
    expectRadiance(through(1000), Le);
    expectRadiance(through(1100), 0);
}

// A mix is each of its materials as often as it says: under a sky, the mean of what they reflect.
TEST(Light, AMixReflectsTheMean) {
    View view;
    view.maxDepth = 1;
    expectRadiance(render(sceneText(view, R"(LightSource "infinite" "rgb L" [1 1 1]
        MakeNamedMaterial "dark" "string type" "diffuse" "rgb reflectance" [.2 .2 .2]
        MakeNamedMaterial "bright" "string type" "diffuse" "rgb reflectance" [.8 .8 .8]
        Material "mix" "string materials" ["dark" "bright"] "float amount" .25 Shape "sphere")"), surfaces()), 0.75 * 0.2 + 0.25 * 0.8);
}

}  // namespace
}  // namespace eikonal
