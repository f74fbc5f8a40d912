#include "read/obj/obj.h"

#include "kinds/shape_kind.h"
#include "read/obj/geometry.h"
#include "read/obj/materials.h"
#include "read/obj/meshes.h"
#include "read/obj/mtl.h"
#include "read/obj/sky.h"
#include "read/obj/view.h"
#include "read/formats/read_bytes.h"
#include "read/scene_name.h"

#include <fmt/format.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <map>
#include <set>
#include <sstream>

namespace eikonal {
namespace {

std::string_view textOf(const std::vector<char>& bytes) { return {bytes.data(), bytes.size()}; }

void checkOptions(const ObjOptions& options) {
    if (options.fov && !(*options.fov > 0 && *options.fov < 180)) throw UsageError("the field of view must be between 0 and 180 degrees");
    if (options.width.value_or(1) <= 0 || options.height.value_or(1) <= 0) throw UsageError("the resolution must be positive");
    if (!(glm::length(options.up) > 0)) throw UsageError("the up direction must not be zero");
    if (options.camera && options.lookAt && glm::distance(*options.camera, *options.lookAt) == 0)
        throw UsageError("the camera and the point it looks at must differ");
}

/// The materials of all libraries by name; the first of each name counts.
class Library {
public:
    Library(const std::vector<ObjLibrary>& files, Diagnostics& diagnostics) : diagnostics_(diagnostics), files_(diagnostics) {
        for (const ObjLibrary& file : files) read(file);
    }

    /// Returns null, and warns once per name, if there is no such material. An empty name: of faces before any "usemtl".
    const MtlMaterial* find(const std::string& name, const SourceLocation& where) const {
        const auto found = materials_.find(name);
        if (found != materials_.end()) return &found->second;
        if (name.empty()) diagnostics_.unsupported("obj no material", where, "faces have no material (\"usemtl\"); they are grey");
        else if (!isIncomplete_)
            diagnostics_.unsupported("obj material " + name, where, fmt::format("there is no material \"{}\"; its faces are grey", name));
        return nullptr;
    }

private:
    /// The line is one file name with spaces, or several names.
    void read(const ObjLibrary& library) {
        if (readFile(files_.find(library.name, library.where), library.where)) return;
        std::istringstream names(library.name);
        for (std::string name; names >> name;) {
            SourceLocation where = library.where;
            where.column += static_cast<int>((names.eof() ? library.name.size() : static_cast<std::size_t>(names.tellg())) - name.size());
            if (readFile(files_.find(name, where), where)) continue;
            isIncomplete_ = true;
            diagnostics_.unsupported(
                "obj library " + name, where,
                fmt::format("there is no material library \"{}\"; faces without a material are grey", name));
        }
    }

    /// Returns false if there is no file. Reads each file once.
    bool readFile(const std::string& path, const SourceLocation& where) {
        if (path.empty()) return false;
        if (!paths_.insert(path).second) return true;
        const auto name = std::make_shared<const std::string>(path);
        try {
            const std::vector<char> bytes = readBytes(path);
            std::vector<MtlMaterial> materials = parseMtl(textOf(bytes), name, diagnostics_);
            if (materials.empty())
                diagnostics_.unsupported("obj empty library " + path, where,
                                         fmt::format("the material library \"{}\" has no material (\"newmtl NAME\")", path));
            for (MtlMaterial& material : materials) add(std::move(material));
        } catch (const ReadProblem& problem) {
            throw SceneError({name, 0, 0}, problem.what());
        }
        return true;
    }

    void add(MtlMaterial material) {
        const auto [first, isNew] = materials_.try_emplace(material.name, std::move(material));
        if (isNew) return;
        diagnostics_.unsupported("obj second material " + first->first, material.where,
                                 fmt::format("material \"{}\" is there already, at {}; that one counts, and this one is skipped",
                                             first->first, first->second.where.toString()));
    }

    Diagnostics& diagnostics_;
    ObjFiles files_;
    std::set<std::string> paths_;
    std::map<std::string, MtlMaterial> materials_;
    bool isIncomplete_ = false;
};

/// The side length of the texture on the surfaces of each material.
std::map<std::string, double> textureSizes(const ObjGeometry& geometry, const ObjMeshes& meshes) {
    std::map<std::string, std::pair<double, double>> areas;
    for (std::size_t g = 0; g < geometry.groups.size(); ++g) {
        areas[geometry.groups[g].material].first += meshes.groups[g].area;
        areas[geometry.groups[g].material].second += meshes.groups[g].uvArea;
    }
    std::map<std::string, double> sizes;
    for (const auto& [material, area] : areas) sizes[material] = area.second > 0 ? std::sqrt(area.first / area.second) : 1;
    return sizes;
}

void addShapes(Scene& scene, const ObjGeometry& geometry, const ObjMeshes& meshes, const Library& library,
               MissingFiles missing, Diagnostics& diagnostics) {
    const std::map<std::string, double> sizes = textureSizes(geometry, meshes);
    std::map<const MtlMaterial*, ObjMaterial> materials;
    ObjFiles files(diagnostics, missing);
    for (std::size_t g = 0; g < geometry.groups.size(); ++g) {
        const ObjGroup& group = geometry.groups[g];
        const ObjMesh& mesh = meshes.groups[g];
        if (!mesh.mesh) continue;
        const SourceLocation& where = group.where;
        const MtlMaterial* mtl = library.find(group.material, where);
        if (!materials.contains(mtl))
            materials[mtl] = mtl ? addMaterial(scene, *mtl, sizes.at(group.material), files, diagnostics) : addDefaultMaterial(scene);
        const ObjMaterial& material = materials[mtl];
        if (material.usesUvs && mesh.mesh->uvs.empty())
            diagnostics.warnOnce(
                "obj uv " + group.material, where,
                fmt::format("material \"{}\" has textures, but \"{}\" has no texture coordinates", group.material, group.object));

        Shape shape = triangleMesh(mesh.mesh);
        shape.worldFromObject = glm::translate(glm::dmat4(1), meshes.offset);
        shape.material = material.material;
        shape.alpha = material.alpha;
        if (material.areaLight != none) {
            shape.areaLight = material.areaLight;
            if (!mesh.isClosed) {
                AreaLight light = scene.areaLights[static_cast<std::size_t>(material.areaLight)];
                light.twoSided = true;
                scene.areaLights.push_back(std::move(light));
                shape.areaLight = static_cast<int>(scene.areaLights.size()) - 1;
            }
        }
        shape.name = group.object.empty() ? scene.name : group.object;
        shape.where = where;
        scene.shapes.push_back(std::move(shape));
    }
    files.throwMissing();
}

void placeCamera(Scene& scene, const ObjOptions& options, View& view) {
    view = chooseView(viewedTriangles(scene), {.eye = options.camera,
                                               .target = options.lookAt,
                                               .up = options.up,
                                               .fov = options.fov,
                                               .width = options.width,
                                               .height = options.height,
                                               .turns = options.turns});
    scene.camera.worldFromCamera = worldFromCamera(view);
    scene.camera.fov = view.fov;
    scene.film.width = view.width;
    scene.film.height = view.height;
}

}  // namespace

Scene readObj(const std::string& path, const ObjOptions& options, Diagnostics& diagnostics) {
    checkOptions(options);
    const auto file = std::make_shared<const std::string>(path);
    std::vector<char> bytes;
    try {
        bytes = readBytes(path);
    } catch (const ReadProblem& problem) {
        throw SceneError({file, 0, 0}, problem.what());
    }
    ObjGeometry geometry = parseObj(textOf(bytes), file, diagnostics);
    if (geometry.faces.empty()) throw SceneError({file, 0, 0}, "there are no faces (\"f\") in this file");
    completeNormals(geometry);
    const ObjMeshes meshes = buildMeshes(geometry);
    const SourceLocation firstDegenerate{file, meshes.firstDegenerateLine, 0};
    if (meshes.triangles == 0)
        throw SceneError(firstDegenerate, "all faces have zero area: a face needs three corners that are not on one line");
    if (meshes.degenerate > 0)
        diagnostics.warn(firstDegenerate, fmt::format("{} of {} triangles have zero area and are skipped, this face first",
                                                      meshes.degenerate, meshes.degenerate + meshes.triangles));

    Scene scene;
    scene.name = sceneName(path);
    scene.integrator.maxDepth = 10;
    scene.sampler.pixelSamples = 64;
    addShapes(scene, geometry, meshes, Library(geometry.libraries, diagnostics), options.missingFiles,
              diagnostics);
    View view;
    placeCamera(scene, options, view);
    if (scene.areaLights.empty()) addSky(scene, options.up, view.eye - view.target);
    return scene;
}

}  // namespace eikonal
