// The stages that make rays and meet surfaces, alone: queue in, queue out. Empty, with one item, and full;
// no word of an item that is alive may be the poison of a forgotten field.

#include "stage_fixture.h"

#include <set>

namespace eikonal {
namespace {

TEST_F(StageTest, GenerateRaysFillsEverySlotOfTheImage) {
    generate();
    const QueueWords rays = bench.read("ray"), states = bench.read("path");
    std::set<std::pair<uint, uint>> places;
    for (size_t i = 0; i < paths; ++i) {
        expectClean(rays, i);
        expectClean(states, i);
        ASSERT_EQ(rays.get<uint>("path", i), i);
        ASSERT_EQ(rays.get<uint>("sample", i) & 3u, i / (side * side)) << "of the pixel's four";
        ASSERT_EQ(rays.get<float>("t_max", i), FAR_AWAY);
        ASSERT_NEAR(lengthOf(rays.get<vec3>("d", i)), 1, 1e-6);
        ASSERT_EQ(rays.get<spectrum>("beta", i).g, 1);
        ASSERT_EQ(states.get<spectrum>("L", i).g, 0);
        places.emplace(rays.get<uint>("seed", i), rays.get<uint>("sample", i));
    }
    EXPECT_EQ(places.size(), paths) << "each has its own place in the random sequences";
}

/// What a block reaches beyond the image is dead and weighs nothing.
TEST_F(StageTest, GenerateRaysLeavesSlotsOutsideDead) {
    generate(paths, 10, 7);
    const QueueWords rays = bench.read("ray"), states = bench.read("path");
    for (size_t i = 0; i < paths; ++i) {
        const bool inside = i % side < 10 && i / side % side < 7;
        ASSERT_EQ(rays.get<float>("t_max", i) > 0, inside) << i;
        if (!inside) { ASSERT_EQ(states.get<float>("weight", i), 0); }
    }
}

/// Blocks in any order, and some with fewer samples than others: a slot holds the same ray as where the whole image is one block.
TEST_F(StageTest, GenerateRaysOfSeveralBlocks) {
    generate();
    const QueueWords whole = bench.read("ray");
    const Batch batch{{2, 3}, {{12, 8, 1, 2}, {0, 0, 0, 4}, {4, 8, 3, 1}}};
    bench.set(batch, side, side);
    bench.run("generate_rays", batch.paths());
    const QueueWords rays = bench.read("ray");
    size_t slot = 0;
    for (const Block& b : batch.blocks)
        for (unsigned sample = b.firstSample; sample < b.firstSample + b.samples; ++sample)
            for (int y = 0; y < 8; ++y)
                for (int x = 0; x < 4; ++x, ++slot) {
                    const size_t same = sample * side * side + static_cast<size_t>(b.y + y) * side + static_cast<size_t>(b.x + x);
                    ASSERT_EQ(rays.get<uint>("seed", slot), whole.get<uint>("seed", same)) << slot;
                    ASSERT_EQ(rays.get<uint>("sample", slot), whole.get<uint>("sample", same)) << slot;
                    ASSERT_EQ(rays.get<vec3>("d", slot).x, whole.get<vec3>("d", same).x) << slot;
                }
    EXPECT_EQ(slot, batch.paths());
}

TEST_F(StageTest, IntersectRaysEmptyOneAndFull) {
    generate();
    bench.run("intersect_rays", 0);
    QueueWords intersections = bench.read("intersection");
    EXPECT_EQ(intersections.words(), bench.empty("intersection").words()) << "nothing to do, yet something was written";

    bench.run("intersect_rays", 1);
    intersections = bench.read("intersection");
    expectClean(intersections, 0);
    for (size_t i = 1; i < intersections.capacity(); ++i) ASSERT_EQ(intersections.get<uint>("t", i), poison) << i;

    bench.run("intersect_rays", paths);
    intersections = bench.read("intersection");
    size_t hit = 0;
    for (size_t i = 0; i < paths; ++i) {
        expectClean(intersections, i);
        ASSERT_GT(intersections.get<float>("t", i), 0);
        hit += intersections.get<uint>("element", i) != NONE;
    }
    EXPECT_GT(hit, paths / 4);
    EXPECT_LT(hit, paths);
}

TEST_F(StageTest, IntersectRaysPassesOverDeadSlots) {
    generate(paths, 10, 7);
    bench.run("intersect_rays", paths);
    const QueueWords rays = bench.read("ray"), intersections = bench.read("intersection");
    for (size_t i = 0; i < paths; ++i) ASSERT_EQ(intersections.get<float>("t", i) < 0, rays.get<float>("t_max", i) < 0) << i;
}

}  // namespace
}  // namespace eikonal
