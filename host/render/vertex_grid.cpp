#include "render/vertex_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <numeric>

namespace eikonal {

static size_t bytesOfVertices(const VertexPlan& plan, const Features& features) {
    return plan.vertices * static_cast<size_t>(vertexLayout(features).words) * sizeof(uint);
}
static size_t bytesOfGrid(const VertexPlan& plan, const Features& features) {
    return (plan.buckets + plan.vertices * static_cast<size_t>(gridLayout(features).words)) * sizeof(uint);
}

size_t plannedVertexBytes(const PackedScene& scene) {
    const VertexPlan plan = planVertices(scene);
    return plan.passes ? bytesOfVertices(plan, scene.features) + bytesOfGrid(plan, scene.features) : 0;
}

VertexGrid::VertexGrid(const Context& context, const PackedScene& scene)
    : context_(context),
      plan_(planVertices(scene)),
      layout_(vertexLayout(scene.features)),
      vertices_(context, std::max(bytesOfVertices(plan_, scene.features), sizeof(uint)), "light vertices"),
      count_(context, sizeof(uint), "the number of light vertices"),
      grid_(context, bytesOfGrid(plan_, scene.features), "the grid of light vertices") {
    bindings_.set("vertex", vertices_);
    bindings_.set("vertex_count", count_);
    bindings_.set("vertex_capacity", static_cast<uint>(plan_.vertices));
    bindings_.set("grid", grid_);
    bindings_.set("grid_buckets", 1u);
}

void VertexGrid::clear() {
    count_.clear(context_, 0, sizeof(uint));
    grid_.clear(context_, 0, sizeof(uint));
    bindings_.set("grid_buckets", 1u);
}

uint VertexGrid::countStored() const {
    uint stored = 0;
    count_.read(context_, &stored, sizeof stored);
    if (stored > plan_.vertices)
        throw DeviceError(fmt::format("light paths have left {} vertices, and there is room for {}; a lower \"maxdepth\" leaves fewer",
                                      stored, plan_.vertices));
    return stored;
}

SurfacePoints VertexGrid::stored() const {
    const size_t words = static_cast<size_t>(layout_.words);
    std::vector<float> records(countStored() * words);
    if (records.empty()) return {};
    vertices_.read(context_, records.data(), records.size() * sizeof(float));
    SurfacePoints all;
    const auto vector = [&](size_t record, const char* field) {
        const float* at = &records[record + static_cast<size_t>(layout_.field(field).slot)];
        return vec3{at[0], at[1], at[2]};
    };
    for (size_t record = 0; record < records.size(); record += words) {
        all.points.push_back(vector(record, "p"));
        all.normals.push_back(vector(record, "ng"));
    }
    return all;
}

void VertexGrid::build(const Stages& stages, const StageLauncher& launcher) {
    const uint stored = countStored();
    std::vector<uint> begins(std::min(std::bit_ceil(size_t{stored} + 1), plan_.buckets));
    const auto buckets = static_cast<uint>(begins.size());
    bindings_.set("grid_buckets", buckets);
    grid_.clear(context_, 0, buckets * sizeof(uint));
    launcher.launch(stages.find(StageName::count_vertices), {0, stored});
    grid_.read(context_, begins.data(), buckets * sizeof(uint));
    std::exclusive_scan(begins.begin(), begins.end(), begins.begin(), 0u);
    grid_.write(context_, begins.data(), buckets * sizeof(uint));
    launcher.launch(stages.find(StageName::place_vertices), {0, stored});
    launcher.launch(stages.find(StageName::order_vertices), {0, buckets});
}

}  // namespace eikonal
