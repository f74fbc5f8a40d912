#include "render/stage_programs.h"

#include "kind_features.h"
#include <fmt/format.h>

#include <stdexcept>

namespace eikonal {
namespace {

void addPrograms(std::vector<StageProgram>& programs, const StageRow& row) {
    if (row.over != each_bsdf && row.over != each_light_bsdf) {
        programs.push_back({&row, row.over, {}, row.name, fmt::format("#include \"stages/{}.cl\"\n", row.name)});
        return;
    }
    const uint first = row.over == each_light_bsdf ? light_hits : 0;
    const auto add = [&](const char* bsdf, uint next_queue, Feature feature) {
        programs.push_back({&row, first + next_queue, feature, fmt::format("{} {}", row.name, bsdf),
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
