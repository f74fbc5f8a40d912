#include "kinds/integrator_kind.h"
#include "pack/light_sampler.h"

#include "pack/alias_table.h"
#include "pack/light_tree.h"

#include <algorithm>

namespace eikonal {

class LightSamplerPacker {
public:
    LightSamplerPacker(Packer& packer, std::vector<double> powers, size_t firstInfinite)
        : packer_(packer), tables_(packer.packed.tables), powers_(std::move(powers)), firstInfinite_(firstInfinite) {}

    void pack() {
        for (double& p : powers_) p = std::max(p, 0.0);   // what takes light away is not sampled, and leaves the others alone
        const LightSampler asked = packer_.scene.integrator.lightSampler;
        double total = 0;
        for (double p : powers_) total += p;
        if (powers_.empty()) return;
        if (total <= 0 || !samplesLights(packer_.scene.integrator)) {
            /* Nothing to sample: only what paths meet by themselves, if anything, is seen */
            for (light& l : tables_.lights) l.pmf = 0;
            return;
        }
        packer_.packed.require(Feature::LIGHTS, std::to_string(powers_.size()) + " lights");
        /* Of lights behind portals, an item can carry a direction for one */
        const bool looksAtAll = packer_.scene.integrator.kind->splitsRays && powers_.size() <= MOST_TREE_LIGHTS &&
                                !packer_.packed.features.has(Feature::PORTALS);
        const auto sampled = std::count_if(powers_.begin(), powers_.end(), [](double p) { return p > 0; });
        const bool many = sampled > static_cast<std::ptrdiff_t>(fewLights);
        if (!looksAtAll && (asked == LightSampler::bvh || (asked == LightSampler::automatic && many))) { makeTree(); return; }
        if (asked == LightSampler::uniform) weighAlike();
        else weighInfiniteLights();
        tables_.light_aliases = makeAliasTable(powers_);
        for (size_t i = 0; i < powers_.size(); ++i) tables_.lights[i].pmf = tables_.light_aliases[i].pmf;
        if (looksAtAll) {
            for (light& l : tables_.lights) l.pmf = l.pmf > 0 ? 1.0f : 0.0f;
            packer_.packed.frame().tree_lights = static_cast<uint>(powers_.size());
        }
    }

private:
    /// What lies infinitely far away has no power that could be compared with a lamp's: each has the probability of all lamps together,
    /// which share theirs by power (as pbrt-v4's light BVH has it).
    void weighInfiniteLights() {
        double finite = 0;
        for (size_t i = 0; i < firstInfinite_; ++i) finite += powers_[i];
        for (size_t i = firstInfinite_; i < powers_.size(); ++i)
            if (powers_[i] > 0) powers_[i] = finite > 0 ? finite : 1;
    }

    /// Every light as likely as another.
    void weighAlike() {
        for (double& p : powers_) p = p > 0 ? 1 : 0;
    }

    /// A tree over all lights but the infinite ones, each of which is as likely as the tree.
    void makeTree() {
        std::vector<LightBounds> bounds;
        for (size_t i = 0; i < firstInfinite_; ++i)
            bounds.push_back(powers_[i] > 0 ? boundsOfLight(tables_.lights[i], powers_[i]) : LightBounds{});
        LightTree tree = buildLightTree(bounds);
        settings& frame = packer_.packed.frame();
        frame.first_infinite = static_cast<uint>(firstInfinite_);
        frame.infinite_count = static_cast<uint>(powers_.size() - firstInfinite_);
        frame.lights_in_tree = static_cast<uint>(tree.lights);
        const float lots = static_cast<float>(frame.infinite_count + (tree.lights > 0 ? 1 : 0));
        for (size_t i = 0; i < powers_.size(); ++i) {
            tables_.lights[i].leaf = i < firstInfinite_ ? tree.leaves[i] : NONE;
            tables_.lights[i].pmf = i >= firstInfinite_ || tree.leaves[i] != NONE ? 1 / lots : 0;
        }
        tables_.light_nodes = std::move(tree.nodes);
        packer_.packed.require(Feature::LIGHT_TREE, std::to_string(powers_.size()) + " lights");
    }

    Packer& packer_;
    SceneTables& tables_;
    std::vector<double> powers_;
    size_t firstInfinite_ = 0;   ///< lights from this one on are infinitely far away
};

void packLightSampler(Packer& packer, std::vector<double> powers, size_t firstInfinite) {
    LightSamplerPacker(packer, std::move(powers), firstInfinite).pack();
}

}  // namespace eikonal
