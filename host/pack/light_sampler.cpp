#include "kinds/integrator_kind.h"
#include "pack/light_sampler.h"

#include "pack/alias_table.h"
#include "pack/light_tree.h"

#include <algorithm>

namespace eikonal {

double leastPower(std::span<const double> powers) {
    double total = 0, count = 0;
    for (double p : powers) { total += p; count += p > 0; }
    return count > 0 ? double{LEAST_SHARE} * total / count : 0;
}

void raiseToLeastPower(std::span<double> powers) {
    const double least = leastPower(powers);
    for (double& p : powers)
        if (p > 0) p = std::max(p, least);
}

class LightSamplerPacker {
public:
    LightSamplerPacker(const PackContext& context, LightTables& tables, settings& frame, std::vector<double> powers, size_t firstInfinite)
        : context_(context), tables_(tables), frame_(frame), powers_(std::move(powers)), firstInfinite_(firstInfinite) {}

    void pack() {
        for (double& p : powers_) p = std::max(p, 0.0);   // negative lights are not sampled
        const LightSampler asked = context_.scene.integrator.lightSampler;
        double total = 0;
        for (double p : powers_) total += p;
        if (powers_.empty()) return;
        if (total <= 0 || !samplesLights(context_.scene.integrator)) {
            /* Nothing to sample: paths only find the lights that they hit */
            for (light& l : tables_.lights) l.pmf = 0;
            return;
        }
        context_.require(Feature::LIGHTS, std::to_string(powers_.size()) + " lights");
        /* An item carries the direction of at most one light with a portal */
        const bool looksAtAll =
            context_.scene.integrator.kind->splitsRays && powers_.size() <= MOST_TREE_LIGHTS && !context_.has(Feature::PORTALS);
        if (!looksAtAll && (asked == LightSampler::bvh || (asked == LightSampler::automatic && wantsTree()))) { makeTree(); return; }
        if (asked == LightSampler::uniform) weighAlike();
        else weighInfiniteLights();
        raiseToLeastPower(powers_);   // a light that lights an image alone must be sampled however strong the others are
        tables_.light_aliases = makeAliasTable(powers_);
        for (size_t i = 0; i < powers_.size(); ++i) tables_.lights[i].pmf = tables_.light_aliases[i].pmf;
        if (looksAtAll) {
            for (light& l : tables_.lights) l.pmf = l.pmf > 0 ? 1.0f : 0.0f;
            frame_.tree_lights = static_cast<uint>(powers_.size());
        }
    }

private:
    /// The power of an infinite light is not comparable with that of a lamp. Each infinite light is as probable as all lamps together,
    /// which are chosen by power (as in pbrt-v4's light BVH).
    void weighInfiniteLights() {
        double finite = 0;
        for (size_t i = 0; i < firstInfinite_; ++i) finite += powers_[i];
        for (size_t i = firstInfinite_; i < powers_.size(); ++i)
            if (powers_[i] > 0) powers_[i] = finite > 0 ? finite : 1;
    }

    /// The tree pays if lights are many, or so different that power leaves one of them less than the least share.
    bool wantsTree() const {
        const auto sampled = std::ranges::count_if(powers_, [](double p) { return p > 0; });
        if (sampled > static_cast<std::ptrdiff_t>(fewLights)) return true;
        const std::span finite = std::span(powers_).first(firstInfinite_);
        const double least = leastPower(finite);
        return std::ranges::any_of(finite, [&](double p) { return p > 0 && p < least; });
    }

    /// All lights have the same probability.
    void weighAlike() {
        for (double& p : powers_) p = p > 0 ? 1 : 0;
    }

    /// Makes a tree over the finite lights; each infinite light is as probable as the tree.
    void makeTree() {
        std::vector<LightBounds> bounds;
        for (size_t i = 0; i < firstInfinite_; ++i)
            bounds.push_back(powers_[i] > 0 ? boundsOfLight(tables_.lights[i], powers_[i]) : LightBounds{});
        LightTree tree = buildLightTree(bounds);
        frame_.first_infinite = static_cast<uint>(firstInfinite_);
        frame_.infinite_count = static_cast<uint>(powers_.size() - firstInfinite_);
        frame_.lights_in_tree = static_cast<uint>(tree.lights);
        const float lots = static_cast<float>(frame_.infinite_count + (tree.lights > 0 ? 1 : 0));
        for (size_t i = 0; i < powers_.size(); ++i) {
            tables_.lights[i].leaf = i < firstInfinite_ ? tree.leaves[i] : NONE;
            tables_.lights[i].pmf = i >= firstInfinite_ || tree.leaves[i] != NONE ? 1 / lots : 0;
        }
        tables_.light_nodes = std::move(tree.nodes);
        context_.require(Feature::LIGHT_TREE, std::to_string(powers_.size()) + " lights");
    }

    const PackContext& context_;
    LightTables& tables_;
    settings& frame_;
    std::vector<double> powers_;
    size_t firstInfinite_ = 0;   ///< lights from this one on are infinitely far away
};

void packLightSampler(const PackContext& context, LightTables& tables, settings& frame, std::vector<double> powers, size_t firstInfinite) {
    LightSamplerPacker(context, tables, frame, std::move(powers), firstInfinite).pack();
}

}  // namespace eikonal
