#include "bench_scene.h"

#include "commands/scene_loading.h"
#include "pack/pack.h"

#include <glm/glm.hpp>

namespace eikonal {

BenchMesh loadMesh(const std::string& path) {
    Diagnostics diagnostics;
    SceneOptions options;
    options.path = path;
    const PackedScene scene = packScene(loadScene(options, diagnostics), diagnostics);
    BenchMesh mesh;
    mesh.name = path;
    mesh.positions.assign(scene.tables.positions.begin(), scene.tables.positions.end());
    for (uint element = 0; element < scene.tables.element_shapes.size(); ++element) {
        const shape& s = scene.tables.shapes[scene.tables.element_shapes[element]];
        if (s.kind != shape_triangle) continue;
        for (uint i = 0; i < 3; ++i) mesh.indices.push_back(s.first_vertex + scene.tables.indices[s.first_index + 3 * (element - s.first_element) + i]);
    }
    const affine& m = scene.tables.frame[0].view.scene_from_camera;
    mesh.eye = {m.xw, m.yw, m.zw};
    mesh.target = {mesh.eye.x + m.xz, mesh.eye.y + m.yz, mesh.eye.z + m.zz};
    mesh.lightLow = mesh.lightHigh = mesh.positions.at(0);
    for (const vec3& p : mesh.positions) {
        mesh.lightLow = {std::min(mesh.lightLow.x, p.x), std::min(mesh.lightLow.y, p.y), std::min(mesh.lightLow.z, p.z)};
        mesh.lightHigh = {std::max(mesh.lightHigh.x, p.x), std::max(mesh.lightHigh.y, p.y), std::max(mesh.lightHigh.z, p.z)};
    }
    return mesh;
}

}  // namespace eikonal
