#include "read/pbrt/media.h"

#include "kinds/medium_reading.h"

#include <list>
#include <utility>

namespace eikonal::pbrt {

const KindTable& mediumKinds() {
    static const KindTable table = [] {
        std::vector<Row> rows;
        std::list<std::string> parameters;   // of each row
        for (const MediumKind& e : mediumKindList()) {
            std::string& row = parameters.emplace_back();
            for (const char* part : e.traits.parameters)
                if (part) row += std::string(part) + ';';
            rows.push_back({e.name, e.value, row.c_str()});
        }
        return KindTable("medium", "string type", rows);
    }();
    return table;
}

int MediumRegistry::numberOf(const std::string& name) {
    if (name.empty()) return none;
    const auto [place, isNew] = numbers_.try_emplace(name, static_cast<int>(entries_.size()));
    if (isNew) entries_.push_back({name});
    return place->second;
}

void MediumRegistry::define(const std::string& name, const GraphicsState& state, ParameterList parameters, const SourceLocation& where) {
    const int number = numberOf(name);
    if (number == none) throw SceneError(where, "a medium needs a name; \"\" means vacuum");
    if (entries_[number].made)
        throw SceneError(where, "there is already a medium \"" + name + "\", at " + entries_[number].where.toString());
    entries_[number].made = true;
    entries_[number].where = where;

    const Kind& kind = mediumKinds().find(typeOf(parameters, "MakeNamedMedium", where), where);
    const Arguments arguments(reading_, kind, where, std::move(parameters), state.attributesOf(Target::medium), state.space);
    Medium medium;
    medium.name = name;
    medium.where = where;
    medium.worldFromMedium = state.transform[0];
    medium.g = arguments.number("g");
    medium.kind = &kindOf(static_cast<medium_kind>(kind.value));
    const bool isComplete = medium.kind->traits.read({reading_, arguments}, medium);
    const bool hasPlace = medium.kind->variation == MediumVariation::HETEROGENEOUS;
    if (state.moves() && hasPlace) medium.worldFromMediumAtEnd = state.transform[1];
    if (hasPlace && !isInvertible(state.transform))
        throw SceneError(where, "the medium's transform cannot be inverted; is there a Scale of 0?");
    if (!isComplete) return;
    if (emissionOf(medium) != MediumEmission::none && medium.sigmaA.albedo() == glm::dvec3(0))
        reading_.diagnostics.warn(where, "medium \"" + name + "\" emits no light, as in pbrt-v4: only what absorbs shines, and its "
                                         "\"sigma_a\" times its \"scale\" is 0");
    arguments.reportUnused();
    entries_[number].index = static_cast<int>(reading_.scene.media.size());
    reading_.scene.media.push_back(std::move(medium));
}

int MediumRegistry::resolve(int number, const SourceLocation& where) {
    if (number == none) return none;
    Entry& entry = entries_[number];
    if (!entry.made && !std::exchange(entry.missed, true)) {
        std::vector<std::string> names;
        for (const Entry& other : entries_)
            if (other.made) names.push_back(other.name);
        const std::string near = nearestWord(entry.name, names);
        reading_.problems.add(where,
                              "there is no medium \"" + entry.name + "\"" + (near.empty() ? "" : "; did you mean \"" + near + "\"?"));
    }
    return entry.index;
}

}  // namespace eikonal::pbrt
