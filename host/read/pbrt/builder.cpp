#include "read/pbrt/builder.h"

#include "read/pbrt/attributes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>

namespace eikonal::pbrt {

void Builder::concatenate(const Transform& transform) {
    for (int i = 0; i < 2; ++i)
        if (state.active[i]) state.transform[i] = state.transform[i] * transform;
}

void Builder::setTransform(const Transform& transform) {
    for (int i = 0; i < 2; ++i)
        if (state.active[i]) state.transform[i] = transform;
}

void Builder::rotate(double degrees, glm::dvec3 axis, const SourceLocation& where) {
    if (!(glm::dot(axis, axis) > 0)) throw SceneError(where, "Rotate has an axis of length 0");
    concatenate(glm::rotate(Transform(1), glm::radians(degrees), axis));
}

void Builder::lookAt(glm::dvec3 eye, glm::dvec3 at, glm::dvec3 up, const SourceLocation& where) {
    const glm::dvec3 forward = glm::normalize(at - eye);
    const glm::dvec3 across = glm::cross(glm::normalize(up), forward);
    if (!(glm::dot(across, across) > 0)) throw SceneError(where, "LookAt has a viewing direction of length 0 or parallel to its up vector");
    const glm::dvec3 right = glm::normalize(across);
    const Transform worldFromCamera(glm::dvec4(right, 0), glm::dvec4(glm::cross(forward, right), 0), glm::dvec4(forward, 0),
                                    glm::dvec4(eye, 1));
    concatenate(glm::inverse(worldFromCamera));
}

void Builder::nameCameraSystem() {
    coordinateSystems_["camera"] = {glm::inverse(state.transform[0]), glm::inverse(state.transform[1])};
}

void Builder::useCoordinateSystem(const std::string& name, const SourceLocation& where) {
    const auto found = coordinateSystems_.find(name);
    if (found != coordinateSystems_.end()) {
        state.transform = found->second;
        return;
    }
    std::vector<std::string> names;
    for (const auto& [known, transform] : coordinateSystems_) names.push_back(known);
    const std::string near = nearestWord(name, names);
    reading.diagnostics.warn(where, "there is no coordinate system \"" + name + "\"" +
                                        (near.empty() ? "" : " (did you mean \"" + near + "\"?)") + ", so CoordSysTransform has no effect");
}

void Builder::beginWorld() {
    inWorld = true;
    state.transform = {Transform(1), Transform(1)};
    state.active = {true, true};
    nameCoordinateSystem("world");
    settings.apply();
}

void Builder::beginAttributes(const SourceLocation& where) { blocks_.push_back({state, where, false}); }

void Builder::endAttributes(const SourceLocation& where) {
    if (blocks_.empty()) throw SceneError(where, "AttributeEnd without an AttributeBegin before it");
    if (blocks_.back().isObject)
        throw SceneError(where, "AttributeEnd where ObjectEnd is expected, for the ObjectBegin at " + blocks_.back().where.toString());
    state = std::move(blocks_.back().saved);
    blocks_.pop_back();
}

void Builder::beginObject(const std::string& name, const SourceLocation& where) {
    shapes.beginObject(name, where);
    blocks_.push_back({state, where, true});
}

void Builder::endObject(const SourceLocation& where) {
    if (!blocks_.empty() && !blocks_.back().isObject)
        throw SceneError(where, "ObjectEnd where AttributeEnd is expected, for the AttributeBegin at " + blocks_.back().where.toString());
    if (blocks_.empty() && shapes.objectIsOpen()) throw SceneError(where, "ObjectEnd in an imported file, for an ObjectBegin outside it");
    shapes.endObject(where);
    state = std::move(blocks_.back().saved);
    blocks_.pop_back();
}

void Builder::addAttributes(const std::string& target, ParameterList parameters, const SourceLocation& where) {
    const auto found = std::ranges::find(attributeTargets, target);
    if (found == std::end(attributeTargets))
        throw SceneError(
            where, "Attribute has the target \"" + target + "\"; it can be \"shape\", \"light\", \"material\", \"medium\" or \"texture\"");
    const auto number = found - std::begin(attributeTargets);
    for (const Parameter& parameter : parameters) checkAttribute(reading, static_cast<Target>(number), parameter);
    auto& attributes = state.attributes[static_cast<size_t>(number)];
    auto extended = attributes ? std::make_shared<ParameterList>(*attributes) : std::make_shared<ParameterList>();
    extended->insert(extended->end(), std::make_move_iterator(parameters.begin()), std::make_move_iterator(parameters.end()));
    attributes = std::move(extended);
}

void Builder::closeBlocks() {
    for (; !blocks_.empty(); blocks_.pop_back()) {
        const Block& block = blocks_.back();
        reading.problems.add(
            block.where,
            std::string(block.isObject ? "ObjectBegin without an ObjectEnd" : "AttributeBegin without an AttributeEnd") + " after it");
        if (block.isObject) shapes.endObject(block.where);
    }
}

Scene Builder::finish(const SourceLocation& end) {
    closeBlocks();
    if (!inWorld) reading.problems.add(end, "the file ends before WorldBegin");
    shapes.finish();
    settings.finish(media);
    materials.finish();
    textures.finish();
    reading.problems.throwIfAny();
    return std::move(reading.scene);
}

}  // namespace eikonal::pbrt
