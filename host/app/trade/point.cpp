#include "app/trade/point.h"

#include "image/image_file.h"
#include "median.h"

#include <nlohmann/json.hpp>

#include <filesystem>

namespace eikonal {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SeedResult, seed, renderSeconds, meanSamples, expectedError, squaredError, mean)

double Point::medianSeconds() const {
    std::vector<double> seconds;
    for (const SeedResult& s : seeds) seconds.push_back(s.renderSeconds);
    return median(seconds);
}

double Point::meanSamples() const {
    double sum = 0;
    for (const SeedResult& s : seeds) sum += s.meanSamples;
    return seeds.empty() ? 0 : sum / static_cast<double>(seeds.size());
}

void PointImages::remove(const std::string& stem) {
    for (const char* part : {".mean.exr", ".squares.exr", ".first.exr"}) std::filesystem::remove(stem + part);
}

void PointImages::save(const std::string& stem) const {
    FilmImage squares = sums.mean;
    squares.color = sums.squares;
    writeImage(stem + ".mean.exr", sums.mean, {});
    writeImage(stem + ".squares.exr", squares, {});
    writeImage(stem + ".first.exr", first, {});
}

PointImages PointImages::load(const std::string& stem, int seeds) {
    PointImages images;
    images.sums.seeds = seeds;
    images.sums.mean = readImage(stem + ".mean.exr").image;
    images.sums.squares = readImage(stem + ".squares.exr").image.color;
    images.first = readImage(stem + ".first.exr").image;
    return images;
}

TrueError estimateTrueError(const Point& point, const SeedSums& sums, const References& references) {
    std::vector<double> squaredErrors, means;
    for (const SeedResult& s : point.seeds) {
        squaredErrors.push_back(s.squaredError);
        means.push_back(s.mean);
    }
    return estimateTrueError(sums, squaredErrors, means, references);
}

void to_json(nlohmann::json& json, const Point& p) {
    json = {{"setting", p.setting},
            {"rung", p.rung},
            {"prepareSeconds", p.prepareSeconds},
            {"compileSeconds", p.compileSeconds},
            {"compiledKernels", p.compiledKernels},
            {"isSameImage", p.isSameImage},
            {"failure", p.failure},
            {"seeds", nlohmann::json::array()}};
    for (const SeedResult& s : p.seeds) json["seeds"].push_back(s);
}

void from_json(const nlohmann::json& json, Point& p) {
    json.at("setting").get_to(p.setting);
    json.at("rung").get_to(p.rung);
    json.at("prepareSeconds").get_to(p.prepareSeconds);
    json.at("compileSeconds").get_to(p.compileSeconds);
    json.at("compiledKernels").get_to(p.compiledKernels);
    json.at("isSameImage").get_to(p.isSameImage);
    json.at("failure").get_to(p.failure);
    for (const auto& s : json.at("seeds")) p.seeds.push_back(s.get<SeedResult>());
}

}  // namespace eikonal
