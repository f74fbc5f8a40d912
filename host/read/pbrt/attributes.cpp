#include "read/pbrt/attributes.h"

#include "read/pbrt/lights.h"
#include "read/pbrt/materials.h"
#include "read/pbrt/media.h"
#include "read/pbrt/shapes.h"
#include "read/pbrt/textures.h"

#include <set>

namespace eikonal::pbrt {

/// All kinds that take the attributes of a target.
static std::vector<const Kind*> kindsOf(Target target) {
    std::vector<const KindTable*> tables;
    switch (target) {
        case Target::shape:
            tables = {&shapeKinds()};
            break;
        case Target::light:
            tables = {&lightKinds(), &areaLightKinds()};
            break;
        case Target::material:
            tables = {&materialKinds()};
            break;
        case Target::medium:
            tables = {&mediumKinds()};
            break;
        case Target::texture:
            tables = {&textureKinds(true), &textureKinds(false)};
            break;
    }
    std::vector<const Kind*> kinds;
    for (const KindTable* table : tables)
        for (const Kind& kind : table->kinds()) kinds.push_back(&kind);
    return kinds;
}

void checkAttribute(Reading& reading, Target target, const Parameter& parameter) {
    const std::string shown = "\"" + parameter.declaration() + "\"", noun = attributeTargets[static_cast<int>(target)];
    std::set<std::string> names;
    const Rule* other = nullptr;
    for (const Kind* kind : kindsOf(target)) {
        if (kind->ruleFor(parameter)) return;
        for (const Rule& rule : kind->rules)
            if (rule.hasName(parameter.name)) other = &rule;
        for (const std::string& name : kind->parameters()) names.insert(name);
    }
    if (other) throw SceneError(parameter.where, shown + " found where a " + noun + " has " + acceptedDeclarations(*other, parameter.name));
    const std::string near = nearestWord(parameter.name, names);
    reading.unsupported(
        "attribute " + noun + " " + parameter.name, parameter.where,
        shown + " is ignored, since no " + noun + " has such a parameter" + (near.empty() ? "" : "; did you mean \"" + near + "\"?"));
}

}  // namespace eikonal::pbrt
