// The geometry of OBJ files, awkward ones too, and what is said about files that are wrong.

#include "unit/mesh_area.h"
#include "unit/obj_fixture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace eikonal {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

// Every spelling of the same square is the same square: two triangles, area 1, facing +z.
TEST_F(ObjTest, readsEverySpellingOfAFace) {
    for (const std::string faces : {"f 1 2 3 4\n", "f -4 -3 -2 -1\n", "f 1// 2// 3// 4//\n", "f 1 2 3\nf 1 3 4\n", "f 1 \\\n 2 \\\n3 4",
                                    "fo 1 2 3 4 # a square\n", "  \tf  1\t2 3 4   \n", "g a b\ns off\nf 1 2 3 4\n"}) {
        const Scene scene = load(square + faces);
        const Mesh& mesh = meshOf(scene);
        EXPECT_EQ(mesh.indices.size(), 6u) << faces;
        EXPECT_EQ(mesh.positions.size(), 4u) << faces;
        EXPECT_NEAR(areaOf(mesh), 1, 1e-6) << faces;
        const glm::vec3 a = mesh.positions[mesh.indices[0]], b = mesh.positions[mesh.indices[1]], c = mesh.positions[mesh.indices[2]];
        EXPECT_GT(glm::cross(b - a, c - a).z, 0) << faces;
        EXPECT_THAT(mesh.normals, IsEmpty()) << faces;
        EXPECT_THAT(mesh.uvs, IsEmpty()) << faces;
        EXPECT_THAT(geometryWarnings(), IsEmpty()) << faces;
    }
}

TEST_F(ObjTest, readsEveryEndOfLineAndAByteOrderMark) {
    const std::string text = square + "f 1 2 3 4\n";
    for (const std::string end : {"\r\n", "\r"}) {
        std::string other = text;
        for (std::size_t at = 0; (at = other.find('\n', at)) != other.npos; at += end.size()) other.replace(at, 1, end);
        EXPECT_EQ(meshOf(load(other)).indices.size(), 6u);
    }
    EXPECT_EQ(meshOf(load("\xEF\xBB\xBF" + text)).indices.size(), 6u);
    EXPECT_THAT(geometryWarnings(), IsEmpty());
}

// An L of five unit squares is concave: cut anywhere but along its inside, its triangles would have another area than 5.
TEST_F(ObjTest, cutsConcavePolygonsAlongTheirInside) {
    const std::string corners = "v 0 0 0\nv 3 0 0\nv 3 1 0\nv 1 1 0\nv 1 3 0\nv 0 3 0\n";
    for (const std::string face : {"f 1 2 3 4 5 6\n", "f 4 5 6 1 2 3\n", "f 6 5 4 3 2 1\n"}) {
        const Scene scene = load(corners + face);
        EXPECT_EQ(meshOf(scene).indices.size(), 12u) << face;
        EXPECT_NEAR(areaOf(meshOf(scene)), 5, 1e-5) << face;
    }
}

// Corners with the same position but other normals or texture coordinates are other vertices.
TEST_F(ObjTest, sharesVerticesThatAreEqualInEverything) {
    const Scene scene = load(square + "vt 0 0\nvt 1\nvn 0 0 2\nvn 0 1 1\nf 1/1/1 2/2/1 3/1/1\nf 1/1/1 3/1/1 4/1/2\nf 1/2/1 3/1/1 4/1/2\n");
    const Mesh& mesh = meshOf(scene);
    EXPECT_EQ(mesh.positions.size(), 5u);
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));                    // of length one
    EXPECT_EQ(mesh.uvs[1], glm::vec2(1, 0));                           // a missing v is 0
    EXPECT_THAT(mesh.indices, ElementsAre(0, 1, 2, 0, 2, 3, 4, 2, 3));
}

// Two faces at a right angle: in one smoothing group the normal along their common edge is the diagonal, without one there is none.
TEST_F(ObjTest, smoothsWithinSmoothingGroupsOnly) {
    const std::string roof = "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 1 1 0\nv 0 0 -1\nv 0 1 -1\n", faces = "f 1 3 4 2\nf 5 1 2 6\n";
    const Scene smooth = load(roof + "s 1\n" + faces), flat = load(roof + "s off\n" + faces);
    const Mesh& mesh = meshOf(smooth);
    ASSERT_EQ(mesh.normals.size(), 6u);
    for (std::size_t i = 0; i < 6; ++i) {
        const glm::vec3 p = mesh.positions[i];
        const glm::vec3 expected = p.x > 0 ? glm::vec3(0, 0, 1) : p.z < 0 ? glm::vec3(-1, 0, 0) : glm::normalize(glm::vec3(-1, 0, 1));
        EXPECT_LT(glm::distance(mesh.normals[i], expected), 1e-6f);
    }
    EXPECT_THAT(meshOf(flat).normals, IsEmpty());
    /* Numbers beyond those that are kept are one group */
    EXPECT_EQ(meshOf(load(roof + "s 1e31\n" + faces)).normals, mesh.normals);
}

// One shape for each material of each object; going back to an earlier one adds to its shape.
TEST_F(ObjTest, makesOneShapeOfEachMaterialOfEachObject) {
    write("two words.mtl", "newmtl dark red # old\nKd .5 0 0\nnewmtl b\nKd 0 1 0\n");
    const Scene scene = load("mtllib two words.mtl\n" + square +
                             "o one\nusemtl dark red # old\nf 1 2 3\nusemtl b\nf 1 3 4\nusemtl dark red # old\nf 1 2 4\no two\nf 2 3 4\n");
    ASSERT_EQ(scene.shapes.size(), 3u);
    EXPECT_EQ(meshOf(scene, 0).indices.size(), 6u);
    EXPECT_EQ(scene.shapes[0].material, scene.shapes[2].material);
    EXPECT_NE(scene.shapes[0].material, scene.shapes[1].material);
    EXPECT_EQ(scene.shapes[1].where.line, 9);
    EXPECT_EQ(scene.name, "model");
    EXPECT_THAT(geometryWarnings(), IsEmpty());
}

// A metre-sized model 4,500 km from the origin keeps its shape: floats there are half a metre apart.
TEST_F(ObjTest, keepsTheDetailOfModelsFarFromTheOrigin) {
    const Scene scene = load("v 4500000.1 0 0\nv 4500001.1 0 0\nv 4500001.1 1 0\nf 1 2 3\n");
    const Mesh& mesh = meshOf(scene);
    EXPECT_NEAR(areaOf(mesh), 0.5, 1e-6);
    const glm::dvec4 first = scene.shapes[0].worldFromObject * glm::dvec4(mesh.positions[0], 1);
    EXPECT_NEAR(first.x, 4500000.1, 1e-6);
}

TEST_F(ObjTest, leavesOutTrianglesWithoutArea) {
    const Scene scene = load(square + "v .5 0 0\nf 1 2 3\nf 1 1 2\nf 1 2 5\n");
    EXPECT_EQ(meshOf(scene).indices.size(), 3u);
    EXPECT_THAT(geometryWarnings(), ElementsAre(HasSubstr(":7: warning: 2 of 3 triangles have zero area")));
}

TEST_F(ObjTest, namesTheFirstFaceWithoutArea) {
    const Scene scene = load(square + "usemtl a\nf 1 2 3\nusemtl b\nf 1 1 2\nf 1 2 3\nusemtl a\nf 1 2\n");
    EXPECT_EQ(scene.shapes.size(), 2u);
    EXPECT_THAT(geometryWarnings(), Contains(HasSubstr(":8: warning: 2 of 4 triangles have zero area")));
}

TEST_F(ObjTest, warnsOnceOfWhatItDoesNotRender) {
    load("v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nl 1 2\nl 2 3\np 1\nsurf 0 1 0 1 1 2 3\nhello\nf 1 2 3\n");
    EXPECT_THAT(geometryWarnings(),
                ElementsAre(HasSubstr("model.obj:1:1: warning: the colors of vertices"), HasSubstr("model.obj:4:1: warning: lines"),
                            HasSubstr("model.obj:6:1: warning: points"), HasSubstr("model.obj:7:1: warning: free-form"),
                            HasSubstr("model.obj:8:1: warning: \"hello\" is not a statement")));
}

TEST_F(ObjTest, warnsOfNamesThatAreNotThere) {
    const std::string content = square + "mtllib # none\n  usemtl\nf 1 2 3\n";
    load(content);
    EXPECT_THAT(geometryWarnings(),
                ElementsAre(HasSubstr("model.obj:5:1: warning: \"mtllib\" needs the name of a material library; it is skipped"),
                            HasSubstr("model.obj:6:3: warning: \"usemtl\" needs the name of a material; the faces after it have none")));
    EXPECT_THAT(strictErrorIn(content), HasSubstr("model.obj:5:1: \"mtllib\" needs the name"));
    EXPECT_THAT(strictErrorIn(square + "usemtl\nf 1 2 3\n"), HasSubstr("model.obj:5:1: \"usemtl\" needs the name"));
}

// ---- files that are wrong ---------------------------------------------------------------------------------------------------

TEST_F(ObjTest, saysWhereAFileIsWrong) {
    EXPECT_EQ(errorIn(""), "model.obj: there are no faces (\"f\") in this file");
    EXPECT_EQ(errorIn("v 1 2 abc\n"), "model.obj:1:7: \"abc\" is not a finite number");
    for (const char* word : {"nan", "inf", "-infinity", "1e", "1e39x"})
        EXPECT_EQ(errorIn("v " + std::string(word) + " 0 0\nf 1 1 1\n"),
                  "model.obj:1:3: \"" + std::string(word) + "\" is not a finite number");
    for (const char* word : {"1e39", "-1e39", "+1e300", "1e999"})
        EXPECT_EQ(errorIn("v " + std::string(word) + " 0 0\nf 1 1 1\n"),
                  "model.obj:1:3: \"" + std::string(word) + "\" is too large: single precision ends at about 3.4e38");
    EXPECT_EQ(errorIn("v 0 0 0\nvn 0 nan 0\n"), "model.obj:2:6: \"nan\" is not a finite number");
    EXPECT_EQ(errorIn(square + "f 1 2 3\nv 1 2"), "model.obj:6:1: \"v\" needs 3 numbers, and has 2");
    EXPECT_EQ(errorIn(square + "f 0 1 2\n"), "model.obj:5:3: \"0\" is not a corner of a face: position/texture/normal, numbered from 1");
    EXPECT_EQ(errorIn(square + "f 1/2/3/4 1 2\n"), "model.obj:5:3: \"1/2/3/4\" has more than three parts");
    EXPECT_EQ(errorIn(square + "f -5 -3 -2\n"), "model.obj:5:3: \"-5\" counts back beyond the first of 4");
    EXPECT_EQ(errorIn(square + "f 1 2 5\n"), "model.obj:5:7: a face has position 5, but there are 4");
    EXPECT_EQ(errorIn(square + "vt 0 0\nf 1/1 2/1 3/2\n"), "model.obj:6:11: a face has texture coordinate 2, but there are 1");
    EXPECT_EQ(errorIn(square + "vn 0 0 1\nf 1//1 2//1 3//2\n"), "model.obj:6:13: a face has normal 2, but there are 1");
    EXPECT_EQ(errorIn(square + "f 1 \\\n2 \\\nx\n"),
              "model.obj:5:9: \"x\" is not a corner of a face: position/texture/normal, numbered from 1");
    EXPECT_THAT(errorIn(square + "f 1 2\n"), HasSubstr("a face needs three corners"));
    EXPECT_EQ(errorIn(square + std::string("f 1 2 3\n\0", 9)), "model.obj:6:1: a byte is zero: this is not a text file");
    EXPECT_EQ(errorIn(std::string("\xfe\xff\0v\0 ", 6)), "model.obj:1: the file is UTF-16; save it as UTF-8 or ASCII");
    Diagnostics silent(LogLevel::silent);
    EXPECT_EQ(errorOf([&] { readObj(path("absent.obj"), {}, silent); }), "absent.obj: cannot be opened: No such file or directory");
}

// OpenSubdiv's shapes, for example.
TEST_F(ObjTest, numbersOfAbsentNormalsAndTextureCoordinatesAreLeftOut) {
    const Scene scene = load(square + "f 1 2 3\nf 1/1/1 3/1/1 4/1/1\n");
    EXPECT_THAT(geometryWarnings(),
                UnorderedElementsAre(HasSubstr("model.obj:6:3: warning: faces number their texture coordinates, but there are no"),
                                     HasSubstr("model.obj:6:3: warning: faces number their normals, but there are no")));
    EXPECT_EQ(meshOf(scene).indices.size(), 6u);
    EXPECT_TRUE(meshOf(scene).normals.empty() && meshOf(scene).uvs.empty());
}

// Indices at and beyond the limits of 32 bits are errors, not wrap-arounds.
TEST_F(ObjTest, refusesHugeIndices) {
    for (const char* index : {"2147483647", "2147483648", "4294967297", "99999999999999999999", "-2147483648", "-99999999999999999999"})
        EXPECT_THAT(errorIn(square + "f 1 2 " + index + "\n"), HasSubstr("model.obj:5")) << index;
}

// Cut anywhere, a file gives a scene or an error of ours.
TEST_F(ObjTest, survivesTruncationAnywhere) {
    const std::string text =
        "mtllib none.mtl\n" + square + "vt 0 0\nvn 0 0 1\no a\ns 1\nusemtl m\nf 1/1/1 2/1/1 \\\n 3/1/1\nf -4//-1 -2//-1 -1//-1\n";
    int scenes = 0, errors = 0;
    for (std::size_t length = 0; length <= text.size(); ++length) (errorIn(text.substr(0, length)) == "no error" ? scenes : errors)++;
    EXPECT_GT(scenes, 20);
    EXPECT_GT(errors, 60);
}

}  // namespace
}  // namespace eikonal
