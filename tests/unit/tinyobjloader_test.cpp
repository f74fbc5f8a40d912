// Why the OBJ reader is our own (docs/obj.md): what tinyobjloader makes of small files, in double precision and without its triangulation,
// when its functions have succeeded without a warning unless a test says otherwise. A test that fails here is a reason that has gone.

#include "read/mesh/polygon.h"
#include "read/obj/geometry.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#define TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#include <array>
#include <charconv>
#include <cmath>
#include <ctime>
#include <iostream>
#include <map>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace eikonal {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

struct Loaded {
    bool succeeds = false;
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warning, error;

    std::vector<int> positions() const { return indices(&tinyobj::index_t::vertex_index); }
    std::vector<int> normals() const { return indices(&tinyobj::index_t::normal_index); }

private:
    std::vector<int> indices(int tinyobj::index_t::*member) const {
        std::vector<int> result;
        for (const tinyobj::shape_t& shape : shapes)
            for (const tinyobj::index_t& index : shape.mesh.indices) result.push_back(index.*member);
        return result;
    }
};

Loaded loadMtl(const std::string& text) {
    Loaded loaded;
    std::map<std::string, int> names;
    std::istringstream stream(text);
    tinyobj::LoadMtl(&names, &loaded.materials, &stream, &loaded.warning, &loaded.error);
    EXPECT_THAT(loaded.warning + loaded.error, IsEmpty());
    return loaded;
}

/// Every library has one material, of the library's name without ".mtl".
class Libraries : public tinyobj::MaterialReader {
    bool operator()(const std::string& file, std::vector<tinyobj::material_t>* materials, std::map<std::string, int>* names,
                    std::string* warning, std::string* error) override {
        std::istringstream stream("newmtl " + file.substr(0, file.find(".mtl")) + "\n");
        tinyobj::LoadMtl(names, materials, &stream, warning, error);
        return true;
    }
};

Loaded load(const std::string& text) {
    Loaded loaded;
    std::istringstream stream(text);
    Libraries libraries;
    constexpr bool triangulate = false;
    loaded.succeeds = tinyobj::LoadObj(&loaded.attributes, &loaded.shapes, &loaded.materials, &loaded.warning, &loaded.error, &stream,
                                       &libraries, triangulate);
    return loaded;
}

Loaded loadInSilence(const std::string& text) {
    Loaded loaded = load(text);
    EXPECT_TRUE(loaded.succeeds) << text;
    EXPECT_THAT(loaded.warning + loaded.error, IsEmpty()) << text;
    return loaded;
}

std::string diffuseOf(const std::string& mtl) {
    const tinyobj::material_t material = loadMtl(mtl).materials.back();
    std::ostringstream text;
    text << material.diffuse[0] << ' ' << material.diffuse[1] << ' ' << material.diffuse[2];
    return text.str();
}

// ---- geometry ---------------------------------------------------------------------------------------------------------------

TEST(TinyObjLoader, takesWhatIsNoNumberForOne) {
    EXPECT_THAT(loadInSilence("v 1,5 abc nan\n").attributes.vertices, ElementsAre(1, 0, 0));
    EXPECT_THAT(loadInSilence("v 1 2").attributes.vertices, ElementsAre(1, 2, 0));            // cut off
    EXPECT_THAT(loadInSilence("v 1 2 \\\n3\n").attributes.vertices, ElementsAre(1, 2, 0));    // goes on in the next line
    EXPECT_TRUE(std::isinf(loadInSilence("v 1e999 0 0\n").attributes.vertices[0]));
}

TEST(TinyObjLoader, takesWhatIsNoIndexForOne) {
    EXPECT_THAT(loadInSilence(square + "f 1x 2.9 3,4\n").positions(), ElementsAre(0, 1, 2));
    EXPECT_THAT(loadInSilence(square + "f 4294967297 2 3\n").positions(), ElementsAre(0, 1, 2));
    EXPECT_THAT(loadInSilence(square + "f -5 -3 -2\n").positions(), ElementsAre(-1, 1, 2));   // before the first: -1 means "none"
    EXPECT_THAT(loadInSilence(square + "f -9 -3 -2\n").positions(), ElementsAre(-5, 1, 2));
}

// The line it names is the last of the file.
TEST(TinyObjLoader, doesNotSayWhereAnIndexIsTooLarge) {
    const Loaded loaded = load(square + "f 1 2 5\n# 6\n# 7\n");
    EXPECT_TRUE(loaded.succeeds);
    EXPECT_THAT(loaded.warning, HasSubstr("Vertex indices out of bounds (line 7.)"));
    EXPECT_THAT(loaded.positions(), ElementsAre(0, 1, 4));
}

// "1// 2// 3//" has no normals: the second position is taken for the first corner's.
TEST(TinyObjLoader, takesTheNextCornerForANormal) {
    const Loaded loaded = load(square + "vn 0 0 1\nf 1// 2// 3//1\n");
    EXPECT_TRUE(loaded.succeeds);
    EXPECT_THAT(loaded.normals(), ElementsAre(1, 2, 0));
    EXPECT_FALSE(load(square + "f 1// 2// 3//\n").succeeds);
}

// A face of 300 corners is one of 44 for the reader of num_face_vertices, which holds 8 bits.
TEST(TinyObjLoader, counts256CornersAsNone) {
    std::string text;
    for (int i = 0; i < 300; ++i) text += "v " + std::to_string(i) + " " + std::to_string(i * i) + " 0\n";
    text += "f";
    for (int i = 1; i <= 300; ++i) text += " " + std::to_string(i);
    const Loaded loaded = loadInSilence(text + "\n");
    EXPECT_THAT(loaded.shapes.at(0).mesh.num_face_vertices, ElementsAre(44));
    EXPECT_THAT(loaded.positions(), SizeIs(300));
}

TEST(TinyObjLoader, cutsNamesAndReadsOneLibraryOfSeveral) {
    EXPECT_THAT(load("mtllib dark\\ red.mtl\nusemtl dark red\n").warning, HasSubstr("material [ 'dark' ] not found"));
    const Loaded loaded = load("mtllib a.mtl b.mtl\nusemtl b\n");
    EXPECT_THAT(loaded.warning, HasSubstr("material [ 'b' ] not found"));
    EXPECT_THAT(loaded.materials, SizeIs(1));
}

// 0.3 becomes 0.30000000000000004: digits behind the point are added one by one, each rounded.
TEST(TinyObjLoader, roundsNumbersSeveralTimes) {
    EXPECT_NE(loadInSilence("v 0.3 0 0\n").attributes.vertices[0], 0.3);

    std::mt19937 random(1);
    constexpr int count = 10000;
    int wrong = 0;
    for (int i = 0; i < count; ++i) {
        const std::string digits = std::to_string(random() % 1000000), word = "0." + std::string(6 - digits.size(), '0') + digits;
        double nearest = 0;
        std::from_chars(word.data(), word.data() + word.size(), nearest);
        wrong += loadInSilence("v " + word + " 0 0\n").attributes.vertices[0] != nearest;
    }
    std::cout << "of numbers with six digits behind the point, " << 100. * wrong / count << " % are not the nearest double\n";
    EXPECT_GT(wrong, count / 4);
}

// A square on its tip: of two diagonals that are equal, rounding decides, and other triangles are other images.
TEST(TinyObjLoader, makesOtherTrianglesOfASquare) {
    const Loaded loaded = loadInSilence("v 0.2 0.2 0\nv 0.1 0.3 0\nv 0.0 0.2 0\nv 0.1 0.1 0\nf 1 2 3 4\n");
    std::vector<glm::dvec3> corners;
    for (std::size_t i = 0; i < 12; i += 3)
        corners.emplace_back(loaded.attributes.vertices[i], loaded.attributes.vertices[i + 1], loaded.attributes.vertices[i + 2]);
    std::vector<std::array<std::uint32_t, 3>> triangles, expected;
    triangulate(corners, triangles);
    triangulate(std::vector<glm::dvec3>{{.2, .2, 0}, {.1, .3, 0}, {0, .2, 0}, {.1, .1, 0}}, expected);
    EXPECT_THAT(expected, ElementsAre(ElementsAre(1, 2, 3), ElementsAre(1, 3, 0)));
    EXPECT_THAT(triangles, ElementsAre(ElementsAre(0, 1, 2), ElementsAre(0, 2, 3)));
}

// Its callbacks, which would hand out faces of any size, know no smoothing groups.
TEST(TinyObjLoader, hasNoCallbackForSmoothingGroups) {
    tinyobj::callback_t callbacks;
    std::string calls;
    callbacks.vertex_cb = [](void* text, double, double, double, double) { *static_cast<std::string*>(text) += "v"; };
    callbacks.index_cb = [](void* text, tinyobj::index_t*, int) { *static_cast<std::string*>(text) += "f"; };
    callbacks.group_cb = [](void* text, const char**, int) { *static_cast<std::string*>(text) += "g"; };
    callbacks.object_cb = [](void* text, const char*) { *static_cast<std::string*>(text) += "o"; };
    callbacks.usemtl_cb = [](void* text, const char*, int) { *static_cast<std::string*>(text) += "u"; };
    std::istringstream stream(square + "s 1\nf 1 2 3\ns 2\nf 1 3 4\n");
    EXPECT_TRUE(tinyobj::LoadObjWithCallback(stream, callbacks, &calls));
    EXPECT_EQ(calls, "vvvvff");
}

// ---- materials --------------------------------------------------------------------------------------------------------------

TEST(TinyObjLoader, misreadsColors) {
    EXPECT_EQ(diffuseOf("newmtl m\nKd .3\n"), "0.3 0 0");              // a grey, by the format's description
    EXPECT_EQ(diffuseOf("newmtl m\nKd red\n"), "0 0 0");
    EXPECT_EQ(diffuseOf("newmtl m\nKd xyz .1 .2 .3\n"), "0 0.1 0.2");
    EXPECT_EQ(diffuseOf("newmtl m\nkd .2 .4 .6\n"), "0 0 0");
    EXPECT_EQ(diffuseOf("newmtl m\nmap_Kd a.png\n"), "0.6 0.6 0.6");
    EXPECT_EQ(diffuseOf("newmtl l\nKd 1 1 1\nnewmtl m\nmap_Kd a.png\n"), "0 0 0");  // black, because another material has a Kd
}

TEST(TinyObjLoader, makesHaloesInvisible) { EXPECT_EQ(loadMtl("newmtl m\nd -halo .5\n").materials.at(0).dissolve, 0); }

TEST(TinyObjLoader, takesANamesFirstWordForANumber) {
    EXPECT_EQ(loadMtl("newmtl m\nmap_Kd -s 2 2 my image.png\n").materials.at(0).diffuse_texname, "image.png");
    EXPECT_EQ(loadMtl("newmtl m\nmap_Kd -o .5 wood.png\n").materials.at(0).diffuse_texname, "");
}

// What is not given has a number all the same: "Pr 0" would be a mirror, no Pr is no physically based material.
TEST(TinyObjLoader, doesNotSayWhatIsGiven) {
    const tinyobj::material_t given = loadMtl("newmtl m\nPr 0\nillum 0\nKd 0 0 0\n").materials.at(0),
                              silent = loadMtl("newmtl m\n").materials.at(0);
    EXPECT_EQ(given.roughness, silent.roughness);
    EXPECT_EQ(given.illum, silent.illum);
    EXPECT_EQ(given.diffuse[0], silent.diffuse[0]);
}

// ---- speed ------------------------------------------------------------------------------------------------------------------

double cpuSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// Prints how long both take for a grid of 1.4 million triangles.
TEST(SlowTinyObjLoader, takesLongerThanOurReader) {
    constexpr int n = 837;
    std::string text;
    for (int y = 0; y <= n; ++y)
        for (int x = 0; x <= n; ++x) text += fmt::format("v {:.6f} {:.6f} {:.6f}\n", x / 3., std::sin(x * .05) * std::cos(y * .07), y / 3.);
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const int a = y * (n + 1) + x + 1, b = a + n + 1;
            text += fmt::format("f {0} {1} {3}\nf {0} {3} {2}\n", a, a + 1, b, b + 1);
        }

    Diagnostics diagnostics(LogLevel::silent);
    const double start = cpuSeconds();
    const ObjGeometry geometry = parseObj(text, std::make_shared<const std::string>("grid.obj"), diagnostics);
    const double ours = cpuSeconds();
    const Loaded loaded = loadInSilence(text);
    const double its = cpuSeconds();
    EXPECT_EQ(loaded.positions().size(), geometry.corners.size());
    std::cout << geometry.faces.size() << " faces: ours " << ours - start << " CPU seconds, tinyobjloader " << its - ours << "\n";
    EXPECT_GT(its - ours, ours - start);
}

}  // namespace
}  // namespace eikonal
