#include "film/film.h"

#include "film/planes.h"
#include "film/projection.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>

namespace eikonal {

Film::Film(const PackedScene& scene, const Features& features)
    : width_(static_cast<int>(scene.frame().width)),
      height_(static_cast<int>(scene.frame().height)),
      pixels_(scene.pixels),
      layout_(filmLayout(features, scene.frame().bucket_count)) {
    const size_t words = plane() * static_cast<size_t>(layout_.words);
    data_.reset(static_cast<uint*>(std::calloc(words, sizeof(uint))));
    if (!data_)
        throw Error(ExitCode::scene, "not enough memory for an image of " + std::to_string(pixels_.width()) + " x " +
                                         std::to_string(pixels_.height()) + " pixels");
    taken_.resize(plane());
}

/// Calls copy(word of the film, word of staged_, words) for each row of each block of a batch and each word of its pixels.
template <class Copy> void Film::forStagedRows(const Batch& batch, Copy copy) {
    const size_t pixels = batch.pixels();
    tbb::parallel_for(0, layout_.words, [&](int word) {
        for (size_t block = 0; block < batch.blocks.size(); ++block) {
            const PixelRect part = batch.blocks[block].within(pixels_, batch.size);
            for (int y = part.y0; y < part.y1; ++y) {
                const size_t row = block * batch.size.pixels() + static_cast<size_t>(y - part.y0) * batch.size.width();
                copy(&data_[static_cast<size_t>(word) * plane() + index(part.x0, y)], &staged_[static_cast<size_t>(word) * pixels + row],
                     static_cast<size_t>(part.width()));
            }
        }
    });
}

void Film::upload(const Context& context, Buffer& buffer, const Batch& batch) {
    staged_.resize(static_cast<size_t>(batch.pixels()) * static_cast<size_t>(layout_.words));
    forStagedRows(batch, [](const uint* film, uint* staged, size_t n) { std::copy_n(film, n, staged); });
    buffer.write(context, staged_.data(), staged_.size() * sizeof(uint));
}

void Film::download(const Context& context, const Buffer& buffer, const Batch& batch) {
    staged_.resize(static_cast<size_t>(batch.pixels()) * static_cast<size_t>(layout_.words));
    buffer.read(context, staged_.data(), staged_.size() * sizeof(uint));
}

void Film::keep(const Batch& batch) {
    forStagedRows(batch, [](uint* film, const uint* staged, size_t n) { std::copy_n(staged, n, film); });
    for (const Block& block : batch.blocks) {
        const PixelRect part = block.within(pixels_, batch.size);
        for (int y = part.y0; y < part.y1; ++y) std::fill_n(&taken_[index(part.x0, y)], part.width(), block.firstSample + block.samples);
    }
}

void Film::restore(int y, int x0, int x1, unsigned samples, std::span<const uint> words) {
    const size_t n = static_cast<size_t>(x1 - x0);
    for (int word = 0; word < layout_.words; ++word)
        std::copy_n(&words[static_cast<size_t>(word) * n], n, &data_[static_cast<size_t>(word) * plane() + index(x0, y)]);
    std::fill_n(&taken_[index(x0, y)], n, samples);
}

const uint* Film::numbers(const char* field) const { return data_.get() + static_cast<size_t>(layout_.field(field).slot) * plane(); }
const float* Film::floats(const char* field) const { return reinterpret_cast<const float*>(numbers(field)); }

/// A sum of directions, normalised.
static glm::vec3 meanDirection(const float* sum, size_t n, size_t i) {
    const glm::vec3 direction(sum[i], sum[n + i], sum[2 * n + i]);
    const float length = glm::length(direction);
    return length > 0 ? direction / length : glm::vec3(0);
}

void Film::developAovs(FilmImage& image, const PackedScene& scene) const {
    const size_t n = plane();
    for (auto* v : {&image.albedo, &image.normal, &image.geometricNormal, &image.position}) v->resize(n);
    for (auto* v : {&image.uv, &image.depthSlope, &image.motion}) v->resize(n);
    const bool moves = layout_.field("opening").words > 0;
    for (auto* v : {&image.depth, &image.object, &image.material}) v->resize(n);
    const float *weight = floats("weight"), *albedo = floats("albedo"), *position = floats("position"), *uv = floats("uv"),
                *distance = floats("distance"), *seen = floats("seen");
    for (size_t i = 0; i < n; ++i) {
        const float inverse = weight[i] != 0 ? 1 / weight[i] : 0;
        image.albedo[i] = glm::clamp(glm::vec3(albedo[i], albedo[n + i], albedo[2 * n + i]) * inverse, 0.0f, 1.0f);
        image.normal[i] = meanDirection(floats("normal"), n, i);
        image.geometricNormal[i] = meanDirection(floats("ng"), n, i);
        image.object[i] = static_cast<float>(numbers("object")[i]);
        image.material[i] = static_cast<float>(numbers("material")[i]);
        image.depth[i] = std::numeric_limits<float>::infinity();
        if (!(seen[i] > 0)) continue;
        const double count = seen[i];
        const auto meanPoint = [&](const float* sum) { return glm::dvec3(sum[i], sum[n + i], sum[2 * n + i]) / count; };
        const glm::dvec3 p = meanPoint(position);
        image.motion[i] =
            glm::vec2(motionInImage(scene, moves ? meanPoint(floats("opening")) : p, moves ? meanPoint(floats("closing")) : p));
        image.depthSlope[i] = glm::vec2(depthSlope(scene, p, image.geometricNormal[i]));
        image.uv[i] = glm::vec2(uv[i] / count, uv[n + i] / count);
        image.position[i] = glm::vec3(p * scene.worldScale + scene.worldCenter);
        image.depth[i] = static_cast<float>(distance[i] / count * scene.worldScale);
    }
}

size_t Film::bytes(const PackedScene& scene) {
    return static_cast<size_t>(filmLayout(scene.features, scene.frame().bucket_count).words) * sizeof(uint);
}

size_t Film::developedBytes(const PackedScene& scene) {
    const size_t always = sizeof(glm::vec3) + 2 * sizeof(float),
                 ofSurfaces = 4 * sizeof(glm::vec3) + 3 * sizeof(glm::vec2) + 3 * sizeof(float);
    return always + (scene.features.has(Feature::AOVS) ? ofSurfaces : 0) + scene.frame().bucket_count * sizeof(float);
}

FilmImage Film::develop(const PackedScene& scene) const {
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
    if (layout_.field("albedo").words > 0) developAovs(image, scene);
    if (scene.frame().bucket_count > 0) developSpectrum(image, scene);
    return image;
}

Film::Invalid Film::invalid() const {
    Invalid found;
    const uint* counts = numbers("invalid");
    for (size_t i = 0; i < plane(); ++i) {
        if (!counts[i]) continue;
        if (!found.count) {
            found.x = pixels_.x0 + static_cast<int>(i % static_cast<size_t>(pixels_.width()));
            found.y = pixels_.y0 + static_cast<int>(i / static_cast<size_t>(pixels_.width()));
        }
        found.count += counts[i];
    }
    return found;
}

Film::Samples Film::samples() const {
    const uint *begin = numbers("count"), *end = begin + plane();
    const auto [low, high] = std::minmax_element(begin, end);
    return {*low, *high, std::accumulate(begin, end, 0.0) / static_cast<double>(plane())};
}

}  // namespace eikonal
