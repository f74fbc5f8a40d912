#include "device/layout.h"

#include "kind_features.h"
#include "eikonal/bsdfs.h"
#include "eikonal/film.h"
#include "eikonal/queues.h"

#include <algorithm>
#include <stdexcept>

namespace eikonal {

/// Lays fields out one after the other; fields whose feature is absent get no words.
class LayoutBuilder {
public:
    explicit LayoutBuilder(std::string name) { layout_.name = std::move(name); }
    void add(const char* name, const char* type, int words, bool present) {
        layout_.fields.push_back({name, type, layout_.words, present ? words : 0});
        if (present) layout_.words += words;
    }
    QueueLayout take() { return std::move(layout_); }

private:
    QueueLayout layout_;
};

/// `feature`: one of features.h, ALWAYS, or several of them: "MEDIA_OR_LIGHT_PATTERN".
static bool isPresent(const Features& features, const std::string& feature) {
    const size_t either = feature.find("_OR_");
    if (either != std::string::npos)
        return isPresent(features, feature.substr(0, either)) || isPresent(features, feature.substr(either + 4));
    return feature == "ALWAYS" || features.has(featureNamed(feature));
}

/// The number of words of a type; `inRgb`: that number in RGB rendering.
static int wordsOf(const std::string& type, int inRgb, const Features& features) {
    return type == "spectrum" && features.has(Feature::SPECTRAL) ? CHANNELS_SPECTRAL : inRgb;
}

#define ADD_FIELD(q, type, name, FEATURE) builder.add(#name, #type, wordsOf(#type, WORDS_##type, features), isPresent(features, #FEATURE));
#define ADD_LAYOUT(q, FIELDS) { LayoutBuilder builder(#q); FIELDS(ADD_FIELD, q) layouts.push_back(builder.take()); }
#define ADD_QUEUE(q, FIELDS, ITEMS, FEATURE) ADD_LAYOUT(q, FIELDS)

std::vector<QueueLayout> queueLayouts(const Features& features) {
    std::vector<QueueLayout> layouts;
    QUEUES(ADD_QUEUE)
    return layouts;
}

QueueLayout filmLayout(const Features& features, uint buckets, int lightGroups) {
    LayoutBuilder builder("film");
    FILM_FIELDS(ADD_FIELD, film)
    if (buckets > 0) builder.add("buckets", "bucket", static_cast<int>(buckets) * BUCKET_WORDS, true);
    if (lightGroups > 0) builder.add("groups", "group", lightGroups * GROUP_WORDS, true);
    if (features.has(Feature::FIREFLIES)) builder.add("bands", "band", BRIGHTNESS_BANDS * GROUP_WORDS, true);
    for (const auto& [name, feature] : {std::pair{"object_mattes", Feature::CRYPTO_OBJECT}, {"material_mattes", Feature::CRYPTO_MATERIAL}})
        if (features.has(feature)) builder.add(name, "matte", MATTE_SLOTS * MATTE_WORDS, true);
    return builder.take();
}

QueueLayout vertexLayout(const Features& features) {
    LayoutBuilder builder("vertex");
    VERTEX_FIELDS(ADD_FIELD, vertex)
    return builder.take();
}

QueueLayout gridLayout(const Features& features) {
    LayoutBuilder builder("grid");
    GRID_FIELDS(ADD_FIELD, grid)
    return builder.take();
}

int bsdfWords(const Features& features) {
    std::vector<QueueLayout> layouts;
#define ADD_BSDF(name, FEATURE, PARAMETERS) if (features.has(KindFeature::FEATURE)) ADD_LAYOUT(name, PARAMETERS)
    BSDFS(ADD_BSDF)
#undef ADD_BSDF
    int most = 0;
    for (const QueueLayout& l : layouts) most = std::max(most, l.words);
    return most;
}

QueueLayout queueLayout(const std::string& name, const Features& features) {
    for (QueueLayout& l : queueLayouts(features))
        if (l.name == name) return l;
    throw std::out_of_range("no queue is called " + name);
}

const FieldLayout& QueueLayout::field(const std::string& wanted) const {
    const auto found = std::find_if(fields.begin(), fields.end(), [&](const FieldLayout& f) { return f.name == wanted; });
    if (found == fields.end()) throw std::out_of_range("queue " + name + " has no field " + wanted);
    return *found;
}

}  // namespace eikonal
