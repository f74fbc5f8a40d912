#include "render/render.h"

#include <bit>
#include <chrono>
#include <cstdlib>

namespace eikonal {

TileSize chooseTileSize(const PixelRect& rect, unsigned pixels) {
    const int total = std::bit_width(std::max(pixels, 1u)) - 1;
    TileSize best{total / 2, total - total / 2};
    long fewest = -1;
    int squarest = 0;
    for (int w = 0; w <= total; ++w) {
        const int h = total - w;
        const long across = (rect.width() + (1L << w) - 1) >> w, down = (rect.height() + (1L << h) - 1) >> h;
        const long tiles = across * down;
        if (fewest < 0 || tiles < fewest || (tiles == fewest && std::abs(w - h) < squarest)) {
            fewest = tiles;
            squarest = std::abs(w - h);
            best = {w, h};
        }
    }
    return best;
}

/// Neighbouring pixels and several of their samples travel together, for coherence: a wave's tile is not smaller than this.
constexpr unsigned smallestTile = 1024;

/// What the next pass over the image is: its tiles and how many samples of each pixel. As few samples as fill a wave at first,
/// then about twice as many as there are already, so that the whole image is there early and waves get compact later.
struct Pass { unsigned tilePixels, samples; };
static Pass nextPass(unsigned done, unsigned left, const PixelRect& rect, unsigned mostPaths) {
    const unsigned long pixels = static_cast<unsigned long>(rect.width()) * static_cast<unsigned long>(rect.height());
    const unsigned fill = static_cast<unsigned>(std::max<unsigned long>(mostPaths / std::max(pixels, 1ul), 1));
    const unsigned wanted = std::min(std::max(fill, done + 1), left);
    const unsigned tilePixels = std::bit_floor(std::max(mostPaths / wanted, std::min(smallestTile, mostPaths)));
    return {tilePixels, std::min(left, std::max(mostPaths / tilePixels, 1u))};
}

unsigned render(const Context& context, Tracer& tracer, Film& film, Profile& profile, const RenderControl& control) {
    const PixelRect& rect = film.pixels();
    const auto start = std::chrono::steady_clock::now();
    const double allSamples = control.endSample - control.firstSample;
    Buffer tileFilm;
    unsigned done = 0;
    while (control.firstSample + done < control.endSample) {
        const auto [tilePixels, samples] = nextPass(done, control.endSample - control.firstSample - done, rect, tracer.mostPaths());
        const TileSize size = chooseTileSize(rect, tilePixels);
        const int width = 1 << size.log2Width, height = 1 << size.log2Height;
        tileFilm = Buffer(context, static_cast<size_t>(width) * static_cast<size_t>(height) * static_cast<size_t>(film.words()) * sizeof(uint), "a tile of the film");
        int tiles = 0;
        const int allTiles = ((rect.width() + width - 1) / width) * ((rect.height() + height - 1) / height);
        for (int y = rect.y0; y < rect.y1; y += height)
            for (int x = rect.x0; x < rect.x1; x += width) {
                if (control.stop && control.stop()) { context.finish(); return control.firstSample + done; }
                const Tile tile{x, y, size.log2Width, size.log2Height, control.firstSample + done, samples};
                const PixelRect part{x, y, std::min(x + width, rect.x1), std::min(y + height, rect.y1)};
                film.upload(context, tileFilm, part, width, height);
                tracer.trace(tile, rect.x1, rect.y1);
                tracer.resolve(tile, tileFilm);
                film.download(context, tileFilm, part, width, height);
                profile.paths += static_cast<std::uint64_t>(part.width()) * static_cast<std::uint64_t>(part.height()) * samples;
                ++tiles;
                if (control.progress) {
                    const double fraction = (done + samples * static_cast<double>(tiles) / allTiles) / allSamples;
                    control.progress({fraction, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), control.firstSample + done});
                }
            }
        done += samples;
        context.finish();
    }
    return control.firstSample + done;
}

}  // namespace eikonal
