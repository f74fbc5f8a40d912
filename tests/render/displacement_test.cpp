// Displaced meshes from a file to the image.

#include "cli.h"
#include "rendering.h"

#include "render/displacement.h"
#include "read/pbrt/read_pbrt.h"

#include <fmt/format.h>

#include <gmock/gmock.h>

#include <cmath>

namespace eikonal {
namespace {

using testing::HasSubstr;

class Displaced : public Cli {
protected:
    /// A square from (-1, -1, 0) to (1, 1, 0), its texture coordinates from (0, 0) to (1, 1), as two triangles.
    Displaced() {
        write("square.ply",
              "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nproperty float u\nproperty "
              "float v\n"
              "element face 2\nproperty list uchar int vertex_indices\nend_header\n-1 -1 0 0 0\n1 -1 0 1 0\n1 1 0 1 1\n-1 1 0 0 1\n3 0 1 "
              "2\n3 0 2 3\n");
    }

    /// The mesh of the first shape, displaced.
    Mesh meshOf(const std::string& world) {
        Diagnostics diagnostics(LogLevel::silent, true);
        Scene scene = readPbrtText("WorldBegin " + world, path("test.pbrt"), path(""), diagnostics);
        EXPECT_TRUE(hasDisplacedMeshes(scene));
        displaceMeshes(scene, device(), compiler(), {}, {}, diagnostics);
        EXPECT_FALSE(hasDisplacedMeshes(scene));
        return *(scene.shapes.empty() ? scene.objects.at(0).shapes : scene.shapes).at(0).mesh;
    }

    const std::string square = "Shape \"plymesh\" \"string filename\" \"square.ply\" \"texture displacement\" \"height\" ";
};

/// Heights are in object space, at texture coordinates: a slope of 3 u stays flat, whatever its edges.
TEST_F(Displaced, BySlopesStaysFlat) {
    const std::string slope = "Texture \"height\" \"float\" \"bilerp\" \"float v00\" 0 \"float v01\" 0 \"float v10\" 3 \"float v11\" 3 ";
    for (const std::string& more : {std::string(), std::string("Scale 1 1 20 ")}) {
        const Mesh mesh = meshOf(slope + more + square + "\"float edgelength\" .1");
        EXPECT_GT(mesh.positions.size(), 400u);
        for (size_t i = 0; i < mesh.positions.size(); ++i) {
            ASSERT_NEAR(mesh.positions[i].z, 3 * mesh.uvs[i].x, 1e-5);
            ASSERT_LT(glm::length(mesh.normals[i] - glm::normalize(glm::vec3(-1.5f, 0, 1))), 1e-4f);
        }
    }
}

/// Solid textures are looked up in world space: with two checks along x, what is beyond x = 5.03 in the world is high.
TEST_F(Displaced, BySolidTexturesInTheWorld) {
    const std::string checks =
        "Translate 5.03 -1e4 -1e4 Scale 1000 1e9 1e9 Texture \"height\" \"float\" \"checkerboard\" \"integer dimension\" 3 \"float tex1\" "
        "1 \"float tex2\" 0 Identity ";
    const std::string placed = "Translate 4.75 .1 .1 " + square + "\"float edgelength\" .125 ";
    for (const std::string& text : {checks + placed, checks + "ObjectBegin \"o\" " + placed +
                                                         "ObjectEnd ObjectInstance \"o\" Translate 9 9 9 ObjectInstance \"o\""}) {
        const Mesh mesh = meshOf(text);
        size_t high = 0;
        for (size_t i = 0; i < mesh.positions.size(); ++i) {
            const bool isHigh = mesh.positions[i].z > 0.5f;
            ASSERT_EQ(isHigh, mesh.positions[i].x + 4.75f > 5.03f) << mesh.positions[i].x;
            high += isHigh;
        }
        EXPECT_GT(high, mesh.positions.size() / 4);
    }
}

std::string asText(const Mesh& mesh) {
    std::string p, n, uv, indices;
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
        p += fmt::format("{:.9g} {:.9g} {:.9g} ", mesh.positions[i].x, mesh.positions[i].y, mesh.positions[i].z);
        n += fmt::format("{:.9g} {:.9g} {:.9g} ", mesh.normals[i].x, mesh.normals[i].y, mesh.normals[i].z);
        uv += fmt::format("{:.9g} {:.9g} ", mesh.uvs[i].x, mesh.uvs[i].y);
    }
    for (const std::uint32_t i : mesh.indices) indices += fmt::format("{} ", i);
    return fmt::format("Shape \"trianglemesh\" \"point3 P\" [{}] \"normal N\" [{}] \"point2 uv\" [{}] \"integer indices\" [{}] ", p, n, uv,
                       indices);
}

/// The same bits as the mesh that comes out, written down: mirrored, reversed, cut out, emitting, moving, in an object that is used once or
/// twice. Of triangles and patches.
TEST_F(Displaced, RenderLikeTheMeshThatTheyBecome) {
    write("tent.ply",
          "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\nproperty float u\nproperty float "
          "v\n"
          "element face 3\nproperty list uchar int vertex_indices\nend_header\n-1 -1 0 0 0\n0 -1 .5 .5 0\n1 -1 0 1 0\n-1 1 0 0 1\n0 1 .5 "
          ".5 1\n1 1 0 1 1\n4 0 1 4 3\n3 1 2 5\n3 1 5 4\n");
    const std::string height =
        "Texture \"height\" \"float\" \"checkerboard\" \"float uscale\" 3 \"float vscale\" 1 \"float tex1\" .2 \"float tex2\" 0 "
        "Texture \"holes\" \"float\" \"checkerboard\" \"float uscale\" 9 \"float vscale\" 9 \"float tex1\" 0 ";
    const std::string tent =
        "Shape \"plymesh\" \"string filename\" \"tent.ply\" \"texture displacement\" \"height\" \"float edgelength\" 9 ";  // as it is,
                                                                                                                           // wherever it is
    const std::string head =
        "LookAt 0 1 -4  0 0 0  0 1 0 Camera \"perspective\" \"float fov\" 50 \"float shutterclose\" 1 Film \"rgb\" \"integer xresolution\" "
        "16 \"integer yresolution\" 16\n"
        "Sampler \"independent\" \"integer pixelsamples\" 16 WorldBegin LightSource \"infinite\" LightSource \"point\" \"rgb I\" [9 8 7] "
        "\"point3 from\" [1 2 -3]\n" +
        height;
    const std::string becomes = asText(meshOf(height + tent));
    const auto scene = [&](const std::string& shape) {
        return head + "AttributeBegin ReverseOrientation Translate -1 0 0 Scale -.5 .7 1 " + shape +
               "\"texture alpha\" \"holes\" AttributeEnd\n"
               "AttributeBegin AreaLightSource \"diffuse\" Translate 1.2 .5 0 Scale .4 .4 .4 " +
               shape +
               "AttributeEnd\n"
               "AttributeBegin ActiveTransform EndTime Translate 0 .2 0 ActiveTransform All Translate 0 -1 0 Scale .5 .5 .5 " +
               shape +
               "AttributeEnd\n"
               "ObjectBegin \"once\" " +
               shape + "ObjectEnd ObjectBegin \"twice\" " + shape +
               "ObjectEnd\n"
               "AttributeBegin Translate 0 1 1 Scale .5 .5 .5 ObjectInstance \"once\" Translate 1 0 0 ObjectInstance \"twice\" Translate "
               "-2 0 0 ObjectInstance \"twice\" AttributeEnd\n";
    };
    write("displaced.pbrt", scene(tent));
    write("written.pbrt", scene(becomes));
    for (const std::string name : {"displaced", "written"}) {
        const Outcome outcome = run({"render", name + ".pbrt", "-o", name + ".exr"});
        ASSERT_EQ(outcome.status, 0) << outcome.error;
        EXPECT_THAT(outcome.error, testing::Not(HasSubstr("warning")));
    }
    EXPECT_EQ(image("displaced.exr").color, image("written.exr").color);
}

TEST_F(Displaced, SaysWhatIsWrong) {
    const std::string constant = "WorldBegin Texture \"height\" \"float\" \"constant\" \"float value\" 1e39 ";
    write("counted.pbrt", "WorldBegin Texture \"height\" \"float\" \"windy\" " + square + "\"float edgelength\" .1");
    EXPECT_THAT(run({"info", "counted.pbrt"}).out, HasSubstr("contents   2048 triangles"));
    write("fine.pbrt", "WorldBegin\nTexture \"height\" \"float\" \"windy\"\n" + square + "\"float edgelength\" 1e-5");
    const Outcome fine = run({"render", "fine.pbrt"});
    EXPECT_EQ(fine.status, static_cast<int>(ExitCode::scene));
    EXPECT_THAT(fine.error, HasSubstr("fine.pbrt:3:48: edges shorter than 1e-05 need more than 33554432 triangles in this mesh, the "
                                      "maximum; \"float edgelength\" 0.0014 would work"));
    write("far.pbrt", constant + square);
    EXPECT_THAT(run({"render", "far.pbrt"}).error, HasSubstr("moves a vertex to a position that is not finite"));
    write("bare.ply",
          "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list "
          "uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n");
    write("bare.pbrt",
          "WorldBegin Texture \"height\" \"float\" \"windy\" Shape \"plymesh\" \"string filename\" \"bare.ply\" \"texture displacement\" "
          "\"height\"");
    EXPECT_THAT(run({"info", "bare.pbrt"}).error,
                HasSubstr("this mesh has no texture coordinates; its displacement texture is looked up at (0, 0)"));
}

}  // namespace
}  // namespace eikonal
