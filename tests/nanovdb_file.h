#pragma once
// Small NanoVDB files, made by the library's own builder.

/* As in host/read/formats/nanovdb.cpp: the library's functions are inline, and there must be one of each */
#define NANOVDB_USE_ZIP
#define NANOVDB_USE_BLOSC
#include <nanovdb/util/GridBuilder.h>
#include <nanovdb/util/IO.h>
#include <nanovdb/util/SampleFromVoxels.h>

#include <functional>
#include <string>
#include <vector>

namespace eikonal {

/// A grid of a file: its values at voxels -half ... half - 1 along each side; voxels are of that size, the middle one at the origin.
struct TestGrid {
    std::string name;
    int half = 16;
    double voxelSize = 1;
    std::function<float(int, int, int)> value;
    nanovdb::GridClass gridClass = nanovdb::GridClass::FogVolume;
};

inline nanovdb::GridHandle<> makeNanoVdb(const TestGrid& grid) {
    nanovdb::GridBuilder<float> builder(0, grid.gridClass);
    auto accessor = builder.getAccessor();
    for (int x = -grid.half; x < grid.half; ++x)
        for (int y = -grid.half; y < grid.half; ++y)
            for (int z = -grid.half; z < grid.half; ++z)
                if (const float value = grid.value(x, y, z); value != 0) accessor.setValue({x, y, z}, value);
    return builder.getHandle<>(grid.voxelSize, nanovdb::Vec3d(0), grid.name);
}

/// The ways to compress a file.
constexpr nanovdb::io::Codec nanoVdbCodecs[] = {nanovdb::io::Codec::NONE, nanovdb::io::Codec::ZIP, nanovdb::io::Codec::BLOSC};

inline void writeNanoVdb(const std::string& path, const std::vector<TestGrid>& grids, nanovdb::io::Codec codec = nanoVdbCodecs[0]) {
    std::vector<nanovdb::GridHandle<>> handles;
    for (const TestGrid& grid : grids) handles.push_back(makeNanoVdb(grid));
    nanovdb::io::writeGrids(path, handles, codec);
}

}  // namespace eikonal
