// Shapes, objects and instances. The defaults are those of pbrt-v4's source (shapes.cpp).

#include "kinds/shape_kind.h"
#include "unit/pbrt_reading.h"

namespace eikonal {
namespace {

class PbrtShapes : public PbrtTest {
protected:
    Shape shape(const std::string& text) { return world("Shape " + text).shapes.at(0); }
};

const std::string triangle = "\"trianglemesh\" \"point3 P\" [0 0 0  1 0 0  0 1 0] ";

TEST_F(PbrtShapes, spheres) {
    const auto whole = shape("\"sphere\"");
    EXPECT_EQ(whole.radius, 1);
    EXPECT_EQ(whole.zMin, -1);
    EXPECT_EQ(whole.zMax, 1);
    EXPECT_EQ(whole.phiMax, 360);
    const auto part = shape("\"sphere\" \"float radius\" 2 \"float zmin\" 1 \"float zmax\" -5 \"float phimax\" 400");
    EXPECT_EQ(part.zMin, -2);
    EXPECT_EQ(part.zMax, 1);
    EXPECT_EQ(part.phiMax, 360);
}

TEST_F(PbrtShapes, disks) {
    const auto disk = shape("\"disk\" \"float radius\" 2 \"float innerradius\" .5 \"float height\" 3 \"float phimax\" 90");
    EXPECT_EQ(disk.radius, 2);
    EXPECT_EQ(disk.innerRadius, .5);
    EXPECT_EQ(disk.height, 3);
    EXPECT_EQ(disk.phiMax, 90);
}

TEST_F(PbrtShapes, cylinders) {
    const auto whole = shape("\"cylinder\"");
    EXPECT_EQ(whole.radius, 1);
    EXPECT_EQ(whole.zMin, -1);
    EXPECT_EQ(whole.zMax, 1);
    EXPECT_EQ(whole.phiMax, 360);
    const auto part = shape("\"cylinder\" \"float radius\" 2 \"float zmin\" 5 \"float zmax\" 3 \"float phimax\" 90");
    EXPECT_EQ(part.radius, 2);
    EXPECT_EQ(part.zMin, 3);
    EXPECT_EQ(part.zMax, 5);
    EXPECT_EQ(part.phiMax, 90);
}

TEST_F(PbrtShapes, implicitSurfaces) {
    const auto surface = *shape("\"implicit\" \"string F\" \"x^2 + a*y\" \"float a\" 3 \"point3 bounds\" [1 2 -3  -1 0 4]").implicit;
    expectNear(surface.low, {-1, 0, -3});
    expectNear(surface.high, {1, 2, 4});
    const std::string cube = " \"point3 bounds\" [-1 -1 -1 1 1 1]";
    EXPECT_THAT(errorOfWorld("Shape \"implicit\" \"string F\" \"x + * y\"" + cube),
                HasSubstr("test.pbrt:2:34: F: \"*\" found where a number"));
    EXPECT_THAT(errorOfWorld("Shape \"implicit\"" + cube + " \"string F\" [\n \"x + b\"]"),
                HasSubstr("test.pbrt:3:7: F: there is no \"b\": give it with \"float b\""));
    EXPECT_THAT(errorOfWorld("Shape \"implicit\"" + cube), HasSubstr("needs its function, as in"));
    EXPECT_THAT(errorOfWorld("Shape \"implicit\" \"string F\" \"x\""), HasSubstr("needs a box that bounds it"));
    EXPECT_THAT(errorOfWorld("Shape \"implicit\" \"string F\" \"x\" \"point3 bounds\" [0 0 0 1 0 1]"),
                HasSubstr("both corners have the same y"));
    EXPECT_EQ(world("AreaLightSource \"diffuse\" Shape \"implicit\" \"string F\" \"x\"" + cube).shapes.at(0).areaLight, 0);
}

TEST_F(PbrtShapes, quadricsWithoutAreaAreLeftOut) {
    for (const char* text : {"\"sphere\" \"float radius\" 0", "\"sphere\" \"float zmin\" 1", "\"disk\" \"float phimax\" 0",
                             "\"disk\" \"float innerradius\" 1", "\"cylinder\" \"float zmin\" 1", "\"cylinder\" \"float radius\" 0"}) {
        EXPECT_THAT(world("Shape " + std::string(text)).shapes, IsEmpty()) << text;
        EXPECT_THAT(warnings_, ElementsAre(HasSubstr("has zero area"))) << text;
    }
}

TEST_F(PbrtShapes, subdividedMeshes) {
    const std::string octahedron =
        "\"loopsubdiv\" \"point3 P\" [1 0 0 -1 0 0 0 1 0 0 -1 0 0 0 1 0 0 -1] \"integer indices\" [0 2 4 2 1 4 1 3 4 3 0 4 2 0 5 1 2 5 3 1 "
        "5 0 3 5] ";
    EXPECT_EQ(shape(octahedron).mesh->indices.size(), 3u * 8 * 64);
    EXPECT_EQ(shape(octahedron + "\"integer levels\" 0").mesh->indices.size(), 3u * 8);
    EXPECT_EQ(shape(octahedron + "\"integer levels\" -1").mesh->indices.size(), 3u * 8) << "as in pbrt-v4";
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("\"integer levels\" is -1; it counts as 0, since it must be in [0, inf)")));
    EXPECT_THAT(errorOfWorld("Shape " + octahedron + "\"integer levels\" 12"),
                HasSubstr("\"integer levels\" is 12, which makes more than 33554432 triangles of this mesh; 11 would work"));
    EXPECT_THAT(errorOfWorld("Shape \"loopsubdiv\" \"point3 P\" [0 0 0 1 0 0 0 1 0]"), HasSubstr("needs the vertices of its faces"));
    EXPECT_EQ(shape("\"loopsubdiv\" \"point3 P\" [0 0 0 1 0 0 0 1 0] \"integer indices\" [0 1 1 0 1 2]")
                  .mesh->indices.size(),
              3u * 64);
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("1 faces that name a vertex twice are skipped")));
}

TEST_F(PbrtShapes, triangleMeshes) {
    const auto mesh = shape(triangle + "\"normal N\" [0 0 1 0 0 1 0 0 1] \"point2 uv\" [0 0 1 0 0 1]").mesh;
    EXPECT_THAT(mesh->indices, ElementsAre(0, 1, 2));
    EXPECT_EQ(mesh->positions[1], glm::vec3(1, 0, 0));
    EXPECT_EQ(mesh->normals.size(), 3u);
    EXPECT_EQ(mesh->uvs[2], glm::vec2(0, 1));
    EXPECT_THAT(errorOfWorld("Shape \"trianglemesh\""), HasSubstr("needs its vertices, \"point3 P\""));
    EXPECT_THAT(errorOfWorld("Shape \"trianglemesh\" \"point3 P\" [0 0]"), HasSubstr("a multiple of 3 is expected"));
    EXPECT_THAT(errorOfWorld("Shape \"trianglemesh\" \"point3 P\" [0 0 0]"), HasSubstr("without \"integer indices\" it has 3"));
    EXPECT_THAT(errorOfWorld("Shape " + triangle + "\"integer indices\" [0 1 3]"), HasSubstr("has a 3; \"P\" has vertices 0 to 2"));
    EXPECT_THAT(errorOfWorld("Shape " + triangle + "\"integer indices\" [0 1 -1]"), HasSubstr("has a -1"));
}

TEST_F(PbrtShapes, meshesThatDoNotAddUpAreMended) {
    EXPECT_EQ(shape(triangle + "\"integer indices\" [0 1 2 0]").mesh->indices.size(), 3u);
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("has 4 values, not a multiple of 3; the last are ignored")));
    EXPECT_THAT(shape(triangle + "\"point2 uv\" [0 0]").mesh->uvs, IsEmpty());
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("\"uv\" is ignored: it has 1 vertices, and \"P\" has 3")));
}

TEST_F(PbrtShapes, bilinearMeshes) {
    const std::string corners = "\"bilinearmesh\" \"point3 P\" [0 0 0  1 0 0  0 1 0  1 1 0]";
    EXPECT_THAT(shape(corners).mesh->indices, ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(shape(corners + " \"integer indices\" [3 2 1 0]").mesh->indices, ElementsAre(3, 2, 1, 0));
}

TEST_F(PbrtShapes, plyFilesAreReadOnce) {
    write("m.ply", "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 2\n"
                   "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n4 0 1 2 3\n");
    const Scene scene =
        world("Shape \"plymesh\" \"string filename\" \"m.ply\" Translate 1 0 0 Shape \"plymesh\" \"string filename\" \"m.ply\"");
    ASSERT_EQ(scene.shapes.size(), 4u);  // triangles and quadrilaterals apart, twice
    EXPECT_EQ(scene.shapes[0].mesh, scene.shapes[2].mesh);
    EXPECT_EQ(scene.shapes[3].kind, &kindOf(shape_bilinear));
    expectNear(apply(scene.shapes[3].worldFromObject, {0, 0, 0}), {1, 0, 0});
    EXPECT_FALSE(scene.shapes.at(0).displacement);
    EXPECT_THAT(errorOfWorld("Shape \"plymesh\""), HasSubstr("needs a \"string filename\""));
}

/// All faces as triangles: pbrt-v4 cuts quadrilaterals from their first corner to their third.
TEST_F(PbrtShapes, displacedMeshes) {
    write("m.ply", "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 2\n"
                   "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n4 0 1 2 3\n");
    const std::string waves = "Texture \"waves\" \"float\" \"windy\" ", mesh = "Shape \"plymesh\" \"string filename\" \"m.ply\" ";
    const Scene scene = world(waves + mesh + "\"texture displacement\" \"waves\" \"float edgelength\" .25");
    EXPECT_THAT(warnings_, IsEmpty());
    ASSERT_EQ(scene.shapes.size(), 1u);
    EXPECT_THAT(scene.shapes[0].mesh->indices, ElementsAre(0, 1, 2, 0, 1, 2, 0, 2, 3));
    EXPECT_EQ(scene.shapes[0].displacement->edgeLength, .25);
    EXPECT_EQ(scene.textures[static_cast<size_t>(scene.shapes[0].displacement->texture)].name, "waves");
    EXPECT_EQ(read("Option \"displacementedgescale\" 4\nWorldBegin " + waves + mesh + "\"texture displacement\" \"waves\"")
                  .shapes[0]
                  .displacement->edgeLength,
              4);
    EXPECT_THAT(errorOf("Option \"displacementedgescale\" 0\nWorldBegin"),
                HasSubstr("test.pbrt:1:8: option \"displacementedgescale\": \"float displacementedgescale\" is 0; it must be in (0, inf)"));
    EXPECT_THAT(errorOfWorld(waves + mesh + "\"texture displacement\" \"waves\" \"float edgelength\" 0"),
                HasSubstr("\"float edgelength\" is 0; it must be in (0, inf)"));
    write("edge.ply",
          "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list "
          "uchar int vertex_indices\nend_header\n"
          "0 0 0\n1 0 0\n2 0 1\n");
    EXPECT_THAT(world(waves + "Shape \"plymesh\" \"string filename\" \"edge.ply\" \"texture displacement\" \"waves\"").shapes, IsEmpty());
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("1 faces with fewer than three corners, which are skipped")));
    EXPECT_THAT(errorOfWorld(mesh + "\"texture displacement\" \"waves\""), HasSubstr("there is no float texture \"waves\""));
}

TEST_F(PbrtShapes, plyFilesWithUnknownLinesInTheirHeader) {
    write("blender.ply",
          "ply\nformat ascii 1.0\nCreated by Blender\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
          "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n");
    EXPECT_EQ(world("Shape \"plymesh\" \"string filename\" \"blender.ply\"").shapes.size(), 1u);
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("blender.ply\" has an unknown keyword in line 3 of its header; the line is skipped")));
}

TEST_F(PbrtShapes, plyFilesWithMoreThanTheirHeaderSays) {
    write("more.ply",
          "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
          "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n3 2 1 0\n");
    const std::string mesh = "Shape \"plymesh\" \"string filename\" \"more.ply\" ";
    EXPECT_EQ(world(mesh).shapes.size(), 1u);
    EXPECT_THAT(warnings_, ElementsAre(AllOf(HasSubstr("warning: \""), HasSubstr("more.ply\" has more data than the element counts of "
                                                                                "its header say: line 14 and what follows are skipped"))));
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty uchar x\nproperty uchar y\nproperty uchar z\nelement face 1\n"
        "property list uchar uchar vertex_indices\nend_header\n";
    for (const char byte : {0, 0, 0, 1, 0, 0, 1, 1, 0, 3, 0, 1, 2}) bytes += byte;
    write("bytes.ply", bytes + std::string("\n\0", 2));
    const std::string binary = "Shape \"plymesh\" \"string filename\" \"bytes.ply\" ";
    EXPECT_THAT(warningsOfWorld(binary), IsEmpty());
    write("bytes.ply", bytes + "\3\2\1");
    EXPECT_THAT(warningsOfWorld(binary), ElementsAre(HasSubstr("its header say: its last 3 bytes are skipped")));
}

TEST_F(PbrtShapes, tangents) {
    EXPECT_THAT(shape(triangle + "\"vector3 S\" [1 0 0  0 1 0  0 0 1]").mesh->tangents,
                ElementsAre(glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)));
    EXPECT_THAT(warnings_, IsEmpty());
    EXPECT_THAT(shape(triangle + "\"vector3 S\" [1 0 0]").mesh->tangents, IsEmpty());
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("\"S\" is ignored: it has 1 vertices, and \"P\" has 3")));
}

TEST_F(PbrtShapes, alpha) {
    EXPECT_EQ(shape("\"sphere\"").alpha.value.value(), 1);
    EXPECT_EQ(shape("\"sphere\" \"float alpha\" .25").alpha.value.value(), .25);
    const Scene scene = world("Texture \"leaf\" \"float\" \"checkerboard\" Shape \"sphere\" \"texture alpha\" \"leaf\"");
    EXPECT_EQ(scene.textures[scene.shapes[0].alpha.texture].name, "leaf");
    /* pbrt-v4 hides a lamp of such an alpha from rays, and keeps its light */
    const Shape hidden = shape("\"sphere\" \"texture alpha\" \"zero\"\nTexture \"zero\" \"float\" \"constant\" \"float value\" 0");
    EXPECT_EQ(hidden.alpha.texture, none);
    EXPECT_EQ(hidden.alpha.value.value(), 0);
}

TEST_F(PbrtShapes, reverseOrientationToggles) {
    const Scene scene = world("ReverseOrientation Shape \"sphere\" ReverseOrientation Shape \"sphere\"");
    EXPECT_TRUE(scene.shapes[0].reverseOrientation);
    EXPECT_FALSE(scene.shapes[1].reverseOrientation);
}

TEST_F(PbrtShapes, objectsAndInstances) {
    const Scene scene = world(R"(
        ObjectInstance "o"
        Translate 1 0 0
        ObjectBegin "o" Translate 0 1 0 Shape "sphere" ObjectEnd
        ObjectInstance "o")");
    EXPECT_THAT(scene.shapes, IsEmpty());
    ASSERT_EQ(scene.objects.size(), 1u);
    expectNear(apply(scene.objects[0].shapes[0].worldFromObject, {0, 0, 0}), {1, 1, 0});  // what holds at ObjectBegin counts, as in pbrt-v4
    ASSERT_EQ(scene.instances.size(), 2u);
    expectNear(apply(scene.instances[0].worldFromObject, {0, 0, 0}), {0, 0, 0});
    expectNear(apply(scene.instances[1].worldFromObject, {0, 0, 0}), {1, 0, 0});
    EXPECT_EQ(scene.instances[0].object, 0);
}

TEST_F(PbrtShapes, objectsThatMakeNoSense) {
    EXPECT_THAT(errorOfWorld("ObjectBegin \"tree\" ObjectEnd ObjectInstance \"treee\""),
                HasSubstr("there is no object \"treee\"; did you mean \"tree\"?"));
    EXPECT_THAT(errorOfWorld("ObjectBegin \"a\" ObjectBegin \"b\" ObjectEnd ObjectEnd"), HasSubstr("ObjectBegin inside the object \"a\""));
    EXPECT_THAT(errorOfWorld("ObjectBegin \"a\" ObjectEnd ObjectBegin \"a\" ObjectEnd"), HasSubstr("there is already an object \"a\""));
    EXPECT_THAT(errorOfWorld("ObjectBegin \"a\" ObjectInstance \"a\" ObjectEnd"), HasSubstr("objects cannot contain instances"));
}

}  // namespace
}  // namespace eikonal
