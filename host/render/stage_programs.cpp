#include "render/stage_programs.h"

#include "kind_features.h"
#include <fmt/format.h>

#include <optional>
#include <stdexcept>

namespace eikonal {
namespace {

/// What a stage over the hits of each BSDF adds to next_x; nothing for other stages.
std::optional<uint> firstOfBsdfs(uint over) {
    switch (over) {
        case each_bsdf: return 0;
        case each_light_bsdf: return light_hits;
        case each_connecting_bsdf: return connecting_hits;
        case each_connected_bsdf: return connected_hits;
        default: return {};
    }
}

void addPrograms(std::vector<StageProgram>& programs, const StageRow& row) {
    const std::optional<uint> first = firstOfBsdfs(row.over);
    if (!first) {
        programs.push_back({&row, row.over, {}, row.name, fmt::format("#include \"stages/{}.cl\"\n", row.name)});
        return;
    }
    const auto add = [&](const char* bsdf, uint next_queue, Feature feature) {
        programs.push_back({&row, *first + next_queue, feature, fmt::format("{} {}", row.name, bsdf),
                            fmt::format("#define BSDF {0}\n#include \"bsdf/{0}.clh\"\n#include \"stages/{1}.cl\"\n", bsdf, row.name)});
    };
#define ADD_BSDF(bsdf, FEATURE, PARAMETERS) add(#bsdf, next_##bsdf, KindFeature::FEATURE);
    BSDFS(ADD_BSDF)
#undef ADD_BSDF
}

}  // namespace

const std::vector<StageProgram>& stagePrograms() {
    static const std::vector<StageProgram> all = [] {
        std::vector<StageProgram> programs;
        for (const StageRow& row : stageTable) addPrograms(programs, row);
        for (const StageRow& row : surveyTable) addPrograms(programs, row);
        return programs;
    }();
    return all;
}

const StageProgram& stageProgram(const std::string& name) {
    for (const StageProgram& program : stagePrograms())
        if (program.name == name) return program;
    throw std::out_of_range("no stage is called " + name);
}

}  // namespace eikonal
