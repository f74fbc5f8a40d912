#pragma once
// The film in host memory: what has been added up of the samples of each pixel, by the nodes of sample_nodes.h. The device holds some
// blocks of it at a time, so an image may be as large as host memory.

#include "film/batch.h"
#include "film/join_sums.h"
#include "film/splats.h"
#include "film/totals.h"

#include <memory>
#include <span>
#include <vector>

namespace eikonal {

/// Zeros for `words` words of each pixel, which take no memory before they are written.
std::shared_ptr<uint[]> allocatePlanes(const PixelRect& pixels, int words);

class Film {
public:
    /// The film of the pixels that are rendered of a scene, for kernels built with `features`. Memory pages are taken only when written.
    /// firstSample: of each pixel, the beginning of a leaf; samples before it are not taken.
    Film(const PackedScene& scene, const Features& features, unsigned firstSample = 0);
    explicit Film(const PackedScene& scene) : Film(scene, scene.features) {}

    const PixelRect& pixels() const { return pixels_; }
    /// Of the whole image.
    int width() const { return static_cast<int>(scene_.frame().width); }
    int height() const { return static_cast<int>(scene_.frame().height); }
    int words() const { return layout_.words; }
    const QueueLayout& layout() const { return layout_; }

    /// Copies a batch's pixels to `blocks`, block after block: those of a leaf that has begun; the others are 0. Word w of pixel i of the
    /// batch is blocks[w * batch.pixels() + i].
    void copyTo(std::span<uint> blocks, const Batch& batch) const;
    /// Takes over such pixels, to which the batch's samples have been added; overwrites them.
    void keep(std::span<uint> blocks, const Batch& batch);

    unsigned firstSample() const { return firstSample_; }
    /// The end of the samples taken of each pixel, row by row; also of those that do not count because they missed the lens.
    std::span<const unsigned> taken() const { return taken_; }

    /// Word `word` of node number `node` (nodesOf) of the pixels of row y, which is counted from the top of the whole image.
    std::span<const uint> row(size_t node, int word, int y) const {
        return {&nodes_[node][rowStart(word, y)], static_cast<size_t>(pixels_.width())};
    }
    /// Replaces the pixels x0 <= x < x1 of row y, which get the samples up to `end`. Word w of node k of pixel x is
    /// words[(k * words() + w) * (x1 - x0) + x - x0].
    void restore(int y, int x0, int x1, unsigned end, std::span<const uint> words);

    /// With light paths: what they have added. Null: none begin in the scene.
    SplatSums* splats() { return splats_.get(); }
    const SplatSums* splats() const { return splats_.get(); }

    /// Bytes per pixel of the film while it is rendered up to `end` samples, and of the image that develop() returns.
    static size_t bytes(const PackedScene& scene, unsigned end);
    static size_t developedBytes(const PackedScene& scene);

    /// All samples together: joined anew at each call, unless the film keeps one node of each pixel, whose memory they then share.
    FilmTotals totals() const;

private:
    size_t plane() const { return static_cast<size_t>(pixels_.width()) * static_cast<size_t>(pixels_.height()); }
    size_t index(int x, int y) const {
        return static_cast<size_t>(y - pixels_.y0) * static_cast<size_t>(pixels_.width()) + static_cast<size_t>(x - pixels_.x0);
    }
    size_t rowStart(int word, int y) const { return static_cast<size_t>(word) * plane() + index(pixels_.x0, y); }
    std::vector<SampleRange> nodesUntil(unsigned end) const { return nodesOf({firstSample_, end}); }
    void needNodes(size_t count);
    void keepRow(std::span<uint> blocks, const Batch& batch, size_t block, int y);

    const PackedScene& scene_;
    PixelRect pixels_;
    QueueLayout layout_;
    JoinedSums sums_;
    unsigned firstSample_;
    std::vector<std::shared_ptr<uint[]>> nodes_;   ///< of node k: word w of pixel i is [w * plane + i]
    std::vector<unsigned> taken_;
    std::shared_ptr<SplatSums> splats_;
};

}  // namespace eikonal
