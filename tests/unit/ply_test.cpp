// PLY files in every encoding that the format has, and what is said about those that are wrong.

#include "read/mesh/ply.h"
#include "unit/mesh_area.h"
#include "unit/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <array>
#include <bit>
#include <cstring>
#include <filesystem>

namespace eikonal {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Ply : public TemporaryFolder {
protected:
    PlyMesh load(const std::string& content) const { return loadPly(write("mesh.ply", content), where_); }

    /// What follows the file's name in the error, or "no error".
    std::string errorOf(const std::string& content) const {
        try {
            load(content);
            return "no error";
        } catch (const SceneError& error) {
            const std::string text = error.what(), start = "scene.pbrt:3:7: PLY file \"" + path("mesh.ply") + "\" ";
            EXPECT_THAT(text, testing::StartsWith(start));
            return text.substr(start.size());
        }
    }

    SourceLocation where_{std::make_shared<std::string>("scene.pbrt"), 3, 7};
};

const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string faceList = "property list uchar int vertex_indices\n";

/// A triangle, a quad, a pentagon and a line over six vertices with normals and texture coordinates.
const std::string mixedText =
    "ply\nformat ascii 1.0\ncomment made by hand\nobj_info none\nelement vertex 6\n" + xyz +
    "property uchar red\nproperty float nx\nproperty float ny\nproperty float nz\nproperty float s\nproperty float t\n"
    "element face 4\nproperty uchar flags\n" + faceList + "property list uchar float texcoord\nelement edge 1\nproperty int a\nend_header\n"
    "0 0 0 255 0 0 1 0 0\n1 0 0 255 0 0 1 1 0\n1 1 0 255 0 0 1 1 1\n0 1 0 255 0 0 1 0 1\n.5 2 0 255 0 0 1 .5 2\n-1e0 +1 0 255 0 0 1 -1 1\n"
    "0 3 0 1 2 6 0 0 1 0 1 1\n1 4 0 1 2 3 0\n1 5 0 1 2 4 3 0\n0 2 0 1 0\n7\n";

TEST_F(Ply, readsTextWithEveryKindOfFace) {
    const PlyMesh mesh = load(mixedText);
    ASSERT_TRUE(mesh.triangles && mesh.quads);
    EXPECT_THAT(mesh.triangles->indices, ElementsAre(0, 1, 2, /* fan: */ 0, 1, 2, 0, 2, 4, 0, 4, 3));
    EXPECT_THAT(mesh.quads->indices, ElementsAre(0, 1, 3, 2));
    EXPECT_EQ(mesh.droppedFaces, 1u);
    for (const auto& part : {mesh.triangles, mesh.quads}) {
        ASSERT_EQ(part->positions.size(), 6u);
        EXPECT_EQ(part->positions[4], glm::vec3(.5f, 2, 0));
        EXPECT_EQ(part->positions[5], glm::vec3(-1, 1, 0));
        ASSERT_EQ(part->normals.size(), 6u);
        EXPECT_EQ(part->normals[3], glm::vec3(0, 0, 1));
        ASSERT_EQ(part->uvs.size(), 6u);
        EXPECT_EQ(part->uvs[5], glm::vec2(-1, 1));
    }
}

/// A text file of faces over vertices.
std::string polygons(const std::string& vertices, int vertexCount, const std::string& faces, int faceCount) {
    return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(vertexCount) + "\n" + xyz + "element face " +
           std::to_string(faceCount) + "\n" + faceList + "end_header\n" + vertices + faces;
}

// An L of five unit squares, from each of its corners: most fans cover more than that. The faces around it keep their order.
TEST_F(Ply, cutsConcavePolygonsAlongTheirInside) {
    const std::string corners = "0 0 0\n3 0 0\n3 1 0\n1 1 0\n1 3 0\n0 3 0\n";
    for (int first = 0; first < 6; ++first) {
        std::string face = "6";
        for (int i = 0; i < 6; ++i) face += " " + std::to_string((first + i) % 6);
        const PlyMesh mesh = load(polygons(corners, 6, "3 0 1 2\n" + face + "\n3 0 4 5\n", 3));
        ASSERT_EQ(mesh.triangles->indices.size(), 18u);
        EXPECT_EQ(areaOf(*mesh.triangles), 1.5 + 5 + 1.5) << first;
        EXPECT_EQ(mesh.triangles->indices[2], 2u);
        EXPECT_EQ(mesh.triangles->indices[16], 4u);
    }
}

TEST_F(Ply, cutsPolygonsThatPrecedeTheirVertices) {
    const PlyMesh mesh = load("ply\nformat ascii 1.0\nelement face 1\n" + faceList + "element vertex 5\n" + xyz +
                              "end_header\n5 0 1 2 3 4\n0 0 0\n2 0 0\n2 2 0\n1 .5 0\n0 2 0\n");
    EXPECT_EQ(areaOf(*mesh.triangles), 2.5);
}

TEST_F(Ply, notesTextAfterTheLastElement) {
    const std::string vertices = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
    EXPECT_EQ(load(polygons(vertices, 4, "3 0 1 2\n3 0 2 3\n", 1)).firstUnreadLine, 15u);
    EXPECT_EQ(load(polygons(vertices, 4, "3 0 1 2 3 0 2 3", 1)).firstUnreadLine, 14u);
    EXPECT_EQ(load(polygons(vertices, 4, "3 0 1 2\r\n\r3 0 2 3\n", 1)).firstUnreadLine, 16u);
    for (const char* blank : {"", "\n", "\n\n \t\r\n"}) EXPECT_EQ(load(polygons(vertices, 4, "3 0 1 2", 1) + blank).firstUnreadLine, 0u);
}

// Blender 2.4 wrote such files.
TEST_F(Ply, notesUnknownLinesBeforeItsElements) {
    const std::string text = polygons("0 0 0\n1 0 0\n1 1 0\n", 3, "3 0 1 2", 1);
    EXPECT_EQ(load(text).skippedHeaderLine, 0);
    const std::size_t at = text.find("element");
    EXPECT_EQ(load(text.substr(0, at) + "Created by a program\n" + text.substr(at)).skippedHeaderLine, 3);
    const std::size_t property = text.find("property");
    EXPECT_EQ(errorOf(text.substr(0, property) + "Created by a program\n" + text.substr(property)),
              "has an unknown keyword \"Created\" in line 4 of its header");
}

TEST_F(Ply, readsCarriageReturns) {
    std::string text = mixedText;
    for (std::size_t at = 0; (at = text.find('\n', at)) != text.npos; at += 2) text.replace(at, 1, "\r\n");
    EXPECT_EQ(load(text).triangles->indices.size(), 12u);
}

TEST_F(Ply, leavesOutWhatIsNotThere) {
    const PlyMesh mesh = load("ply\nformat ascii 1.0\nelement vertex 3\n" + xyz + "element face 1\n" + faceList +
                              "end_header\n0 0 0 1 0 0 0 1 0 3 0 1 2");
    EXPECT_FALSE(mesh.quads);
    EXPECT_TRUE(mesh.triangles->normals.empty());
    EXPECT_TRUE(mesh.triangles->uvs.empty());
}

TEST_F(Ply, knowsEveryNameOfTextureCoordinates) {
    for (const auto& [u, v] : {std::pair{"u", "v"}, {"s", "t"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}}) {
        const PlyMesh mesh = load("ply\nformat ascii 1.0\nelement vertex 3\n" + xyz + "property float " + u + "\nproperty double " + v +
                                  "\nelement face 1\nproperty list int16 uint32 vertex_index\nend_header\n"
                                  "0 0 0 0 0\n1 0 0 1 .25\n0 1 0 0 1\n3 0 1 2\n");
        ASSERT_EQ(mesh.triangles->uvs.size(), 3u) << u;
        EXPECT_EQ(mesh.triangles->uvs[1], glm::vec2(1, .25f));
    }
}

// ---- binary -----------------------------------------------------------------------------------------------------------------

template <class T> void append(std::string& bytes, T value, bool bigEndian) {
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), &value, sizeof(T));
    if (bigEndian != (std::endian::native == std::endian::big)) std::reverse(raw.begin(), raw.end());
    bytes.append(raw.data(), raw.size());
}

/// A quad and a triangle; the properties have every type that the format knows.
std::string binaryMesh(bool bigEndian) {
    std::string bytes = std::string("ply\nformat binary_") + (bigEndian ? "big" : "little") +
                        "_endian 1.0\nelement vertex 4\nproperty char a\nproperty double x\nproperty int16 b\nproperty float y\n"
                        "property uint c\nproperty float32 z\nproperty ushort d\nproperty uint8 e\n"
                        "element face 2\nproperty list uint16 short vertex_indices\nproperty list uchar double rest\nend_header\n";
    const float y[4] = {0, 0, 1, 1};
    for (int i = 0; i < 4; ++i) {
        append<std::int8_t>(bytes, -1, bigEndian);
        append<double>(bytes, i % 3 == 0 ? 0 : 1e6 + .5, bigEndian);
        append<std::int16_t>(bytes, -300, bigEndian);
        append<float>(bytes, y[i], bigEndian);
        append<std::uint32_t>(bytes, 4000000000u, bigEndian);
        append<float>(bytes, -2, bigEndian);
        append<std::uint16_t>(bytes, 60000, bigEndian);
        append<std::uint8_t>(bytes, '\n', bigEndian);
    }
    for (const int corners : {4, 3}) {
        append<std::uint16_t>(bytes, static_cast<std::uint16_t>(corners), bigEndian);
        for (std::int16_t i = 0; i < corners; ++i) append<std::int16_t>(bytes, i, bigEndian);
        append<std::uint8_t>(bytes, 1, bigEndian);
        append<double>(bytes, 7, bigEndian);
    }
    return bytes;
}

void expectBinaryMesh(const PlyMesh& mesh) {
    ASSERT_TRUE(mesh.triangles && mesh.quads);
    EXPECT_THAT(mesh.quads->indices, ElementsAre(0, 1, 3, 2));
    EXPECT_THAT(mesh.triangles->indices, ElementsAre(0, 1, 2));
    EXPECT_THAT(mesh.triangles->positions,
                ElementsAre(glm::vec3(0, 0, -2), glm::vec3(1e6f + .5f, 0, -2), glm::vec3(1e6f + .5f, 1, -2), glm::vec3(0, 1, -2)));
}

TEST_F(Ply, readsLittleEndian) { expectBinaryMesh(load(binaryMesh(false))); }
TEST_F(Ply, readsBigEndian) { expectBinaryMesh(load(binaryMesh(true))); }
TEST_F(Ply, notesBytesAfterItsBinaryData) {
    EXPECT_EQ(load(binaryMesh(false) + "x").unreadBytes, 1u);
    EXPECT_EQ(load(binaryMesh(true) + "0\n").unreadBytes, 2u);
    EXPECT_EQ(load(binaryMesh(false) + "\r\n").unreadBytes, 0u);
}

TEST_F(Ply, readsCompressedFiles) {
    const std::string content = binaryMesh(false);
    gzFile file = gzopen(path("mesh.ply.gz").c_str(), "wb");
    gzwrite(file, content.data(), static_cast<unsigned>(content.size()));
    gzclose(file);
    expectBinaryMesh(loadPly(path("mesh.ply.gz"), where_));

    std::filesystem::resize_file(path("mesh.ply.gz"), std::filesystem::file_size(path("mesh.ply.gz")) - 20);
    EXPECT_THROW(loadPly(path("mesh.ply.gz"), where_), SceneError);
}

TEST_F(Ply, refusesEveryTruncation) {
    // Cut off anywhere, a file is either refused or (text only: a last word cut short, or the edge after the faces) still a mesh.
    for (const std::string& content : {binaryMesh(false), binaryMesh(true)})
        for (std::size_t size = 0; size < content.size(); ++size) EXPECT_NE(errorOf(content.substr(0, size)), "no error") << size;
    for (std::size_t size = 0; size + 2 < mixedText.size(); ++size) EXPECT_NE(errorOf(mixedText.substr(0, size)), "no error") << size;
}

TEST_F(Ply, survivesEveryChangedByte) {
    const std::string content = binaryMesh(false);
    for (std::size_t at = 0; at < content.size(); ++at)
        for (const int change : {1, 0x80, 0xff}) {
            std::string changed = content;
            changed[at] = static_cast<char>(changed[at] ^ change);
            errorOf(changed);
        }
}

// ---- errors -----------------------------------------------------------------------------------------------------------------

TEST_F(Ply, saysWhatIsWrong) {
    const auto text = [](const std::string& vertices, const std::string& faces, const std::string& data) {
        return "ply\nformat ascii 1.0\n" + vertices + faces + "end_header\n" + data;
    };
    const std::string three = "element vertex 3\n" + xyz, one = "element face 1\n" + faceList, points = "0 0 0 1 0 0 0 1 0\n";
    EXPECT_EQ(errorOf("solid cube\n"), "is not a PLY file: it does not begin with \"ply\"");
    EXPECT_EQ(errorOf("ply\nformat ascii 1.0\n"), "is truncated: there is no \"end_header\"");
    EXPECT_EQ(errorOf("ply\nelement vertex 3\nend_header\n"), "has no \"format\" line");
    EXPECT_EQ(errorOf("ply\nformat ebcdic 1.0\nend_header\n"),
              "has the unknown format \"ebcdic\"; known: ascii binary_little_endian binary_big_endian");
    EXPECT_EQ(errorOf("ply\nformat ascii 1.0\nelement vertex many\nend_header\n"), "has a malformed \"element\" in line 3");
    EXPECT_EQ(errorOf("ply\nformat ascii 1.0\nelement vertex 1\nproperty half x\nend_header\n"),
              "has an unknown type \"half\" in line 4; known: char uchar short ushort int uint float double");
    EXPECT_EQ(errorOf(text(three, "", points)), "has no element \"face\"; its elements: vertex");
    EXPECT_EQ(errorOf(text("element vertex 0\n" + xyz, one, "3 0 0 0")), "has 0 elements \"vertex\"; a mesh needs some");
    EXPECT_EQ(errorOf(text("element vertex 1\nproperty float x\n", one, "0 3 0 0 0")), "has no vertex properties x, y and z");
    EXPECT_EQ(errorOf(text(three, "element face 1\nproperty int i\n", points + "1")),
              "has no list \"vertex_indices\" in its element \"face\"");
    EXPECT_EQ(errorOf(text(three, one, points + "3 0 1 3")), "has a face with vertex index 3, but its 3 vertices are numbered from 0");
    EXPECT_EQ(errorOf(text(three, one, points + "3 0 1 -1")), "has a face 0 with the vertex index -1");
    EXPECT_EQ(errorOf(text(three, one, points + "3 0 1 1.5")), "has a face 0 with the vertex index 1.5");
    EXPECT_EQ(errorOf(text(three, one, points + "-3 0 1 2")), "has a list \"vertex_indices\" of length -3");
    EXPECT_EQ(errorOf(text(three, one, "0 0 zero 1 0 0 0 1 0 3 0 1 2")), "has \"zero\" where a number is expected");
    EXPECT_EQ(errorOf(text(three, one, "0 0 nan 1 0 0 0 1 0 3 0 1 2")), "has a face with vertex 0, whose position is not finite");
    EXPECT_EQ(errorOf(text("element vertex 4000000000000\n" + xyz, one, points)),
              "is truncated: it ends before its last element");
}

TEST_F(Ply, namesAFileThatIsNotThere) {
    try {
        loadPly(path("absent.ply"), where_);
        FAIL();
    } catch (const SceneError& error) {
        EXPECT_EQ(error.what(), "scene.pbrt:3:7: PLY file \"" + path("absent.ply") + "\" cannot be opened: No such file or directory");
    }
    EXPECT_THAT([&] { loadPly(folder_.string(), where_); }, testing::ThrowsMessage<SceneError>(HasSubstr("Is a directory")));
}

TEST_F(Ply, DoublesFarFromTheOriginKeepTheirDigits) {
    const auto loadAs = [&](const std::string& type) {
        const std::string header = "ply\nformat ascii 1.0\nelement vertex 3\nproperty " + type + " x\nproperty " + type +
                                   " y\nproperty " + type + " z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
        return load(header + "10000000.125 0 0  10000001.375 0 0  10000000.25 1 0\n3 0 1 2\n");
    };
    const PlyMesh doubles = loadAs("double"), floats = loadAs("float");
    const Mesh &exact = *doubles.triangles, &rounded = *floats.triangles;
    EXPECT_EQ(exact.origin.x + exact.positions[1].x, 10000001.375);
    EXPECT_EQ(exact.origin.x + exact.positions[2].x, 10000000.25);
    EXPECT_EQ(rounded.origin, glm::dvec3(0));
    EXPECT_EQ(rounded.positions[1].x, 10000001.f);
}

}  // namespace
}  // namespace eikonal
