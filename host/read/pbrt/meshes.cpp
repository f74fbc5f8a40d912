#include "read/pbrt/meshes.h"

#include "read/mesh/loop_subdivision.h"
#include "read/mesh/origin.h"

#include <tbb/parallel_for.h>

#include <optional>

namespace eikonal::pbrt {

std::shared_ptr<Mesh> readMesh(Reading& reading, const Arguments& arguments, int corners) {
    const std::string title = arguments.kind().title();
    auto mesh = std::make_shared<Mesh>();
    setPositions(*mesh, arguments.points3("P"));
    if (mesh->positions.empty()) throw SceneError(arguments.where(), title + " needs its vertices, \"point3 P\"");

    // The indices given, or those of the only possible face.
    std::vector<int> indices = arguments.integers("indices");
    if (indices.empty()) {
        if (static_cast<int>(mesh->positions.size()) != corners)
            throw SceneError(arguments.where(), title + " has " + std::to_string(mesh->positions.size()) +
                                                    " vertices; without \"integer indices\" it has " + std::to_string(corners));
        for (int i = 0; i < corners; ++i) indices.push_back(i);
    }
    if (indices.size() % corners) {
        reading.diagnostics.warn(arguments.whereOf("indices"), "\"integer indices\" has " + std::to_string(indices.size()) +
                                                                   " values, not a multiple of " + std::to_string(corners) +
                                                                   "; the last are ignored");
        indices.resize(indices.size() - indices.size() % corners);
    }
    const auto count = static_cast<long long>(mesh->positions.size());
    for (const int index : indices)
        if (index < 0 || index >= count)
            throw SceneError(arguments.whereOf("indices"), "\"integer indices\" has a " + std::to_string(index) +
                                                               "; \"P\" has vertices 0 to " + std::to_string(count - 1));
    mesh->indices.assign(indices.begin(), indices.end());

    // Per-vertex attributes besides positions.
    const auto perVertex = [&](auto values, const char* name) {
        if (values.empty() || values.size() == mesh->positions.size()) return values;
        reading.diagnostics.warn(arguments.whereOf(name), "\"" + std::string(name) + "\" is ignored: it has " +
                                                              std::to_string(values.size()) + " vertices, and \"P\" has " +
                                                              std::to_string(count));
        return decltype(values)();
    };
    if (arguments.kind().rule("N")) mesh->normals = perVertex(arguments.vectors3("N"), "N");
    if (arguments.kind().rule("S")) mesh->tangents = perVertex(arguments.vectors3("S"), "S");
    if (arguments.kind().rule("uv")) mesh->uvs = perVertex(arguments.vectors2("uv"), "uv");
    return mesh;
}

std::shared_ptr<Mesh> readSubdividedMesh(Reading& reading, const Arguments& arguments) {
    const std::string title = arguments.kind().title();
    if (!arguments.has("indices")) throw SceneError(arguments.where(), title + " needs the vertices of its faces, \"integer indices\"");
    const std::shared_ptr<const Mesh> control = readMesh(reading, arguments, 3);

    const int levels = control->indices.empty() ? 0 : std::max(arguments.integer("levels"), 0);
    int possible = 0;
    for (size_t count = control->indices.size() / 3; 4 * count <= mostSubdividedTriangles && possible < levels; count *= 4) ++possible;
    if (possible < levels)
        throw SceneError(arguments.whereOf("levels"), "\"integer levels\" is " + std::to_string(levels) + ", which makes more than " +
                                                          std::to_string(mostSubdividedTriangles) + " triangles of this mesh; " +
                                                          std::to_string(possible) + " would work");
    SubdividedMesh result = subdivideByLoop(*control, levels);
    if (result.droppedFaces > 0)
        reading.diagnostics.warn(arguments.whereOf("indices"),
                                 std::to_string(result.droppedFaces) + " faces that name a vertex twice are skipped");
    result.mesh.origin = control->origin;
    return std::make_shared<Mesh>(std::move(result.mesh));
}

int PlyFiles::add(const std::string& path, const SourceLocation& where) {
    const auto [place, isNew] = numbers_.try_emplace(path, static_cast<int>(files_.size()));
    if (isNew) files_.push_back({path, where, {}});
    return place->second;
}

void PlyFiles::load() {
    std::vector<std::optional<SceneError>> errors(files_.size());
    tbb::parallel_for(size_t(0), files_.size(), [&](size_t i) {
        try {
            files_[i].mesh = loadPly(files_[i].path, files_[i].where);
        } catch (const SceneError& error) { errors[i] = error; }
    });
    for (size_t i = 0; i < files_.size(); ++i) {
        if (errors[i]) reading_.problems.add(*errors[i]);
        if (const size_t dropped = files_[i].mesh.droppedFaces)
            reading_.diagnostics.warn(files_[i].where, "\"" + files_[i].path + "\" has " + std::to_string(dropped) +
                                                           " faces with fewer than three corners, which are skipped");
        if (const int line = files_[i].mesh.skippedHeaderLine)
            reading_.unsupported("ply header " + files_[i].path, files_[i].where,
                                 "\"" + files_[i].path + "\" has an unknown keyword in line " + std::to_string(line) +
                                     " of its header; the line is skipped");
        if (const size_t line = files_[i].mesh.firstUnreadLine)
            reading_.unsupported("ply rest " + files_[i].path, files_[i].where,
                                 "\"" + files_[i].path + "\" has more data than the element counts of its header say: line " +
                                     std::to_string(line) + " and what follows are skipped");
        if (const size_t bytes = files_[i].mesh.unreadBytes)
            reading_.unsupported("ply rest " + files_[i].path, files_[i].where,
                                 "\"" + files_[i].path + "\" has more data than the element counts of its header say: its last " +
                                     std::to_string(bytes) + (bytes == 1 ? " byte is skipped" : " bytes are skipped"));
    }
}

}  // namespace eikonal::pbrt
