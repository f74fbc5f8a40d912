#include "render/path_guide_pilot.h"

#include "pack/path_guide.h"
#include "render/guide_gain.h"
#include "render/pilot.h"

#include <algorithm>
#include <cmath>

namespace eikonal {
namespace {

/// Not a seed that a user is likely to choose.
constexpr uint guideSeed = 0x67756964;

constexpr int rounds = 3;
constexpr size_t samplesOfPixel = 4;

/// Records the vertices of one batch after another.
class VertexRecorder : public PilotRecorder {
public:
    explicit VertexRecorder(const Context& context) : context_(context) {}

    /// From now on, paths are guided by `guide` with probability `share`, and are asked what they gain by it.
    void measure(GuideGain& gain, const LightTables& guide, float share) {
        gain_ = &gain;
        guide_ = &guide;
        share_ = double{share};
    }

    void begin(unsigned paths) override {
        light_.assign(paths, 0);
        last_.assign(paths, none);
        depths_.assign(paths, 0);
        bounces_ = 0;
        firstPath_ = nextPath_;
        nextPath_ += paths;
        if (gain_) gain_->begin(paths);
    }

    bool bounced(const Bounced& bounce) override {
        const QueueItems &rays = bounce.rays, &paths = bounce.paths;
        /* What the paths have found since the last bounce arrived at all their vertices so far */
        const std::vector<float> light = readMeans(context_, paths, "L");
        for (size_t p = 0; p < paths.count; ++p) {
            if (!std::isfinite(light[p])) continue;
            const float more = light[p] - light_[p];
            light_[p] = light[p];
            if (more > 0 && gain_) gain_->found(p, double{more});
            if (more > 0)
                for (uint v = last_[p]; v != none; v = vertices_[v].before) vertices_[v].record.light += more * vertices_[v].inverseBeta;
        }
        const std::vector<uint> path = readField<uint>(context_, rays, "path"), depth = readField<uint>(context_, rays, "depth");
        const std::vector<float> end = readField<float>(context_, rays, "t_max"), pdf = readField<float>(context_, rays, "pdf");
        std::vector<float> beta = readMeans(context_, rays, "beta");
        if (hasField(rays, "r_u")) {
            const std::vector<float> scale = readMeans(context_, rays, "r_u");
            for (size_t i = 0; i < beta.size(); ++i) beta[i] /= std::max(scale[i], 1e-30f);
        }
        const std::vector<vec3> o = readVectors(context_, rays, "o"), d = readVectors(context_, rays, "d"),
                                n = readVectors(context_, rays, "n");
        const std::vector<uint> map = gain_ ? readField<uint>(context_, bounce.hits, "path_map") : std::vector<uint>();
        for (size_t i = 0; i < rays.count; ++i) {
            const size_t p = path[i] - paths.first;
            if (end[i] < 0 || depth[i] <= depths_[p]) continue;
            depths_[p] = depth[i];
            const bool isOnSurface = n[i].x != 0 || n[i].y != 0 || n[i].z != 0;
            if (!isOnSurface || !(pdf[i] > 0) || !(beta[i] > 0)) continue;
            if (gain_ && map[i]) {
                const double q = double{pdf[i]}, p0 = (q - share_ * pdfOfGuide(*guide_, map[i], d[i])) / (1 - share_);
                if (p0 > 0) gain_->sampled(p, q, p0);
            }
            vertices_.push_back({{o[i], n[i], d[i], 0, pdf[i]}, 1 / beta[i], last_[p], firstPath_ + p});
            last_[p] = static_cast<uint>(vertices_.size() - 1);
        }
        return ++bounces_ < mostPilotBounces;
    }

    /// Path after path, however they were divided into batches. Begins anew.
    std::vector<GuideRecord> take() {
        std::ranges::stable_sort(vertices_, {}, &Vertex::path);
        std::vector<GuideRecord> all;
        for (const Vertex& v : vertices_) all.push_back(v.record);
        vertices_.clear();
        return all;
    }

private:
    static constexpr uint none = NONE;
    struct Vertex {
        GuideRecord record;
        float inverseBeta;   ///< over the throughput of the ray that leaves it
        uint before;         ///< the vertex before it on its path; none: it is the first
        size_t path;         ///< its number among all pilot paths
    };
    const Context& context_;
    GuideGain* gain_ = nullptr;
    const LightTables* guide_ = nullptr;
    double share_ = 0;
    std::vector<Vertex> vertices_;
    std::vector<float> light_;     ///< by path, as the next ones
    std::vector<uint> last_, depths_;
    int bounces_ = 0;
    size_t firstPath_ = 0, nextPath_ = 0;
};

}  // namespace

void usePathGuide(const Context& context, DeviceScene& scene, const LearnedPathGuide& guide) {
    if (guide.isEmpty()) return;
    scene.replace(context, "path_guide_nodes", guide.tables.path_guide_nodes);
    scene.replace(context, "path_guide_aliases", guide.tables.path_guide_aliases);
}

LearnedPathGuide pilotPathGuide(const Context& context, DeviceScene& scene, const PackedScene& packed, Wave& wave) {
    LearnedPathGuide guide;
    if (!packed.features.has(Feature::PATH_GUIDE)) return guide;
    const size_t paths = guidePilotPaths(packed.paths());
    if (paths == 0) return guide;
    /* The device may hold what an earlier survey learned, which must not guide this one */
    packUnlearnedPathGuide(guide.tables);
    usePathGuide(context, scene, guide);
    const settings frame = pilotFrame(packed.frame(), guideSeed);
    scene.setFrame(context, frame);
    VertexRecorder recorder(context);
    GuideGain gain;
    for (int round = 0; round < rounds && !wave.stopFlag().isRaised(); ++round) {
        /* The paths of the last round are guided by those before, and are not among them */
        if (packed.isGuideOptional && round + 1 == rounds) recorder.measure(gain, guide.tables, frame.guided_share);
        const double part = std::exp2(round) / (std::exp2(rounds) - 1);
        const auto pixels = static_cast<size_t>(part * static_cast<double>(paths / samplesOfPixel));
        tracePilot(frame, scatterPixels(frame, pixels, samplesOfPixel, static_cast<size_t>(round) * samplesOfPixel), wave, recorder);
        if (wave.stopFlag().isRaised()) break;
        if (packed.isGuideOptional && round + 1 == rounds) guide.gain = gain.varianceRatio(samplesOfPixel);
        learnPathGuide(guide.tables, recorder.take(), packed.features.has(Feature::TRANSMISSION));
        usePathGuide(context, scene, guide);
    }
    scene.setFrame(context, packed.frame());
    return guide;
}

}  // namespace eikonal
