#include "film/totals.h"

#include "film/fireflies.h"
#include "film/planes.h"
#include "film/projection.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace eikonal {

FilmTotals::FilmTotals(const PackedScene& scene, const QueueLayout& layout, std::shared_ptr<uint[]> words, const SplatSums* splats)
    : width_(static_cast<int>(scene.frame().width)),
      height_(static_cast<int>(scene.frame().height)),
      pixels_(scene.pixels),
      layout_(layout),
      data_(std::move(words)) {
    if (splats) developSplats(*splats, scene.frame().splat_scale);
}

void FilmTotals::developSplats(const SplatSums& splats, double scale) {
    splatColors_.resize(plane());
    splatVariances_.resize(plane());
    lostSplats_.resize(plane());
    const bool hasPasses = splats.words() > splat_words;
    for (auto* v : {&directSplats_, &indirectSplats_, &volumeSplats_}) v->resize(hasPasses ? plane() : 0);
    const size_t width = static_cast<size_t>(pixels_.width());
    for (const SplatRow& row : splats.rows()) {
        double samples = 0;
        for (const SampleRange& range : row.samples) samples += range.length();
        if (samples == 0) continue;
        const size_t first = static_cast<size_t>(row.y - pixels_.y0) * width;
        for (size_t x = 0; x < width; ++x) {
            const auto word = [&](splat_word w) { return static_cast<double>(static_cast<std::int64_t>(row.words[w * width + x])); };
            const double unit = 1 / (double{SPLAT_UNITS} * scale * samples);
            const glm::dvec3 all(word(splat_red), word(splat_green), word(splat_blue));
            splatColors_[first + x] = glm::vec3(all * unit);
            if (hasPasses) {
                const glm::dvec3 direct(word(splat_direct_red), word(splat_direct_green), word(splat_direct_blue)),
                    volume(word(splat_volume_red), word(splat_volume_green), word(splat_volume_blue));
                directSplats_[first + x] = glm::vec3(direct * unit);
                indirectSplats_[first + x] = glm::vec3((all - direct - volume) * unit);
                volumeSplats_[first + x] = glm::vec3(volume * unit);
            }
            /* Of a sum of many rare events; the mean of n samples has 1 / n^2 of it */
            const double variance = word(splat_square) / (double{SPLAT_SQUARE_UNITS} * scale * scale * samples * samples);
            splatVariances_[first + x] = static_cast<float>(std::min(variance, double{std::numeric_limits<float>::max()}));
            lostSplats_[first + x] = static_cast<unsigned>(std::clamp(word(splat_lost), 0., double{std::numeric_limits<unsigned>::max()}));
        }
    }
}

const uint* FilmTotals::numbers(const char* field) const { return data_.get() + static_cast<size_t>(layout_.field(field).slot) * plane(); }
const float* FilmTotals::floats(const char* field) const { return reinterpret_cast<const float*>(numbers(field)); }

/// A weighted sum of directions over the sum of the weights, which filters with negative values make negative, normalised.
static glm::vec3 meanDirection(const float* sum, float weight, size_t n, size_t i) {
    const glm::vec3 direction(sum[i], sum[n + i], sum[2 * n + i]);
    const float length = std::copysign(glm::length(direction), weight);
    return length != 0 ? direction / length : glm::vec3(0);
}

std::vector<glm::vec3> FilmTotals::meanColors(const float* sum) const {
    const size_t n = plane();
    const float* weight = floats("weight");
    std::vector<glm::vec3> colors(n);
    tbb::parallel_for(size_t{0}, n, [&](size_t i) {
        colors[i] = glm::vec3(sum[i], sum[n + i], sum[2 * n + i]) * (weight[i] != 0 ? 1 / weight[i] : 0);
    });
    return colors;
}

void FilmTotals::developPasses(FilmImage& image) const {
    const auto develop = [&](std::vector<glm::vec3>& layer, const char* field, const std::vector<glm::vec3>& splats) {
        layer = meanColors(floats(field));
        for (size_t i = 0; i < splats.size(); ++i) layer[i] += splats[i];
    };
    develop(image.emission, "emission", {});
    develop(image.direct, "direct", directSplats_);
    develop(image.indirect, "indirect", indirectSplats_);
    develop(image.volume, "volume", volumeSplats_);
}

void FilmTotals::developLightGroups(FilmImage& image, const std::vector<std::string>& names) const {
    const float* sum = floats("groups");
    for (const std::string& name : names) {
        image.lightGroups.emplace_back(name, meanColors(sum));
        sum += GROUP_WORDS * plane();
    }
}

void FilmTotals::developAovs(FilmImage& image, const PackedScene& scene) const {
    const size_t n = plane();
    for (auto* v : {&image.albedo, &image.normal, &image.geometricNormal, &image.position}) v->resize(n);
    for (auto* v : {&image.uv, &image.depthSlope, &image.motion}) v->resize(n);
    const bool moves = layout_.field("opening").words > 0;
    for (auto* v : {&image.depth, &image.object, &image.material}) v->resize(n);
    const float *weight = floats("weight"), *albedo = floats("albedo"), *position = floats("position"), *uv = floats("uv"),
                *distance = floats("distance"), *seen = floats("seen"), *normal = floats("normal"), *geometric = floats("ng");
    const float *opening = moves ? floats("opening") : position, *closing = moves ? floats("closing") : position;
    const uint *object = numbers("object"), *material = numbers("material");
    tbb::parallel_for(size_t{0}, n, [&](size_t i) {
        const float inverse = weight[i] != 0 ? 1 / weight[i] : 0;
        image.albedo[i] = glm::clamp(glm::vec3(albedo[i], albedo[n + i], albedo[2 * n + i]) * inverse, 0.0f, 1.0f);
        image.normal[i] = meanDirection(normal, weight[i], n, i);
        image.geometricNormal[i] = meanDirection(geometric, weight[i], n, i);
        image.object[i] = static_cast<float>(object[i]);
        image.material[i] = static_cast<float>(material[i]);
        image.depth[i] = std::numeric_limits<float>::infinity();
        if (!(seen[i] > 0)) return;
        const double count = seen[i];
        const auto meanPoint = [&](const float* sum) { return glm::dvec3(sum[i], sum[n + i], sum[2 * n + i]) / count; };
        const glm::dvec3 p = meanPoint(position);
        image.motion[i] = glm::vec2(motionInImage(scene, meanPoint(opening), meanPoint(closing)));
        image.depthSlope[i] = glm::vec2(depthSlope(scene, p, image.geometricNormal[i]));
        image.uv[i] = glm::vec2(uv[i] / count, uv[n + i] / count);
        image.position[i] = glm::vec3(p * scene.worldScale + scene.worldCenter);
        image.depth[i] = static_cast<float>(distance[i] / count * scene.worldScale);
    });
}

void FilmTotals::reweightFireflies(FilmImage& image) const {
    const auto rows = static_cast<size_t>(pixels_.height());
    image.fireflies = firefliesIn({plane() / rows, rows, floats("bands"), floats("weight")});
    for (size_t i = 0; i < plane(); ++i) image.color[i] -= image.fireflies[i];
}

FilmImage FilmTotals::develop(const PackedScene& scene) const {
    FilmImage image(width_, height_, {pixels_.x0, pixels_.x1, pixels_.y0, pixels_.y1});
    const size_t n = plane();
    const Planes planes(*this);
    image.variance.resize(n);
    image.sampleCount.resize(n);
    for (size_t i = 0; i < n; ++i) {
        image.color[i] = planes.color(i);
        image.sampleCount[i] = static_cast<float>(planes.count[i]);
        image.variance[i] = planes.variance(i, image.color[i]);
    }
    if (scene.features.has(Feature::FIREFLIES)) reweightFireflies(image);
    if (layout_.field("emission").words > 0) developPasses(image);
    if (scene.constants.lightGroups > 0) developLightGroups(image, scene.lightGroups);
    const auto& [objects, materials] = cryptomatteLayerNames;
    if (scene.features.has(Feature::CRYPTO_OBJECT)) developMattes(image, "object_mattes", objects, scene.objectManifest);
    if (scene.features.has(Feature::CRYPTO_MATERIAL)) developMattes(image, "material_mattes", materials, scene.materialManifest);
    if (layout_.field("albedo").words > 0) developAovs(image, scene);
    if (scene.frame().bucket_count > 0) developSpectrum(image, scene);
    return image;
}

FilmTotals::Invalid FilmTotals::invalid() const {
    Invalid found;
    const uint* counts = numbers("invalid");
    for (size_t i = 0; i < plane(); ++i) {
        const size_t lost = counts[i] + (lostSplats_.empty() ? 0 : lostSplats_[i]);
        if (!lost) continue;
        if (!found.count) {
            found.x = pixels_.x0 + static_cast<int>(i % static_cast<size_t>(pixels_.width()));
            found.y = pixels_.y0 + static_cast<int>(i / static_cast<size_t>(pixels_.width()));
        }
        found.count += lost;
    }
    return found;
}

FilmTotals::Samples FilmTotals::samples() const {
    const uint *begin = numbers("count"), *end = begin + plane();
    const auto [low, high] = std::minmax_element(begin, end);
    return {*low, *high, std::accumulate(begin, end, 0.0) / static_cast<double>(plane())};
}

}  // namespace eikonal
