#include "film/film.h"

#include "eikonal/render_passes.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdlib>
#include <map>

namespace eikonal {

std::shared_ptr<uint[]> allocatePlanes(const PixelRect& pixels, int words) {
    const size_t count = static_cast<size_t>(pixels.width()) * static_cast<size_t>(pixels.height()) * static_cast<size_t>(words);
    auto* memory = static_cast<uint*>(std::calloc(count, sizeof(uint)));
    if (!memory)
        throw Error(ExitCode::scene, "not enough memory for an image of " + std::to_string(pixels.width()) + " x " +
                                         std::to_string(pixels.height()) + " pixels");
    return {memory, [](uint* p) { std::free(p); }};
}

Film::Film(const PackedScene& scene, const Features& features, unsigned firstSample)
    : scene_(scene),
      pixels_(scene.pixels),
      layout_(filmLayout(features, scene.frame().bucket_count, scene.constants.lightGroups)),
      sums_(layout_),
      firstSample_(firstSample) {
    needNodes(1);
    taken_.resize(plane(), firstSample);
    if (scene.features.has(Feature::LIGHT_PATHS) && scene.frame().emission_count > 0)
        splats_ = std::make_shared<SplatSums>(pixels_, features.has(Feature::RENDER_PASSES));
}

void Film::needNodes(size_t count) {
    while (nodes_.size() < count) nodes_.push_back(allocatePlanes(pixels_, layout_.words));
}

void Film::copyTo(std::span<uint> blocks, const Batch& batch) const {
    const size_t pixels = batch.pixels(), words = static_cast<size_t>(layout_.words);
    std::ranges::fill(blocks, 0u);
    for (size_t block = 0; block < batch.blocks.size(); ++block) {
        const Block& b = batch.blocks[block];
        if (b.firstSample == leafBegin(b.firstSample)) continue;
        const uint* node = nodes_[nodesUntil(b.firstSample).size() - 1].get();
        const PixelRect part = b.within(pixels_, batch.size);
        for (size_t word = 0; word < words; ++word)
            for (int y = part.y0; y < part.y1; ++y)
                std::copy_n(&node[word * plane() + index(part.x0, y)], part.width(),
                            &blocks[word * pixels + block * batch.size.pixels() + static_cast<size_t>(y - part.y0) * batch.size.width()]);
    }
}

/// Joins row y of a block, whose samples are all in one leaf, to the earlier nodes.
void Film::keepRow(std::span<uint> blocks, const Batch& batch, size_t block, int y) {
    const Block& b = batch.blocks[block];
    const PixelRect part = b.within(pixels_, batch.size);
    const size_t width = static_cast<size_t>(part.width()), stagedStride = batch.pixels();
    const PixelRow<uint> row{&blocks[block * batch.size.pixels() + static_cast<size_t>(y - part.y0) * batch.size.width()], stagedStride};
    const auto rowOf = [&](size_t node) { return PixelRow<uint>{&nodes_[node][index(part.x0, y)], plane()}; };

    SampleRange range{leafBegin(b.firstSample), b.firstSample + b.samples};
    std::vector<SampleRange> nodes = nodesUntil(range.first);
    while (!nodes.empty() && joins(nodes.back(), range)) {
        const PixelRow<uint> earlier = rowOf(nodes.size() - 1);
        sums_.join({earlier.first, earlier.stride}, nodes.back(), row, range, width);
        range.first = nodes.back().first;
        nodes.pop_back();
    }
    const PixelRow<uint> place = rowOf(nodes.size());
    for (size_t word = 0; word < static_cast<size_t>(layout_.words); ++word)
        std::copy_n(row.first + word * row.stride, width, place.first + word * place.stride);
    std::fill_n(&taken_[index(part.x0, y)], width, range.end);
}

void Film::keep(std::span<uint> blocks, const Batch& batch) {
    /* Rows may be kept at the same time, but the leaves of one pixel follow one another */
    std::map<std::pair<int, int>, std::vector<size_t>> blocksAt;
    for (size_t block = 0; block < batch.blocks.size(); ++block) {
        const Block& b = batch.blocks[block];
        blocksAt[{b.y, b.x}].push_back(block);
        needNodes(nodesUntil(leafBegin(b.firstSample)).size() + 1);
    }
    std::vector<std::pair<const std::vector<size_t>*, int>> rows;
    for (const auto& [place, those] : blocksAt) {
        const PixelRect part = batch.blocks[those.front()].within(pixels_, batch.size);
        for (int y = part.y0; y < part.y1; ++y) rows.emplace_back(&those, y);
    }
    tbb::parallel_for(size_t(0), rows.size(), [&](size_t i) {
        for (const size_t block : *rows[i].first) keepRow(blocks, batch, block, rows[i].second);
    });
}

void Film::restore(int y, int x0, int x1, unsigned end, std::span<const uint> words) {
    const size_t n = static_cast<size_t>(x1 - x0), count = nodesUntil(end).size();
    needNodes(count);
    for (size_t node = 0; node < count; ++node)
        for (size_t word = 0; word < static_cast<size_t>(layout_.words); ++word)
            std::copy_n(&words[(node * static_cast<size_t>(layout_.words) + word) * n], n, &nodes_[node][word * plane() + index(x0, y)]);
    std::fill_n(&taken_[index(x0, y)], n, end);
}

FilmTotals Film::totals() const {
    std::map<unsigned, std::vector<SampleRange>> nodesOfEnd;
    bool isSimple = true;
    for (unsigned before = firstSample_; const unsigned end : taken_) {
        if (end == before) continue;
        before = end;
        const auto [found, isNew] = nodesOfEnd.try_emplace(end);
        if (isNew) found->second = nodesUntil(end);
        isSimple &= found->second.size() <= 1;
    }
    if (isSimple) return {scene_, layout_, nodes_.front(), splats_.get()};

    std::shared_ptr<uint[]> sums = allocatePlanes(pixels_, layout_.words);
    tbb::parallel_for(pixels_.y0, pixels_.y1, [&](int y) {
        for (int x = pixels_.x0, end = x; x < pixels_.x1; x = end) {
            const unsigned samples = taken_[index(x, y)];
            while (end < pixels_.x1 && taken_[index(end, y)] == samples) ++end;
            if (samples == firstSample_) continue;
            const size_t count = static_cast<size_t>(end - x), at = index(x, y);
            const std::vector<SampleRange>& nodes = nodesOfEnd.at(samples);
            std::vector<PixelRow<const uint>> rows;
            for (size_t node = 0; node < nodes.size(); ++node) rows.push_back({&nodes_[node][at], plane()});
            sums_.joinAll(nodes, rows, {&sums[at], plane()}, count);
        }
    });
    return {scene_, layout_, std::move(sums), splats_.get()};
}

size_t Film::bytes(const PackedScene& scene, unsigned end) {
    /* Several nodes of each pixel, and their totals */
    const size_t nodes = nodesOf({0, end}).size(), planes = nodes > 1 ? nodes + 1 : 1;
    /* The sums, those of the last light paths, and these on the device */
    const size_t ofSplats = SplatSums::bytesPerPixel(scene.features.has(Feature::RENDER_PASSES));
    const size_t splats = scene.features.has(Feature::LIGHT_PATHS) && end > 0 ? 3 * ofSplats : 0;
    const QueueLayout layout = filmLayout(scene.features, scene.frame().bucket_count, scene.constants.lightGroups);
    return planes * static_cast<size_t>(layout.words) * sizeof(uint) + splats;
}

size_t Film::developedBytes(const PackedScene& scene) {
    const size_t always = sizeof(glm::vec3) + 2 * sizeof(float),
                 ofSurfaces = 4 * sizeof(glm::vec3) + 3 * sizeof(glm::vec2) + 3 * sizeof(float);
    const size_t ofFireflies = scene.features.has(Feature::FIREFLIES) ? sizeof(glm::vec3) + BRIGHTNESS_BANDS * sizeof(double) : 0;
    const size_t ofPasses = scene.features.has(Feature::RENDER_PASSES) ? render_passes * sizeof(glm::vec3) : 0,
                 ofGroups = static_cast<size_t>(scene.constants.lightGroups) * sizeof(glm::vec3);
    size_t ofMattes = 0;
    for (const Feature layer : {Feature::CRYPTO_OBJECT, Feature::CRYPTO_MATERIAL})
        if (scene.features.has(layer)) ofMattes += CryptomatteLayer::perPixel * sizeof(float);
    const size_t ofChannels = scene.features.has(Feature::AOVS) ? ofSurfaces : 0, ofSpectrum = scene.frame().bucket_count * sizeof(float);
    return always + ofFireflies + ofPasses + ofGroups + ofMattes + ofChannels + ofSpectrum;
}

}  // namespace eikonal
