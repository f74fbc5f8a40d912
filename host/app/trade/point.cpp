#include "app/trade/point.h"

#include "image/image_file.h"
#include "median.h"

#include <filesystem>

namespace eikonal {

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

}  // namespace eikonal
