#include "bench_scene.h"

#include "render/scene_loading.h"
#include "pack/pack.h"

#include <algorithm>
#include <stdexcept>

namespace eikonal {

BenchMesh loadMesh(const std::string& path) {
    Diagnostics diagnostics;
    SceneOptions options;
    options.path = path;
    const auto [scene, hierarchies] = packTables(loadScene(options, diagnostics), diagnostics);
    BenchMesh mesh;
    mesh.name = path;
    mesh.positions.assign(scene.tables.positions.begin(), scene.tables.positions.end());
    for (const Group::Triangles& t : hierarchies.world.triangles)
        for (size_t i = 0; i < 3 * t.count; ++i)
            mesh.indices.push_back(static_cast<uint>(t.firstVertex) + scene.tables.indices[t.firstIndex + i]);
    if (mesh.indices.empty()) throw std::runtime_error(path + " has no triangles but in objects that are placed");
    const affine& m = scene.tables.frame[0].view.scene_from_camera;
    mesh.eye = {m.xw, m.yw, m.zw};
    mesh.target = {mesh.eye.x + m.xz, mesh.eye.y + m.yz, mesh.eye.z + m.zz};
    mesh.lightLow = mesh.lightHigh = mesh.positions[mesh.indices[0]];
    for (const uint i : mesh.indices) {
        const vec3& p = mesh.positions[i];
        mesh.lightLow = {std::min(mesh.lightLow.x, p.x), std::min(mesh.lightLow.y, p.y), std::min(mesh.lightLow.z, p.z)};
        mesh.lightHigh = {std::max(mesh.lightHigh.x, p.x), std::max(mesh.lightHigh.y, p.y), std::max(mesh.lightHigh.z, p.z)};
    }
    return mesh;
}

}  // namespace eikonal
