// Sparse grids on the device against the NanoVDB library's own lookup.

#include "nanovdb_file.h"   // before include/eikonal

#include "medium_walk.h"
#include "random_inputs.h"

#include <gtest/gtest.h>

namespace eikonal {
namespace {

/// Between voxels a packed NanoVDB grid gives what the library's own sampler gives.
TEST(SparseGrids, AreSampledAsTheLibraryDoes) {
    const PackedScene packed = sceneWith("nanovdb", parametersOf("nanovdb"));
    const DeviceScene onDevice(testContext(), packed);
    const DeviceFunction<vec2> lookup({.include = "medium/medium.clh",
                                       .type = "vec2",
                                       .body = R"(
        medium_tables medium_set = BIND_MEDIA;
        vec3 p = transform_point(medium_set.media[0].box_from_scene, at);
        result = make_vec2(lookup_grid(medium_set, medium_set.media[0].density, p), lookup_grid(medium_set, medium_set.media[0].temperature,
            p));)",
                                       .inputs = {"vec3 at"},
                                       .tables = "MEDIUM_TABLES(TABLE) COLOR_TABLES(TABLE)"});
    Random random(11);
    std::vector<vec3> points;
    for (int i = 0; i < 5000; ++i) points.push_back(random.box(0.7f));
    const auto found = lookup.with(onDevice, points);
    const std::string path = nanoVdbFile();
    for (const bool hot : {false, true}) {
        const auto handle = nanovdb::io::readGrid(path, std::string(hot ? "temperature" : "density"));
        const auto* grid = handle.grid<float>();
        const auto sampler = nanovdb::createSampler<1>(grid->tree());
        for (size_t i = 0; i < points.size(); ++i) {
            const float expected = sampler(grid->worldToIndexF(nanovdb::Vec3f(points[i].x, points[i].y, points[i].z)));
            EXPECT_NEAR(hot ? found[i].y : found[i].x, expected, hot ? 0.1 : 1e-4);
        }
    }
}

}  // namespace
}  // namespace eikonal
