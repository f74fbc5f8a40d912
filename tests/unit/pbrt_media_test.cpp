// Participating media. The defaults are those of pbrt-v4's source (media.cpp).

#include "nanovdb_file.h"
#include "kinds/medium_kind.h"
#include "read/formats/nanovdb.h"
#include "unit/pbrt_reading.h"
#include "unit/temporary_folder.h"

#include <fstream>

namespace eikonal {
namespace {

class PbrtMedia : public PbrtTest {
protected:
    Medium medium(const std::string& text) { return world("MakeNamedMedium \"m\" \"string type\" " + text).media.at(0); }
    std::string errorOfMedium(const std::string& text) { return errorOfWorld("MakeNamedMedium \"m\" \"string type\" " + text); }
};

const std::string fog = "MakeNamedMedium \"fog\" \"string type\" \"homogeneous\" ";

TEST_F(PbrtMedia, homogeneous) {
    const Medium plain = medium("\"homogeneous\"");
    EXPECT_EQ(plain.name, "m");
    EXPECT_EQ(plain.sigmaA.value(), 1);
    EXPECT_EQ(plain.sigmaS.value(), 1);
    EXPECT_EQ(plain.Le.value(), 0);
    EXPECT_EQ(plain.g, 0);
    const Medium m = medium(
        "\"homogeneous\" \"rgb sigma_a\" [1 2 3] \"rgb sigma_s\" [4 5 6] \"float scale\" 2 \"rgb Le\" [1 1 0] \"float Lescale\" 3 \"float "
        "g\" -.5");
    expectNear(m.sigmaA.albedo(), {2, 4, 6});
    expectNear(m.sigmaS.albedo(), {8, 10, 12});
    expectNear(m.Le.illuminant(), {3, 3, 0});
    EXPECT_EQ(m.g, -.5);
}

/// As in pbrt-v4, a medium emits in proportion to its absorption, which is 1 unless it is given.
TEST_F(PbrtMedia, whatDoesNotAbsorbDoesNotShine) {
    medium("\"homogeneous\" \"rgb Le\" [1 1 1]");
    EXPECT_THAT(warnings_, IsEmpty());
    medium("\"homogeneous\" \"rgb Le\" [1 1 1] \"rgb sigma_a\" [0 0 0]");
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("medium \"m\" emits no light, as in pbrt-v4: only what absorbs shines")));
    medium("\"homogeneous\" \"rgb sigma_a\" [0 0 0]");
    EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(PbrtMedia, presetsAreMeasurements) {
    expectNear(medium("\"homogeneous\" \"string preset\" \"Skin1\" \"float scale\" 10").sigmaA.albedo(), {.32, 1.7, 4.8});
    EXPECT_EQ(medium("\"homogeneous\" \"string preset\" \"Skin3\"").sigmaS.value(), 1);
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("there is no preset \"Skin3\"; did you mean \"Skin")));
}

TEST_F(PbrtMedia, uniformGrids) {
    const Scene scene = world(
        "Scale 2 2 2 MakeNamedMedium \"m\" \"string type\" \"uniformgrid\" \"integer nx\" 2 \"integer ny\" 3 "
        "\"float density\" [0 1 2 3 4 5] \"float Lescale\" [1 1 1 1 1 1] \"rgb Le\" [1 1 1] \"point3 p1\" [1 2 3] \"float scale\" 4");
    const Medium& m = scene.media[0];
    EXPECT_STREQ(m.kind->name, "uniformgrid");
    EXPECT_EQ(m.density.nx, 2);
    EXPECT_EQ(m.density.nz, 1);
    EXPECT_EQ(m.density.values.size(), 6u);
    EXPECT_EQ(m.LeScale.values.size(), 6u);
    EXPECT_EQ(m.sigmaA.value(), 4);
    expectNear(m.p0, {0, 0, 0});
    expectNear(m.p1, {1, 2, 3});
    expectNear(apply(m.worldFromMedium, {1, 0, 0}), {2, 0, 0});
    EXPECT_THAT(errorOfMedium("\"uniformgrid\" \"integer nx\" 2 \"float density\" [1]"),
                HasSubstr("has 1 values; nx * ny * nz = 2 * 1 * 1 = 2 are expected"));
    EXPECT_THAT(errorOfMedium("\"uniformgrid\""), HasSubstr("needs \"float density\""));
    EXPECT_THAT(errorOfMedium("\"uniformgrid\" \"integer nx\" 0 \"float density\" 1"), HasSubstr("must be at least 1"));
    EXPECT_THAT(
        errorOfMedium("\"uniformgrid\" \"integer nx\" 2000000000 \"integer ny\" 2000000000 \"integer nz\" 2000000000 \"float density\" 1"),
        HasSubstr("are expected"));
}

TEST_F(PbrtMedia, interfacesAreWhereMediaChange) {
    const Scene scene = world(fog +
                              "MediumInterface \"fog\" \"\" Shape \"sphere\" MediumInterface \"\" \"fog\" Shape \"sphere\" "
                              "MediumInterface \"fog\" Shape \"sphere\"");
    EXPECT_EQ(scene.shapes[0].interface->inside, 0);
    EXPECT_EQ(scene.shapes[0].interface->outside, none);
    EXPECT_EQ(scene.shapes[1].interface->inside, none);
    EXPECT_EQ(scene.shapes[1].interface->outside, 0);
    EXPECT_FALSE(scene.shapes[2].interface.has_value());  // the same on both sides: a ray keeps its medium
}

TEST_F(PbrtMedia, names) {
    EXPECT_EQ(world("MediumInterface \"fog\" \"\" Shape \"sphere\" " + fog).shapes[0].interface->inside, 0);
    EXPECT_THAT(errorOfWorld(fog + "MediumInterface \"frog\" \"\" Shape \"sphere\" Shape \"disk\""),
                HasSubstr("there is no medium \"frog\"; did you mean \"fog\"?"));
    EXPECT_THAT(errorOfWorld(fog + fog), HasSubstr("there is already a medium \"fog\", at test.pbrt:2:1"));
    EXPECT_THAT(errorOfWorld("MakeNamedMedium \"m\""), HasSubstr("MakeNamedMedium needs a \"string type\""));
    EXPECT_EQ(world("MediumInterface \"never made\" \"\"").media.size(), 0u);  // nothing uses it
}

TEST_F(PbrtMedia, gridsMayShine) {
    const std::string grid = "\"uniformgrid\" \"integer nx\" 2 \"float density\" [0 1] ";
    const Medium hot = medium(
        grid + "\"float temperature\" [300 2000] \"float temperaturecutoff\" 10 \"float temperaturescale\" 3 \"float Lescale\" [1 2]");
    EXPECT_THAT(hot.temperature.values, ElementsAre(300, 2000));
    EXPECT_THAT(hot.LeScale.values, ElementsAre(1, 2));
    EXPECT_EQ(hot.temperatureOffset, 10);
    EXPECT_EQ(medium(grid + "\"float temperatureoffset\" 5 \"float temperaturecutoff\" 10").temperatureOffset, 5);
    EXPECT_EQ(hot.temperatureScale, 3);
    EXPECT_EQ(medium(grid).LeScale.values.size(), 1u);  // as in pbrt-v4: one value, for the whole grid
    EXPECT_THAT(errorOfMedium(grid + "\"float temperature\" [1 2] \"rgb Le\" [1 1 1]"), HasSubstr("both \"Le\" and \"temperature\""));
    EXPECT_THAT(errorOfMedium(grid + "\"float temperature\" [1 2 3]"),
                HasSubstr("has 3 values; nx * ny * nz = 2 * 1 * 1 = 2 are expected"));
    EXPECT_THAT(errorOfMedium("\"uniformgrid\" \"float density\" [-1]"), HasSubstr("a value below 0: -1"));
    EXPECT_THAT(errorOfMedium(grid + "\"point3 p1\" [1 0 1]"), HasSubstr("is flat"));
    EXPECT_THAT(errorOfWorld("Scale 1 0 1 MakeNamedMedium \"m\" \"string type\" " + grid), HasSubstr("cannot be inverted"));
}

TEST_F(PbrtMedia, rgbGrids) {
    const Medium m = medium(
        "\"rgbgrid\" \"integer ny\" 2 \"rgb sigma_a\" [1 2 3 4 5 6] \"rgb Le\" [0 0 0 1 1 1] \"float scale\" 4 \"float Lescale\" 2 \"float "
        "g\" .5 \"point3 p0\" [-1 -1 -1]");
    EXPECT_STREQ(m.kind->name, "rgbgrid");
    EXPECT_EQ(m.colors.ny, 2);
    ASSERT_EQ(m.colors.sigmaA.size(), 2u);
    EXPECT_EQ(m.colors.sigmaA[1], glm::vec3(4, 5, 6));
    EXPECT_TRUE(m.colors.sigmaS.empty());
    EXPECT_EQ(m.sigmaA.value(), 4);
    EXPECT_EQ(m.g, .5);
    EXPECT_NEAR(m.emissionScale, 2 * 106.857, 0.01);  // times the integral of the matching function y
    EXPECT_THAT(errorOfMedium("\"rgbgrid\""), HasSubstr("needs \"rgb sigma_a\" or \"rgb sigma_s\""));
    EXPECT_THAT(errorOfMedium("\"rgbgrid\" \"rgb sigma_s\" [1 1 1] \"rgb Le\" [1 1 1]"), HasSubstr("\"rgb Le\" needs \"rgb sigma_a\""));
    EXPECT_THAT(errorOfMedium("\"rgbgrid\" \"rgb sigma_s\" [1 1 1 1]"), HasSubstr("a multiple of 3 is expected"));
    EXPECT_THAT(errorOfMedium("\"rgbgrid\" \"rgb sigma_s\" [1 1 1 1 1 1]"),
                HasSubstr("has 2 values; nx * ny * nz = 1 * 1 * 1 = 1 are expected"));
    EXPECT_THAT(errorOfMedium("\"rgbgrid\" \"rgb sigma_s\" [1 -1 1]"), HasSubstr("below 0"));
}

TEST_F(PbrtMedia, clouds) {
    const Medium m = medium("\"cloud\"");
    EXPECT_STREQ(m.kind->name, "cloud");
    EXPECT_EQ(m.noiseDensity, 1);
    EXPECT_EQ(m.wispiness, 1);
    EXPECT_EQ(m.frequency, 5);
    expectNear(m.p1, {1, 1, 1});
    EXPECT_EQ(medium("\"cloud\" \"float density\" 2 \"float wispiness\" 0 \"float frequency\" 3").wispiness, 0);
}

TEST_F(PbrtMedia, nanoVdbFiles) {
    const std::string file = path("smoke.nvdb");
    const auto value = [](int x, int y, int z) { return float(100 + 10 * x + y) + 0.1f * float(z); };
    for (const auto codec : nanoVdbCodecs) {
        writeNanoVdb(file, {{"density", 5, 0.5, value}, {"fire", 2, 0.5, value}}, codec);
        const Medium m = medium(
            "\"nanovdb\" \"string temperaturename\" \"fire\" \"float Lescale\" 3 \"float temperaturescale\" 7 \"string filename\" \"" +
            file + "\"");
        EXPECT_STREQ(m.kind->name, "nanovdb");
        EXPECT_EQ(m.emissionScale, 3);
        EXPECT_EQ(m.temperatureScale, 7);
        const SparseGrid& grid = *m.sparseDensity;
        EXPECT_EQ(grid.low, glm::ivec3(-5));
        EXPECT_EQ(grid.high, glm::ivec3(4));
        expectNear(apply(grid.voxelFromMedium, {1, 2, -3}), {2, 4, -6});
        /* Voxel (3, -4, 2): block (0, -1, 0), the fifth along y in it */
        const glm::ivec3 block = glm::ivec3(0, -1, 0) - grid.firstBlock;
        const std::uint32_t stored = grid.blockOf[static_cast<size_t>((block.z * grid.blocks.y + block.y) * grid.blocks.x + block.x)];
        EXPECT_EQ(grid.values[512 * stored + (2 * 8 + 4) * 8 + 3], value(3, -4, 2));
        EXPECT_EQ(m.sparseTemperature->high, glm::ivec3(1));
    }
    const std::string named = "\"nanovdb\" \"string filename\" \"" + file + "\" ";
    EXPECT_EQ(medium(named).sparseTemperature, nullptr);  // there need not be a "temperature"
    EXPECT_THAT(errorOfMedium(named + "\"string gridname\" \"smoke\""), HasSubstr("has no grid \"smoke\"; it has \"density\", \"fire\""));
    EXPECT_THAT(errorOfMedium(named + "\"string temperaturename\" \"ice\""), HasSubstr("has no grid \"ice\""));
    EXPECT_THAT(errorOfMedium("\"nanovdb\""), HasSubstr("needs a \"string filename\""));
    EXPECT_THAT(errorOfMedium("\"nanovdb\" \"string filename\" \"nowhere.nvdb\""), HasSubstr("nowhere.nvdb"));
}

// A file that was cut off, or of which bytes are wrong, is an error with its name or still a grid; nothing else happens.
TEST_F(PbrtMedia, damagedNanoVdbFiles) {
    const std::string file = path("smoke.nvdb");
    writeNanoVdb(file, {{"density", 3, 1, [](int, int, int) { return 1.f; }}});
    const std::vector<char> whole = readBytes(file);
    const auto rewrite = [&](const std::vector<char>& bytes) {
        std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    };
    const auto read = [&] {
        try {
            (void)readNanoVdb(file, "density");
            return std::string();
        } catch (const ReadProblem& problem) { return std::string(problem.what()); }
    };
    for (size_t size : {size_t{1}, size_t{20}, size_t{150}, size_t{1000}, whole.size() / 2, whole.size() - 1}) {
        rewrite({whole.begin(), whole.begin() + static_cast<long>(size)});
        EXPECT_THAT(read(), HasSubstr(size == 1000 || size > 1000 ? "" : "ends too early")) << size;
        EXPECT_NE(read(), "") << size;
    }
    rewrite(std::vector<char>(1000, 'x'));
    EXPECT_THAT(read(), HasSubstr("is not a NanoVDB file"));
    /* Bytes of the headers and the first nodes, and some of the rest */
    for (size_t at = 0; at < whole.size(); at += at < 2000 ? 13 : 9001)
        for (const int value : {0x00, 0xff}) {
            std::vector<char> bytes = whole;
            bytes[at] = static_cast<char>(value);
            rewrite(bytes);
            (void)read();
        }
    writeNanoVdb(file, {{"density", 3, 1, [](int, int, int) { return 1.f; }, nanovdb::GridClass::LevelSet}});
    EXPECT_THAT(read(), HasSubstr("is a level set"));
}

// A homogeneous medium has no place, and so nothing that moves.
TEST_F(PbrtMedia, whatMovesHasASecondPlace) {
    const auto read = [&](const std::string& transforms, const std::string& kind) {
        return world(transforms + "\nMakeNamedMedium \"m\" \"string type\" \"" + kind + "\"").media[0];
    };
    const Medium moving = read("ActiveTransform EndTime Translate 1 0 0", "cloud");
    ASSERT_TRUE(moving.worldFromMediumAtEnd);
    expectNear(apply(moving.worldFromMedium, {0, 0, 0}), {0, 0, 0});
    expectNear(apply(*moving.worldFromMediumAtEnd, {0, 0, 0}), {1, 0, 0});
    EXPECT_FALSE(read("Translate 1 0 0", "cloud").worldFromMediumAtEnd);
    EXPECT_FALSE(read("ActiveTransform EndTime Translate 1 0 0", "homogeneous").worldFromMediumAtEnd);
    EXPECT_THAT(warnings_, IsEmpty());
    EXPECT_THAT(errorOfWorld("ActiveTransform EndTime Scale 0 1 1 MakeNamedMedium \"m\" \"string type\" \"cloud\""),
                HasSubstr("the medium's transform cannot be inverted"));
}

TEST_F(PbrtMedia, aPresetReplacesCoefficients) {
    EXPECT_THAT(
        warningsOfWorld("MakeNamedMedium \"m\" \"string type\" \"homogeneous\" \"string preset\" \"Skimmilk\" \"rgb sigma_a\" [1 1 1]"),
        ElementsAre("test.pbrt:2:76: warning: medium \"homogeneous\": \"rgb sigma_a\" is ignored: nothing here uses it"));
}

/// Small files that describe a lot take no memory and no time.
class NanoVdbBomb : public PbrtMedia {
protected:
    using Tree = nanovdb::FloatTree;
    using Upper = Tree::Node2;
    using Lower = Tree::Node1;

    /// Two voxels far apart: two nodes below the root, each with one path of children.
    NanoVdbBomb() {
        nanovdb::GridBuilder<float> builder(0, nanovdb::GridClass::FogVolume);
        auto accessor = builder.getAccessor();
        accessor.setValue({0, 0, 0}, 1);
        accessor.setValue({4096, 0, 0}, 1);
        handle_ = builder.getHandle<>(1, nanovdb::Vec3d(0), "density");
    }
    Tree::RootType::DataType& root() { return *handle_.grid<float>()->tree().root().data(); }

    std::string reading() {
        std::vector<nanovdb::GridHandle<>> handles;
        handles.push_back(std::move(handle_));
        const std::string file = path("bomb.nvdb");
        nanovdb::io::writeGrids(file, handles, nanovdb::io::Codec::ZIP);
        EXPECT_LT(std::filesystem::file_size(file), 10'000u);
        try {
            (void)readNanoVdb(file, "density");
            return "";
        } catch (const ReadProblem& problem) {
            return problem.what();
        }
    }
    nanovdb::GridHandle<> handle_;
};

/// 32,768 children that are one node, of 4,096 children that are one leaf: 2^27 leaves of 2 KiB, 256 GiB.
TEST_F(NanoVdbBomb, NodesWithManyParents) {
    auto& upper = *reinterpret_cast<Upper::DataType*>(reinterpret_cast<char*>(&root()) + root().tile(0)->child);
    const auto share = [](auto& node, int first) {
        const auto* child = node.getChild(static_cast<std::uint32_t>(first));
        for (std::uint32_t i = 0; i < std::size(node.mTable); ++i) {
            node.mChildMask.setOn(i);
            node.setChild(i, child);
        }
    };
    auto& lower = *reinterpret_cast<Lower::DataType*>(upper.getChild(0));
    share(lower, 0);
    share(upper, 0);
    EXPECT_EQ(reading(), "is damaged: its nodes take more than the whole file");
}

/// The index of 1,024 x 512 x 512 blocks, of 4 bytes each, is more than 2,000 times the nodes of a single voxel.
TEST_F(NanoVdbBomb, BoundsBeyondAllNodes) {
    handle_ = [] {
        nanovdb::GridBuilder<float> builder(0, nanovdb::GridClass::FogVolume);
        builder.getAccessor().setValue({0, 0, 0}, 1);
        return builder.getHandle<>(1, nanovdb::Vec3d(0), "density");
    }();
    ASSERT_LT(2000. * static_cast<double>(handle_.size()), 4. * (1 << 28));
    root().mBBox = nanovdb::CoordBBox(nanovdb::Coord(0), nanovdb::Coord(8 * 1024 - 1, 8 * 512 - 1, 8 * 512 - 1));
    const std::string expected = "is damaged: nodes of " + std::to_string(handle_.size()) + " bytes cannot hold a grid of 2.68e+08 blocks";
    EXPECT_EQ(reading(), expected);
}

TEST_F(NanoVdbBomb, NodesInOnePlace) {
    root().tile(1)->key = root().tile(0)->key;
    EXPECT_EQ(reading(), "is damaged: two of its nodes are in one place");
}

}  // namespace
}  // namespace eikonal
