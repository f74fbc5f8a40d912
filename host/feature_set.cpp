#include "kind_features.h"

#include <algorithm>

namespace eikonal {

static const std::vector<std::string>& names() {
    static const std::vector<std::string> list{
#define GENERAL(NAME, why) #NAME,
#define KIND_FEATURE(NAME, kind) #NAME,
        GENERAL_FEATURES(GENERAL) KIND_FEATURES
#undef GENERAL
#undef KIND_FEATURE
    };
    return list;
}

/// "SHAPE_TRIANGLE" of kind "triangle": shape "triangle".
static std::string kindReason(const std::string& feature, const std::string& kind) {
    std::string group = feature.substr(0, feature.find('_'));
    std::transform(group.begin(), group.end(), group.begin(), [](char c) { return static_cast<char>(std::tolower(c)); });
    return group + " \"" + kind + "\"";
}

static const std::vector<std::string>& reasons() {
    static const std::vector<std::string> list{
#define GENERAL(NAME, why) why,
#define KIND_FEATURE(NAME, kind) kindReason(#NAME, kind),
        GENERAL_FEATURES(GENERAL) KIND_FEATURES
#undef GENERAL
#undef KIND_FEATURE
    };
    return list;
}

static_assert(KindFeature::count <= mostFeatures);
size_t featureCount() { return KindFeature::count; }

Features Features::everything() {
    Features all;
    for (size_t i = 0; i < featureCount(); ++i) all.require(static_cast<Feature>(i));
    return all;
}

const std::string& featureName(Feature f) { return names()[static_cast<size_t>(f)]; }
const std::string& featureReason(Feature f) { return reasons()[static_cast<size_t>(f)]; }

bool isGeneral(Feature f) {
#define COUNT_GENERAL(NAME, why) +1
    return static_cast<int>(f) < 0 GENERAL_FEATURES(COUNT_GENERAL);
#undef COUNT_GENERAL
}

Feature featureNamed(const std::string& name) {
    const auto found = std::find(names().begin(), names().end(), name);
    return found == names().end() ? Feature::none : static_cast<Feature>(found - names().begin());
}

}  // namespace eikonal
