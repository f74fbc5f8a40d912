#include "app/commands.h"
#include "color/transfer.h"
#include "error.h"
#include "image/compare.h"
#include "image/flip.h"
#include "image/image_file.h"
#include "json_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>

namespace eikonal {

/// Tolerances of a block, as in the gallery's table: 5 % and 4 standard errors.
constexpr double relative = 0.05, sigmas = 4;

static nlohmann::ordered_json asJson(glm::dvec3 v) { return {v.x, v.y, v.z}; }

/// The map of FLIP as colours, in linear light.
static FilmImage heatMap(const Flip& flip, const PixelBounds& part) {
    FilmImage image(part.x1 - part.x0, part.y1 - part.y0);
    for (std::size_t i = 0; i < flip.map.size(); ++i) {
        const glm::vec3 stored = heatColor(flip.map[i]);
        for (int c = 0; c < 3; ++c) image.color[i][c] = static_cast<float>(linearFromSrgb(stored[c]));
    }
    return image;
}

int compareCommand(const Options& o) {
    if (!o.heatMap.empty()) {
        std::error_code absent;
        for (const std::string& input : {o.image, o.reference})
            if (std::filesystem::equivalent(o.heatMap, input, absent))
                throw UsageError(fmt::format("--heat-map would overwrite \"{}\", which is compared; name another file", input));
        checkWritable(o.heatMap);
    }
    FilmImage image = readImage(o.image).image;
    const FilmImage reference = readImage(o.reference).image;
    if (o.scatter) image.variance.clear();
    const Comparison c = compare(image, reference);
    const Flip difference = flip(image, reference);
    if (!o.heatMap.empty()) writeImage(o.heatMap, heatMap(difference, sharedPixels(image, reference)), {});
    const BlockDifference& worst = c.worstBlock(relative, sigmas);
    long off = 0;
    for (const BlockDifference& block : c.blocks) off += block.distance(relative, sigmas) > 1;
    if (o.json) {
        nlohmann::ordered_json json{{"image", o.image}, {"reference", o.reference}};
        json["mean"] = asJson(c.mean);
        json["referenceMean"] = asJson(c.referenceMean);
        json["worstMean"] = c.worstMean();
        json["relativeMse"] = c.relativeMse;
        json["trimmedRelativeMse"] = c.trimmedRelativeMse;
        json["flip"] = difference.mean;
        json["invalidPixels"] = c.invalid;
        json["blocks"] = c.blocks.size();
        json["blocksOff"] = off;
        json["worstBlock"] = {{"x", worst.x},
                              {"y", worst.y},
                              {"distance", worst.distance(relative, sigmas)},
                              {"image", asJson(worst.image)},
                              {"reference", asJson(worst.reference)}};
        std::fputs((jsonText(json, 2) + "\n").c_str(), stdout);
    } else {
        std::fputs(fmt::format("mean            {:.6g} {:.6g} {:.6g}\nreference mean  {:.6g} {:.6g} {:.6g}\nworst channel   {:.3f} % "
                               "off\nrelative MSE    {:.4g} ({:.4g} without the worst thousandth of the pixels)\n"
                               "FLIP            {:.4f}\n"
                               "blocks off      {} of {}, by more than {:.0f} % and {:.0f} standard errors; the worst, at pixel ({}, {}), "
                               "by {:.3g} times that\npixels skipped  {} that are not finite\n",
                               c.mean.x, c.mean.y, c.mean.z, c.referenceMean.x, c.referenceMean.y, c.referenceMean.z, c.worstMean() * 100,
                               c.relativeMse, c.trimmedRelativeMse, difference.mean, off, c.blocks.size(), relative * 100, sigmas,
                               worst.x, worst.y, worst.distance(relative, sigmas), c.invalid)
                       .c_str(),
                   stdout);
    }
    if (o.failAbove && difference.mean > *o.failAbove)
        throw Error(ExitCode::scene, fmt::format("the mean FLIP is {:.4f}, above --fail-above {}", difference.mean, *o.failAbove));
    return static_cast<int>(ExitCode::success);
}

}  // namespace eikonal
