#include "read/pbrt/shapes.h"

#include "kinds/material_kind.h"
#include "kinds/shape_reading.h"
#include "kinds/texture_kind.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

namespace eikonal::pbrt {
namespace {

/// The transform of a moving thing at the end of its motion; nothing if it does not move. Throws SceneError if the motion cannot be
/// interpolated.
std::optional<Transform> endOfMotion(const GraphicsState& state, const SourceLocation& where) {
    if (!state.moves()) return std::nullopt;
    for (const Transform& t : state.transform)
        if (!(std::abs(glm::determinant(glm::dmat3(t))) > 0))
            throw SceneError(
                where,
                "the transform of something that moves cannot be inverted, at the start or the end of its motion; is there a Scale of 0?");
    return state.transform[1];
}

/// The directives of all kinds, in the order of SHAPES.
struct DirectiveOfKind { const ShapeKind* kind; const ShapeDirective* directive; };
const std::vector<DirectiveOfKind>& directiveList() {
    static const std::vector<DirectiveOfKind> list = [] {
        std::vector<DirectiveOfKind> directives;
        for (const ShapeKind& kind : shapeKindList())
            for (const ShapeDirective& d : kind.traits.directives) directives.push_back({&kind, &d});
        return directives;
    }();
    return list;
}

}  // namespace

const KindTable& shapeKinds() {
    static const KindTable table = [] {
        std::vector<Row> rows;
        for (const auto& [kind, directive] : directiveList())
            rows.push_back({directive->name, static_cast<int>(rows.size()), directive->parameters});
        return KindTable("shape", "floatmap alpha = 1", rows);
    }();
    return table;
}

void ShapeRegistry::add(const std::string& kindName, const GraphicsState& state, ParameterList parameters, const SourceLocation& where) {
    const Kind& kind = shapeKinds().find(kindName, where);
    const Arguments arguments(reading_, kind, where, std::move(parameters), state.attributesOf(Target::shape), state.space);

    PendingShape pending{{}, none, openObject_, state.material, state.inside, state.outside, {}, {}};
    const auto& [shapeKind, directive] = directiveList()[static_cast<size_t>(kind.value)];
    pending.shape.kind = shapeKind;
    if (!directive->read({reading_, arguments, plyFiles_}, pending)) return;
    const ShapeTraits& traits = shapeKind->traits;
    if (!traits.corners && !isInvertible(state.transform)) {
        /* A flattened mesh is still visible */
        reading_.diagnostics.warnOnce("flattened " + kind.title(), where,
                                      kind.title() + ": its transform cannot be inverted (is there a Scale of 0?); it is skipped");
        return;
    }
    pending.shape.where = where;
    pending.shape.worldFromObject = state.transform[0];
    pending.shape.worldFromObjectAtEnd = endOfMotion(state, where);
    pending.shape.reverseOrientation = state.reverseOrientation;
    pending.shape.areaLight = state.areaLight;
    if (openObject_ != none && state.areaLight != none) {
        reading_.unsupported("area light in object", where, "a shape inside an object cannot emit; its area light is ignored");
        pending.shape.areaLight = none;
    }
    if (state.moves() && pending.shape.areaLight != none) {
        reading_.unsupported("moving area light", where,
                             "a moving shape cannot emit, as in pbrt-v4; its area light is ignored");
        pending.shape.areaLight = none;
    }
    if (!traits.lightKindOf && state.areaLight != none) {
        reading_.diagnostics.warnOnce(std::string("emitting ") + shapeKind->name, where,
                                      std::string(traits.cannotEmit) + "; its area light is ignored");
        pending.shape.areaLight = none;
    }
    if (const Parameter* alpha = arguments.given("alpha")) pending.alpha = *alpha;
    arguments.reportUnused();
    pending_.push_back(std::move(pending));
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
        throw SceneError(where,
                         "ObjectBegin inside the object \"" + reading_.scene.objects[openObject_].name + "\"; ObjectEnd must come first");
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
        throw SceneError(where, "ObjectInstance inside the object \"" + reading_.scene.objects[openObject_].name +
                                    "\"; objects cannot contain instances");
    if (!isInvertible(state.transform)) {
        reading_.diagnostics.warnOnce("flattened instance", where,
                                      "the instance's transform cannot be inverted (is there a Scale of 0?); it is skipped");
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
        reading_.problems.add(instance.where,
                              "there is no object \"" + name + "\"" + (near.empty() ? "" : "; did you mean \"" + near + "\"?"));
    }
    plyFiles_.load();
    for (PendingShape& pending : pending_) reading_.problems.guard([&] { place(std::move(pending)); });
    pending_.clear();
}

/// A number, also where a texture "constant" gives it: an alpha of 0 hides a lamp, and leaves its light.
Input ShapeRegistry::alphaOf(const Parameter& given) {
    const auto number = [&](double value) { return Input{Spectrum::constant(std::clamp(value, 0., 1.)), none, given.where}; };
    if (given.type != ParameterType::texture) return number(std::get<std::vector<double>>(given.values).front());
    const int index = textures_.textureOf(given, true);
    if (index == none) return {Spectrum::constant(1), none, given.where};
    const Texture& texture = reading_.scene.textures[static_cast<size_t>(index)];
    if (texture.kind->traits.isItsOperand) return number(texture.operands.front().value.value());
    return {{}, index, given.where};
}

void ShapeRegistry::place(PendingShape pending) {
    Shape& shape = pending.shape;
    shape.material = materials_.resolve(pending.material, shape.where);
    const MediumInterface media{media_.resolve(pending.inside, shape.where), media_.resolve(pending.outside, shape.where)};
    if (media.inside != media.outside) shape.interface = media;

    if (pending.alpha) shape.alpha = alphaOf(*pending.alpha);
    if (shape.areaLight != none && shape.material != none && reading_.scene.materials[shape.material].kind == &interface_material) {
        reading_.diagnostics.warnOnce("emitting interface", shape.where,
                                      "a shape of material \"interface\" cannot emit; its area light is ignored");
        shape.areaLight = none;
    }

    std::vector<Shape>& shapes = pending.object == none ? reading_.scene.shapes : reading_.scene.objects[pending.object].shapes;
    if (pending.plyFile == none) {
        shapes.push_back(std::move(shape));
        return;
    }
    const PlyMesh& ply = plyFiles_.mesh(pending.plyFile);
    shape.name = std::filesystem::path(plyFiles_.path(pending.plyFile)).stem().string();
    if (pending.displacement) {
        shape.displacement->texture = textures_.textureOf(*pending.displacement, true);
        const std::shared_ptr<const Mesh> mesh = trianglesOf(ply);
        if (!mesh) return;
        shape.mesh = mesh;
        shapes.push_back(std::move(shape));
        return;
    }
    if (ply.triangles) {
        shape.mesh = ply.triangles;
        shapes.push_back(shape);
    }
    if (ply.quads) {
        shape.kind = &kindOf(shape_bilinear);
        shape.mesh = ply.quads;
        shapes.push_back(std::move(shape));
    }
}

}  // namespace eikonal::pbrt
