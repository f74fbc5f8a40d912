#include "app/commands.h"
#include "image/compare.h"
#include "image/image_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>

namespace eikonal {

/// Tolerances of a block, as in the gallery's table: 5 % and 4 standard errors.
constexpr double relative = 0.05, sigmas = 4;

static nlohmann::ordered_json asJson(glm::dvec3 v) { return {v.x, v.y, v.z}; }

int compareCommand(const Options& o) {
    FilmImage image = readImage(o.image).image;
    if (o.scatter) image.variance.clear();
    const Comparison c = compare(image, readImage(o.reference).image);
    const BlockDifference& worst = c.worstBlock(relative, sigmas);
    long off = 0;
    for (const BlockDifference& block : c.blocks) off += block.distance(relative, sigmas) > 1;
    if (o.json) {
        nlohmann::ordered_json json{{"image", o.image}, {"reference", o.reference}};
        json["mean"] = asJson(c.mean);
        json["referenceMean"] = asJson(c.referenceMean);
        json["worstMean"] = c.worstMean();
        json["relativeMse"] = c.relativeMse;
        json["invalidPixels"] = c.invalid;
        json["blocks"] = c.blocks.size();
        json["blocksOff"] = off;
        json["worstBlock"] = {{"x", worst.x}, {"y", worst.y}, {"distance", worst.distance(relative, sigmas)}, {"image", asJson(worst.image)}, {"reference", asJson(worst.reference)}};
        std::fputs((json.dump(2) + "\n").c_str(), stdout);
    } else {
        std::fputs(fmt::format("mean            {:.6g} {:.6g} {:.6g}\nreference mean  {:.6g} {:.6g} {:.6g}\nworst channel   {:.3f} % off\nrelative MSE    {:.4g}\n"
                               "blocks off      {} of {}, by more than {:.0f} % and {:.0f} standard errors; the worst, at pixel ({}, {}), by {:.3g} times that\npixels skipped  {} that are not finite\n",
                               c.mean.x, c.mean.y, c.mean.z, c.referenceMean.x, c.referenceMean.y, c.referenceMean.z, c.worstMean() * 100, c.relativeMse, off, c.blocks.size(),
                               relative * 100, sigmas, worst.x, worst.y, worst.distance(relative, sigmas), c.invalid).c_str(), stdout);
    }
    return static_cast<int>(ExitCode::success);
}

}  // namespace eikonal
