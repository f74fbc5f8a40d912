// Our own reader, because assimp (5.2) accepts truncated files, returning garbage faces, and does not check indices. This reader is also
// faster: 1.4 million triangles in 0.2 s (binary) or 0.5 s (text) instead of 0.4 s or 0.55 s.

#include "read/mesh/ply.h"

#include "read/mesh/origin.h"
#include "read/mesh/ply_values.h"
#include "read/mesh/polygon.h"

namespace eikonal {
namespace {

using namespace ply;

constexpr int notFound = -1;

int findProperty(const Element& element, std::string_view name, bool isList) {
    const auto found = std::ranges::find_if(element.properties, [&](const Property& p) { return p.name == name && p.isList == isList; });
    return found == element.properties.end() ? notFound : static_cast<int>(found - element.properties.begin());
}

void skipProperty(Values& values, const Property& property) {
    for (std::size_t n = property.isList ? values.nextCount(property) : 1; n > 0; --n) values.next(property.type);
}

void readVertices(Values& values, const Element& element, Mesh& mesh) {
    const auto scalar = [&](std::string_view name) { return findProperty(element, name, false); };
    const std::array position{scalar("x"), scalar("y"), scalar("z")};
    if (std::ranges::count(position, notFound)) throw ReadProblem{"has no vertex properties x, y and z"};
    const std::array normal{scalar("nx"), scalar("ny"), scalar("nz")};
    const bool hasNormals = std::ranges::count(normal, notFound) == 0;
    std::array uv{notFound, notFound};
    for (const auto& [u, v] : {std::pair{"u", "v"}, {"s", "t"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}})
        if (uv[0] == notFound && scalar(u) != notFound && scalar(v) != notFound) uv = {scalar(u), scalar(v)};
    const bool hasUvs = uv[0] != notFound;

    const bool isDouble = std::ranges::any_of(position, [&](int p) { return element.properties[p].type == Type::float64; });
    std::vector<glm::dvec3> points(isDouble ? element.count : 0);
    mesh.positions.resize(isDouble ? 0 : element.count);
    if (hasNormals) mesh.normals.resize(element.count);
    if (hasUvs) mesh.uvs.resize(element.count);
    std::vector<double> row(element.properties.size());
    for (std::size_t i = 0; i < element.count; ++i) {
        for (std::size_t p = 0; p < row.size(); ++p) {
            const Property& property = element.properties[p];
            if (property.isList) skipProperty(values, property);
            else row[p] = values.next(property.type);
        }
        const glm::dvec3 p(row[position[0]], row[position[1]], row[position[2]]);
        if (isDouble) points[i] = p;
        else mesh.positions[i] = p;
        if (hasNormals) mesh.normals[i] = {row[normal[0]], row[normal[1]], row[normal[2]]};
        if (hasUvs) mesh.uvs[i] = {row[uv[0]], row[uv[1]]};
    }
    if (isDouble) setPositions(mesh, points);
}

/// A polygon with more than four corners, as a fan of triangles around its first one.
struct Fan { std::size_t firstIndex, corners; };  ///< firstIndex: in Faces::triangles

struct Faces {
    std::vector<std::uint32_t> triangles, quads;
    std::vector<Fan> fans;
    std::size_t dropped = 0;
};

void readFaces(Values& values, const Element& element, Faces& faces) {
    int list = findProperty(element, "vertex_indices", true);
    if (list == notFound) list = findProperty(element, "vertex_index", true);
    if (list == notFound) throw ReadProblem{"has no list \"vertex_indices\" in its element \"face\""};

    std::vector<std::uint32_t> corners;
    for (std::size_t i = 0; i < element.count; ++i) {
        for (int p = 0; p < static_cast<int>(element.properties.size()); ++p) {
            const Property& property = element.properties[p];
            if (p != list) { skipProperty(values, property); continue; }
            corners.resize(values.nextCount(property));
            for (std::uint32_t& corner : corners) {
                const double index = values.next(property.type);
                if (!(index >= 0 && index < 4294967295.) || index != std::floor(index))
                    throw ReadProblem{fmt::format("has a face {} with the vertex index {}", i, index)};
                corner = static_cast<std::uint32_t>(index);
            }
        }
        if (corners.size() > 4) faces.fans.push_back({faces.triangles.size(), corners.size()});
        if (corners.size() == 4) faces.quads.insert(faces.quads.end(), {corners[0], corners[1], corners[3], corners[2]});
        else for (std::size_t k = 2; k < corners.size(); ++k)
            faces.triangles.insert(faces.triangles.end(), {corners[0], corners[k - 1], corners[k]});
        faces.dropped += corners.size() < 3;
    }
}

void checkIndices(const std::vector<std::uint32_t>& indices, const Mesh& mesh) {
    for (const std::uint32_t index : indices) {
        if (index >= mesh.positions.size())
            throw ReadProblem{fmt::format("has a face with vertex index {}, but its {} vertices are numbered from 0", index,
                                      mesh.positions.size())};
        const glm::vec3& p = mesh.positions[index];
        if (!std::isfinite(p.x + p.y + p.z))
            throw ReadProblem{fmt::format("has a face with vertex {}, whose position is not finite", index)};
    }
}

/// Cuts the polygons, which may be concave, along their inside. The vertices may follow the faces, so this comes last.
void cutFans(Faces& faces, const Mesh& mesh) {
    std::vector<std::uint32_t> corners;
    std::vector<glm::dvec3> polygon;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const Fan& fan : faces.fans) {
        const auto index = faces.triangles.begin() + static_cast<std::ptrdiff_t>(fan.firstIndex);
        corners.assign(index, index + 2);
        for (std::size_t k = 2; k < fan.corners; ++k) corners.push_back(index[static_cast<std::ptrdiff_t>(3 * (k - 2) + 2)]);
        polygon.clear();
        for (const std::uint32_t corner : corners) polygon.emplace_back(mesh.positions[corner]);
        triangles.clear();
        triangulate(polygon, triangles);
        auto next = index;
        for (const auto& triangle : triangles)
            for (const std::uint32_t corner : triangle) *next++ = corners[corner];
    }
}

std::size_t lineAt(std::string_view text, std::size_t at) {
    std::size_t line = 1;
    for (std::size_t i = 0; i < at; ++i) line += text[i] == '\n' || (text[i] == '\r' && text.substr(i, 2) != "\r\n");
    return line;
}

PlyMesh parse(std::span<const char> bytes) {
    const Header header = parseHeader({bytes.data(), bytes.size()});
    for (const char* needed : {"vertex", "face"}) {
        const auto found = std::ranges::find(header.elements, needed, &Element::name);
        if (found == header.elements.end())
            throw ReadProblem{fmt::format("has no element \"{}\"; its elements: {}", needed, header.elementNames())};
        if (found->count == 0) throw ReadProblem{fmt::format("has 0 elements \"{}\"; a mesh needs some", needed)};
    }

    Values values(bytes.subspan(header.size), header.format);
    Mesh mesh;
    Faces faces;
    for (const Element& element : header.elements) {
        std::size_t rowSize = 0;
        for (const Property& property : element.properties) rowSize += values.size(property.isList ? property.countType : property.type);
        if (rowSize == 0) continue;
        values.require(static_cast<double>(element.count), rowSize);
        if (element.name == "vertex") readVertices(values, element, mesh);
        else if (element.name == "face") readFaces(values, element, faces);
        else for (std::size_t i = 0; i < element.count; ++i)
            for (const Property& property : element.properties) skipProperty(values, property);
    }
    checkIndices(faces.triangles, mesh);
    checkIndices(faces.quads, mesh);
    cutFans(faces, mesh);

    PlyMesh result;
    result.skippedHeaderLine = header.skippedLine;
    if (const std::string_view rest = values.unreadText(); !rest.empty())
        result.firstUnreadLine = lineAt({bytes.data(), bytes.size()}, bytes.size() - rest.size());
    result.unreadBytes = values.unreadBytes();
    result.droppedFaces = faces.dropped;
    if (!faces.quads.empty()) {
        result.quads = std::make_shared<Mesh>(faces.triangles.empty() ? std::move(mesh) : mesh);
        result.quads->indices = std::move(faces.quads);
    }
    if (!faces.triangles.empty()) {
        result.triangles = std::make_shared<Mesh>(std::move(mesh));
        result.triangles->indices = std::move(faces.triangles);
    }
    return result;
}

}  // namespace

std::shared_ptr<const Mesh> trianglesOf(const PlyMesh& ply) {
    if (!ply.quads) return ply.triangles;
    auto mesh = std::make_shared<Mesh>(*ply.quads);
    mesh->indices = ply.triangles ? ply.triangles->indices : std::vector<std::uint32_t>();
    const std::vector<std::uint32_t>& q = ply.quads->indices;
    for (std::size_t i = 0; i < q.size(); i += 4)
        mesh->indices.insert(mesh->indices.end(), {q[i], q[i + 1], q[i + 3], q[i], q[i + 3], q[i + 2]});
    return mesh;
}

PlyMesh loadPly(const std::string& path, const SourceLocation& where) {
    try {
        return parse(readBytes(path));
    } catch (const ReadProblem& problem) {
        throw SceneError(where, fmt::format("PLY file \"{}\" {}", path, problem.what()));
    }
}

}  // namespace eikonal
