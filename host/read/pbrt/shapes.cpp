#include "read/pbrt/shapes.h"

#include "read/pbrt/curves.h"
#include "read/pbrt/implicit.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace eikonal::pbrt {
namespace {

enum ShapeKind { sphereKind, diskKind, cylinderKind, triangleMeshKind, bilinearMeshKind, plyMeshKind, loopSubdivKind, curveKind, implicitKind };

Sphere readSphere(const Arguments& arguments) {
    const double radius = std::abs(arguments.number("radius"));
    const double z0 = arguments.number("zmin", -radius), z1 = arguments.number("zmax", radius);
    const auto clamp = [&](double z) { return std::clamp(z, -radius, radius); };
    return {radius, clamp(std::min(z0, z1)), clamp(std::max(z0, z1)), std::clamp(arguments.number("phimax"), 0., 360.)};
}

Disk readDisk(const Arguments& arguments) {
    return {std::abs(arguments.number("radius")), std::abs(arguments.number("innerradius")), arguments.number("height"), std::clamp(arguments.number("phimax"), 0., 360.)};
}

/// The transform of a moving thing at the end of its motion; nothing if it does not move. Throws SceneError if the motion cannot be
/// interpolated.
std::optional<Transform> endOfMotion(const GraphicsState& state, const SourceLocation& where) {
    if (!state.moves()) return std::nullopt;
    for (const Transform& t : state.transform)
        if (!(std::abs(glm::determinant(glm::dmat3(t))) > 0))
            throw SceneError(where, "the transform of something that moves cannot be inverted, at the start or the end of its motion; is there a Scale of 0?");
    return state.transform[1];
}

Cylinder readCylinder(const Arguments& arguments) {
    const double z0 = arguments.number("zmin"), z1 = arguments.number("zmax");
    return {std::abs(arguments.number("radius")), std::min(z0, z1), std::max(z0, z1), std::clamp(arguments.number("phimax"), 0., 360.)};
}

/// Whether a quadric has any surface.
bool hasArea(const Sphere& s) { return s.radius > 0 && s.zMin < s.zMax && s.phiMax > 0; }
bool hasArea(const Disk& d) { return d.innerRadius < d.radius && d.phiMax > 0; }
bool hasArea(const Cylinder& c) { return c.radius > 0 && c.zMin < c.zMax && c.phiMax > 0; }

}  // namespace

const KindTable& shapeKinds() {
    static const KindTable table("shape", "floatmap alpha = 1", {
        {"sphere", sphereKind, "float radius = 1; float zmin; float zmax; float phimax = 360"},
        {"disk", diskKind, "float radius = 1; float innerradius = 0; float height = 0; float phimax = 360"},
        {"cylinder", cylinderKind, "float radius = 1; float zmin = -1; float zmax = 1; float phimax = 360"},
        {"trianglemesh", triangleMeshKind, "integers indices; point3s P; normals N; vector3s S; point2s uv; integers faceIndices"},
        {"bilinearmesh", bilinearMeshKind, "integers indices; point3s P; normals N; point2s uv; integers faceIndices; file emissionfilename"},
        {"plymesh", plyMeshKind, "file filename; floattexture displacement; float edgelength = 1 in (0, inf)"},
        {"curve", curveKind,
         "point3s P; integer degree = 3; string basis = bezier; string type = flat; normals N; float width = 1; float width0; float width1;"
         "integer splitdepth = 3"},
        {"loopsubdiv", loopSubdivKind, "integers indices; point3s P; integer levels = 3; string scheme = loop"},
        {"implicit", implicitKind, "string F; point3s bounds; float a; float b; float c; float d"},
    });
    return table;
}

void ShapeRegistry::add(const std::string& kindName, const GraphicsState& state, ParameterList parameters, const SourceLocation& where) {
    const Kind& kind = shapeKinds().find(kindName, where);
    const Arguments arguments(reading_, kind, where, std::move(parameters), state.attributesOf(Target::shape), state.space);

    Pending pending{{}, none, openObject_, state.material, state.inside, state.outside, {}};
    if (!readKind(arguments, pending)) return;
    const bool isMesh = std::holds_alternative<TriangleMesh>(pending.shape.kind) || std::holds_alternative<BilinearMesh>(pending.shape.kind);
    if (!isMesh && !isInvertible(state.transform)) {
        /* A flattened mesh is still visible */
        reading_.diagnostics.warnOnce("flattened " + kind.title(), where, kind.title() + ": its transform cannot be inverted, as with a Scale of 0; it is left out");
        return;
    }
    pending.shape.where = where;
    pending.shape.worldFromObject = state.transform[0];
    pending.shape.worldFromObjectAtEnd = endOfMotion(state, where);
    pending.shape.reverseOrientation = state.reverseOrientation;
    pending.shape.areaLight = state.areaLight;
    if (openObject_ != none && state.areaLight != none) {
        reading_.unsupported("area light in object", where, "a shape of an object cannot emit; its area light is ignored");
        pending.shape.areaLight = none;
    }
    if (state.moves() && pending.shape.areaLight != none) {
        reading_.unsupported("moving area light", where, "a shape that moves cannot emit (nor does it in pbrt-v4); its area light is ignored");
        pending.shape.areaLight = none;
    }
    if (kind.value == curveKind && state.areaLight != none) {
        reading_.diagnostics.warnOnce("emitting curve", where, "a curve cannot emit (pbrt-v4 stops there); its area light is ignored");
        pending.shape.areaLight = none;
    }
    if (kind.value == implicitKind && state.areaLight != none) {
        reading_.diagnostics.warnOnce("emitting implicit surface", where, "an implicit surface cannot emit, since no point of it can be sampled; its area light is ignored");
        pending.shape.areaLight = none;
    }
    if (const Parameter* alpha = arguments.given("alpha")) pending.alpha = *alpha;
    pending_.push_back(std::move(pending));
}

/// Fills in the shape's kind. Returns false if its file is missing.
bool ShapeRegistry::readKind(const Arguments& arguments, Pending& pending) {
    const auto quadric = [&](const auto& shape) {
        pending.shape.kind = shape;
        if (!hasArea(shape)) reading_.diagnostics.warn(arguments.where(), arguments.kind().title() + " has no area, by its radii and ranges; it is left out");
        return hasArea(shape);
    };
    switch (arguments.kind().value) {
        case sphereKind: return quadric(readSphere(arguments));
        case diskKind: return quadric(readDisk(arguments));
        case cylinderKind: return quadric(readCylinder(arguments));
        case triangleMeshKind: pending.shape.kind = TriangleMesh{readMesh(reading_, arguments, 3)}; break;
        case loopSubdivKind: pending.shape.kind = TriangleMesh{readSubdividedMesh(reading_, arguments)}; break;
        case curveKind: pending.shape.kind = CurveShape{readCurve(reading_, arguments)}; break;
        case implicitKind: pending.shape.kind = readImplicit(arguments); break;
        case bilinearMeshKind:
            pending.shape.kind = BilinearMesh{readMesh(reading_, arguments, 4)};
            if (arguments.file("emissionfilename"))
                reading_.diagnostics.info("\"emissionfilename\" only guides sampling; it is not used");
            break;
        case plyMeshKind: {
            if (!arguments.has("filename")) throw SceneError(arguments.where(), "shape \"plymesh\" needs a \"string filename\"");
            const std::optional<std::string> path = arguments.file("filename");
            if (!path) return false;
            pending.plyFile = plyFiles_.add(*path, arguments.whereOf("filename"));
            if (const Parameter* displacement = arguments.given("displacement")) {
                pending.displacement = *displacement;
                pending.shape.displacement = {none, arguments.number("edgelength") * reading_.displacementEdgeScale, displacement->where};
            }
            break;
        }
    }
    return true;
}

int ShapeRegistry::objectNamed(const std::string& name) {
    const auto [place, isNew] = objectNumbers_.try_emplace(name, static_cast<int>(reading_.scene.objects.size()));
    if (isNew) {
        reading_.scene.objects.push_back({name, {}, {}});
        objectIsMade_.push_back(false);
    }
    return place->second;
}

void ShapeRegistry::beginObject(const std::string& name, const SourceLocation& where) {
    if (openObject_ != none)
        throw SceneError(where, "ObjectBegin inside the object \"" + reading_.scene.objects[openObject_].name + "\"; ObjectEnd must come first");
    const int object = objectNamed(name);
    if (objectIsMade_[object])
        throw SceneError(where, "there is already an object \"" + name + "\", at " + reading_.scene.objects[object].where.toString());
    objectIsMade_[object] = true;
    reading_.scene.objects[object].where = where;
    openObject_ = object;
}

void ShapeRegistry::endObject(const SourceLocation& where) {
    if (openObject_ == none) throw SceneError(where, "ObjectEnd without an ObjectBegin before it");
    openObject_ = none;
}

void ShapeRegistry::addInstance(const std::string& name, const GraphicsState& state, const SourceLocation& where) {
    if (openObject_ != none)
        throw SceneError(where, "ObjectInstance inside the object \"" + reading_.scene.objects[openObject_].name + "\"; objects cannot contain instances");
    if (!isInvertible(state.transform)) {
        reading_.diagnostics.warnOnce("flattened instance", where, "the instance's transform cannot be inverted, as with a Scale of 0; it is left out");
        return;
    }
    reading_.scene.instances.push_back({objectNamed(name), state.transform[0], endOfMotion(state, where), where});
}

void ShapeRegistry::finish() {
    std::vector<std::string> made;
    for (const Object& object : reading_.scene.objects)
        if (objectIsMade_[objectNumbers_.at(object.name)]) made.push_back(object.name);
    std::vector<bool> isMissed(objectIsMade_.size());
    for (const Instance& instance : reading_.scene.instances) {
        if (objectIsMade_[instance.object] || isMissed[instance.object]) continue;
        isMissed[instance.object] = true;
        const std::string& name = reading_.scene.objects[instance.object].name;
        const std::string near = nearestWord(name, made);
        reading_.problems.add(instance.where, "there is no object \"" + name + "\"" + (near.empty() ? "" : "; did you mean \"" + near + "\"?"));
    }
    plyFiles_.load();
    for (Pending& pending : pending_) reading_.problems.guard([&] { place(std::move(pending)); });
    pending_.clear();
}

void ShapeRegistry::place(Pending pending) {
    Shape& shape = pending.shape;
    shape.material = materials_.resolve(pending.material, shape.where);
    const MediumInterface media{media_.resolve(pending.inside, shape.where), media_.resolve(pending.outside, shape.where)};
    if (media.inside != media.outside) shape.interface = media;

    if (pending.alpha) {
        shape.alpha.where = pending.alpha->where;
        if (pending.alpha->type == ParameterType::texture) shape.alpha.texture = textures_.textureOf(*pending.alpha, true);
        else shape.alpha.value = Spectrum::constant(std::clamp(std::get<std::vector<double>>(pending.alpha->values).front(), 0., 1.));
    }
    if (shape.areaLight != none && shape.material != none && reading_.scene.materials[shape.material].kind == MaterialKind::interface) {
        reading_.diagnostics.warnOnce("emitting interface", shape.where, "a shape of material \"interface\" cannot emit; its area light is ignored");
        shape.areaLight = none;
    }

    std::vector<Shape>& shapes = pending.object == none ? reading_.scene.shapes : reading_.scene.objects[pending.object].shapes;
    if (pending.plyFile == none) {
        shapes.push_back(std::move(shape));
        return;
    }
    const PlyMesh& ply = plyFiles_.mesh(pending.plyFile);
    if (pending.displacement) {
        shape.displacement->texture = textures_.textureOf(*pending.displacement, true);
        const std::shared_ptr<const Mesh> mesh = trianglesOf(ply);
        if (!mesh) return;
        shape.kind = TriangleMesh{mesh};
        shapes.push_back(std::move(shape));
        return;
    }
    if (ply.triangles) {
        shape.kind = TriangleMesh{ply.triangles};
        shapes.push_back(shape);
    }
    if (ply.quads) {
        shape.kind = BilinearMesh{ply.quads};
        shapes.push_back(std::move(shape));
    }
}

}  // namespace eikonal::pbrt
