#include "render/render.h"

#include "render/adaptive.h"

#include <bit>
#include <chrono>
#include <deque>
#include <utility>

namespace eikonal {
namespace {

/// The fewest pixels of a block in uniform passes. Neighbouring pixels are traced together for coherence.
constexpr unsigned smallestBlock = 1024;

/// A pass: blocks of the image, and the samples that they get next.
struct Pass {
    BlockSize size;
    std::vector<Block> blocks;
    unsigned samples = 0;       ///< samples that it adds to every pixel
};

/// The next pass over all pixels: first as few samples as fill a wave, then about as many as are already done, so that a complete image
/// exists early and later waves are coherent.
Pass uniformPass(const PixelRect& rect, unsigned done, unsigned end, unsigned mostPaths) {
    const unsigned left = end - done;
    const unsigned long pixels = static_cast<unsigned long>(rect.width()) * static_cast<unsigned long>(rect.height());
    const unsigned fill = static_cast<unsigned>(std::max<unsigned long>(mostPaths / std::max(pixels, 1ul), 1));
    const unsigned wanted = std::min(std::max(fill, done + 1), left);
    const unsigned blockPixels = std::bit_floor(std::max(mostPaths / wanted, std::min(smallestBlock, mostPaths)));
    const unsigned samples = std::min(left, std::max(mostPaths / blockPixels, 1u));
    Pass pass{chooseBlockSize(rect, blockPixels), {}, samples};
    for (int y = rect.y0; y < rect.y1; y += pass.size.height())
        for (int x = rect.x0; x < rect.x1; x += pass.size.width()) pass.blocks.push_back({x, y, done, samples});
    return pass;
}

/// A pass with the blocks split until each fits a wave of mostPaths paths.
Pass cut(const std::vector<Block>& blocks, BlockSize size, const PixelRect& rect, unsigned mostPaths) {
    BlockSize small = size;
    while (small.pixels() > mostPaths) --(small.log2Height > small.log2Width ? small.log2Height : small.log2Width);
    Pass pass{small, {}, 0};
    for (const Block& b : blocks) {
        const PixelRect part = b.within(rect, size);
        for (int y = part.y0; y < part.y1; y += small.height())
            for (int x = part.x0; x < part.x1; x += small.width()) pass.blocks.push_back({x, y, b.firstSample, b.samples});
    }
    return pass;
}

/// A render in progress.
class Rendering {
public:
    Rendering(const Context& context, Tracer& tracer, Film& film, Profile& profile, const RenderControl& control)
        : context_(context), tracer_(tracer), film_(film), profile_(profile), control_(control), samples_(control.firstSample) {}

    RenderResult run() {
        const PixelRect& rect = film_.pixels();
        const unsigned most = tracer_.mostPaths(), end = control_.endSample;
        pixels_ = static_cast<double>(rect.width()) * rect.height();
        allPaths_ = pixels_ * (end - samples_);
        const unsigned uniformEnd = control_.targetError ? std::min(end, samples_ + AdaptiveSampling::firstSamples) : end;
        unsigned planned = samples_;
        trace([&]() -> std::optional<Pass> {
            if (planned >= uniformEnd) return {};
            Pass pass = uniformPass(rect, planned, uniformEnd, most);
            planned += pass.samples;
            return pass;
        });
        if (stopped_) return {false, samples_, {}};
        if (!control_.targetError) return {true, samples_, {}};

        AdaptiveSampling adaptive(rect, samples_, end, *control_.targetError, control_.errorMetric);
        for (;;) {
            const std::vector<Block> blocks = adaptive.nextPass(film_);
            if (blocks.empty()) return {true, samples_, adaptive.error()};
            allPaths_ = adaptive.plannedSamples() - pixels_ * control_.firstSample;
            std::optional<Pass> pass = cut(blocks, AdaptiveSampling::blockSize, rect, most);
            trace([&] { return std::exchange(pass, std::nullopt); });
            if (stopped_) return {false, samples_, {}};
        }
    }

private:
    /// Traces passes until `nextPass` returns nothing.
    void trace(const std::function<std::optional<Pass>()>& nextPass) {
        std::optional<Batches> batches;
        const auto next = [&]() -> std::optional<Batch> {
            if (control_.stop && control_.stop()) stopped_ = true;
            if (stopped_) return {};
            if (!batches || batches->empty()) {
                const std::optional<Pass> pass = nextPass();
                if (!pass) return {};
                batches.emplace(pass->size, pass->blocks, tracer_.mostPaths());
                traced_.push_back({pass->samples, layersOf(*pass)});
            }
            return batches->next();
        };
        const StopWatcher watcher(tracer_.stopFlag(), control_.abandon);
        tracer_.trace({next, [this](const Batch& batch) { resolve(batch); }, film_.pixels().x1, film_.pixels().y1});
        context_.finish();
        stopped_ |= tracer_.stopFlag().isRaised();
    }

    void resolve(const Batch& batch) {
        const PixelRect& rect = film_.pixels();
        const size_t bytes = static_cast<size_t>(batch.pixels()) * static_cast<size_t>(film_.words()) * sizeof(uint);
        if (blocks_.size() < bytes) blocks_ = Buffer(context_, bytes, "blocks of the film");
        film_.upload(context_, blocks_, batch);
        tracer_.resolve(batch, blocks_);
        film_.download(context_, blocks_, batch);
        if (tracer_.stopFlag().isRaised()) return;   // resolve_film may have left pixels as they were
        std::uint64_t paths = 0;
        for (const Block& b : batch.blocks) {
            const PixelRect part = b.within(rect, batch.size);
            paths += static_cast<std::uint64_t>(part.width()) * static_cast<std::uint64_t>(part.height()) * b.samples;
        }
        profile_.paths += paths;
        paths_ += static_cast<double>(paths);
        traced_.front().layers -= batch.layers();
        if (!traced_.front().layers) { samples_ += traced_.front().samples; traced_.pop_front(); }
        if (control_.progress)
            control_.progress({std::min(paths_ / allPaths_, 1.0),
                               std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(), samples_,
                               control_.firstSample + paths_ / pixels_});
    }

    static unsigned long layersOf(const Pass& pass) {
        unsigned long sum = 0;
        for (const Block& b : pass.blocks) sum += b.samples;
        return sum;
    }

    const Context& context_;
    Tracer& tracer_;
    Film& film_;
    Profile& profile_;
    const RenderControl& control_;
    const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    Buffer blocks_;
    struct Traced { unsigned samples; unsigned long layers; };
    std::deque<Traced> traced_;             ///< passes in progress: the samples that they add to every pixel, and the layers still to trace
    bool stopped_ = false;
    unsigned samples_;                      ///< samples that every pixel has
    double pixels_ = 0;
    double paths_ = 0, allPaths_ = 0;       ///< traced so far, and expected in total
};

}  // namespace

RenderResult render(const Context& context, Tracer& tracer, Film& film, Profile& profile, const RenderControl& control) {
    return Rendering(context, tracer, film, profile, control).run();
}

}  // namespace eikonal
