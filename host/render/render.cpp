#include "render/render.h"

#include "render/adaptive.h"

#include <bit>
#include <chrono>

namespace eikonal {
namespace {

/// Neighbouring pixels and several of their samples travel together, for coherence: where all pixels get the same samples, a block is not smaller than this.
constexpr unsigned smallestBlock = 1024;

/// Blocks of the image, and which samples they get next.
struct Pass {
    BlockSize size;
    std::vector<Block> blocks;
};

/// The next samples of all pixels: as few as fill a wave at first, then about twice as many as there are already, so that the whole image is
/// there early and waves get compact later.
Pass uniformPass(const PixelRect& rect, unsigned done, unsigned end, unsigned mostPaths) {
    const unsigned left = end - done;
    const unsigned long pixels = static_cast<unsigned long>(rect.width()) * static_cast<unsigned long>(rect.height());
    const unsigned fill = static_cast<unsigned>(std::max<unsigned long>(mostPaths / std::max(pixels, 1ul), 1));
    const unsigned wanted = std::min(std::max(fill, done + 1), left);
    const unsigned blockPixels = std::bit_floor(std::max(mostPaths / wanted, std::min(smallestBlock, mostPaths)));
    const unsigned samples = std::min(left, std::max(mostPaths / blockPixels, 1u));
    Pass pass{chooseBlockSize(rect, blockPixels), {}};
    for (int y = rect.y0; y < rect.y1; y += pass.size.height())
        for (int x = rect.x0; x < rect.x1; x += pass.size.width()) pass.blocks.push_back({x, y, done, samples});
    return pass;
}

/// A pass whose blocks are small enough for a wave of so many paths.
Pass cut(const std::vector<Block>& blocks, BlockSize size, const PixelRect& rect, unsigned mostPaths) {
    BlockSize small = size;
    while (small.pixels() > mostPaths) --(small.log2Height > small.log2Width ? small.log2Height : small.log2Width);
    Pass pass{small, {}};
    for (const Block& b : blocks) {
        const PixelRect part = b.within(rect, size);
        for (int y = part.y0; y < part.y1; y += small.height())
            for (int x = part.x0; x < part.x1; x += small.width()) pass.blocks.push_back({x, y, b.firstSample, b.samples});
    }
    return pass;
}

/// A render that is under way.
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
        while (samples_ < uniformEnd) {
            const Pass pass = uniformPass(rect, samples_, uniformEnd, most);
            const unsigned samples = pass.blocks.front().samples;
            if (!trace(pass)) return {false, samples_, {}};
            samples_ += samples;
        }
        if (!control_.targetError) return {true, samples_, {}};

        AdaptiveSampling adaptive(rect, samples_, end, *control_.targetError);
        for (;;) {
            const std::vector<Block> blocks = adaptive.nextPass(film_);
            if (blocks.empty()) return {true, samples_, adaptive.error()};
            allPaths_ = adaptive.plannedSamples() - pixels_ * control_.firstSample;
            if (!trace(cut(blocks, AdaptiveSampling::blockSize, rect, most))) return {false, samples_, {}};
        }
    }

private:
    /// Whether it came to an end.
    bool trace(const Pass& pass) {
        Batches batches(pass.size, pass.blocks, tracer_.mostPaths());
        while (!batches.empty()) {
            if (control_.stop && control_.stop()) { context_.finish(); return false; }
            trace(batches.next());
        }
        context_.finish();
        return true;
    }

    void trace(const Batch& batch) {
        const PixelRect& rect = film_.pixels();
        const size_t bytes = static_cast<size_t>(batch.pixels()) * static_cast<size_t>(film_.words()) * sizeof(uint);
        if (blocks_.size() < bytes) blocks_ = Buffer(context_, bytes, "blocks of the film");
        film_.upload(context_, blocks_, batch);
        tracer_.trace(batch, rect.x1, rect.y1);
        tracer_.resolve(batch, blocks_);
        film_.download(context_, blocks_, batch);
        std::uint64_t paths = 0;
        for (const Block& b : batch.blocks) {
            const PixelRect part = b.within(rect, batch.size);
            paths += static_cast<std::uint64_t>(part.width()) * static_cast<std::uint64_t>(part.height()) * b.samples;
        }
        profile_.paths += paths;
        paths_ += static_cast<double>(paths);
        if (control_.progress)
            control_.progress({std::min(paths_ / allPaths_, 1.0), std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(), samples_,
                               control_.firstSample + paths_ / pixels_});
    }

    const Context& context_;
    Tracer& tracer_;
    Film& film_;
    Profile& profile_;
    const RenderControl& control_;
    const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    Buffer blocks_;
    unsigned samples_;                      ///< that every pixel has
    double pixels_ = 0;
    double paths_ = 0, allPaths_ = 0;       ///< traced by now, and expected to be in the end
};

}  // namespace

RenderResult render(const Context& context, Tracer& tracer, Film& film, Profile& profile, const RenderControl& control) {
    return Rendering(context, tracer, film, profile, control).run();
}

}  // namespace eikonal
