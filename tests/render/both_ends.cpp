#include "both_ends.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace eikonal {

View view() {
    View v;
    v.lookAt = "0 1.2 -3.4  0 .9 0  0 1 0";
    v.fov = 40;
    v.width = v.height = 24;
    v.samples = 256;
    v.maxDepth = 6;
    return v;
}

std::string sceneWith(View v, const std::string& directive, const std::string& world) {
    v.more = directive;
    return sceneText(v, world);
}

std::string withIntegrator(const std::string& integrator, std::string text) {
    const std::string before = "\"volpath\"";
    return text.replace(text.find(before), before.size(), integrator);
}

const std::string room = R"(AttributeBegin
    Material "diffuse" "rgb reflectance" [.7 .7 .7]
    Shape "bilinearmesh" "point3 P" [-1 0 -1  1 0 -1  -1 0 1  1 0 1]
    Shape "bilinearmesh" "point3 P" [-1 0 1  1 0 1  -1 2 1  1 2 1]
    Material "diffuse" "rgb reflectance" [.7 .1 .1]
    Shape "bilinearmesh" "point3 P" [-1 0 -1  -1 0 1  -1 2 -1  -1 2 1]
    AttributeEnd
)";
std::string lamp(const std::string& shape) {
    return "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [10 8 6] " + shape + " AttributeEnd\n";
}
const std::string panel = lamp("Shape \"bilinearmesh\" \"point3 P\" [-.5 1.98 -.5  .5 1.98 -.5  -.5 1.98 .5  .5 1.98 .5]");
const std::string moving = "ActiveTransform EndTime Translate -.3 .2 .1 ActiveTransform All ";
std::string ball(const std::string& material) {
    return "AttributeBegin Translate .1 .5 0 Material " + material + " Shape \"sphere\" \"float radius\" .4 AttributeEnd\n";
}

Estimate meanOf(const FilmImage& image) {
    Estimate e = estimate(image);
    double variance = 0;
    for (const float v : image.variance) variance += static_cast<double>(v);
    const double n = static_cast<double>(image.pixelCount());
    e.error = glm::dvec3(std::sqrt(variance) / n);
    return e;
}

double meanGreen(const std::vector<glm::vec3>& layer) {
    double sum = 0;
    for (const glm::vec3& c : layer) sum += static_cast<double>(c.g);
    return sum / static_cast<double>(layer.size());
}

void expectSameLight(const std::string& text, const std::string& other, double bias) {
    const Rendered camera = render(text), both = render(other);
    EXPECT_EQ(both.invalid.count, 0u);
    const Estimate a = meanOf(camera.image), b = meanOf(both.image);
    const double error = std::hypot(a.error.g, b.error.g);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(a.mean[c], b.mean[c], standardErrors * std::max(a.mean[c] / a.mean.g, 1.0) * error + bias * a.mean[c]);
    EXPECT_LT(error, 0.02 * a.mean.g) << "too few samples to tell";
    const int side = camera.image.width / 4;
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x) {
            double difference = 0, variance = 0;
            for (int i = 0; i < side * side; ++i) {
                const size_t at = camera.image.index(x * side + i % side, y * side + i / side);
                difference += static_cast<double>(both.image.color[at].g - camera.image.color[at].g);
                variance += static_cast<double>(both.image.variance[at] + camera.image.variance[at]);
            }
            EXPECT_LE(std::abs(difference), 5 * std::sqrt(variance) + (1e-3 + 5 * bias) * a.mean.g * side * side)
                << "part (" << x << ", " << y << ")";
        }
}

void expectSameBitsInAnyWaves(const PackedScene& scene, const FilmImage& image) {
    for (const auto& [paths, batches] : {std::pair(64u, 8u), {1000u, 1u}, {1000u, 8u}, {65472u, 3u}}) {
        RenderSetup setup;
        setup.shape.wavePaths = paths;
        setup.shape.batches = batches;
        expectSameBits(image, render(scene, setup).image, std::to_string(paths) + " paths in a wave");
    }
}

void expectSameBitsInRangesOfSamples(const PackedScene& scene, const FilmImage& image) {
    RenderSetup setup;
    setup.splits = {3, 4, 16};
    expectSameBits(image, render(scene, setup).image, "in parts");
}

void expectSameBitsInACrop(PackedScene scene, const FilmImage& image) {
    scene.pixels = {5, 3, 18, 16};
    expectSameBits(image, render(std::move(scene)).image, "the crop");
}

}  // namespace eikonal
