// Lights without a shape; then the light sampler.

#include "kinds/light_packing.h"
#include "pack/alias_table.h"
#include "pack/environment_guide.h"
#include "pack/light_sampler.h"

#include <algorithm>
#include <cmath>

namespace eikonal {

class LightPacker {
public:
    explicit LightPacker(Packer& packer) : packer_(packer), tables_(packer.packed.tables) {}

    void pack() {
        if (!countsMaterials(packer_.scene.integrator)) return;
        powers_ = packer_.areaPowers;
        for (const bool infinite : {false, true}) {
            firstInfinite_ = tables_.lights.size();
            for (const Light& description : packer_.scene.lights)
                if (isInfinite(*description.kind) == infinite) add(description);
        }
        packLightSampler(packer_, std::move(powers_), firstInfinite_);
        packGuide();
    }

private:
    bool isLeftToBsdfs(const LightKind& e) const { return e.traits.isLeftToBsdfs && followsBsdfs(packer_.scene.integrator); }

    /// Whether the light sampler chooses it as a light that is infinitely far away.
    bool isInfinite(const LightKind& e) const {
        return (e.place == LightPlace::DISTANT || e.place == LightPlace::INFINITE) && !isLeftToBsdfs(e);
    }

    void add(const Light& description) {
        const LightKind& entry = *description.kind;
        const PackedLight packed = entry.traits.pack(packer_, description);
        packer_.packed.require(entry.feature, description.where.toString());
        if (entry.place == LightPlace::INFINITE) tables_.environments.push_back(static_cast<uint>(tables_.lights.size()));
        tables_.lights.push_back(packed.l);
        powers_.push_back(isLeftToBsdfs(entry) ? 0 : packed.power);
    }

    /// Makes room for an environment guide, where one may pay.
    void packGuide() {
        const IntegratorDescription& integrator = packer_.scene.integrator;
        const settings& frame = packer_.packed.frame();
        const auto isGuided = [](const light& l) { return kindOf(l).traits.isLeftToBsdfs; };
        if (!followsBsdfs(integrator) || !samplesLights(integrator) || packer_.packed.features.has(Feature::LIGHT_TREE) ||
            std::ranges::none_of(tables_.lights, isGuided))
            return;
        if (integrator.environmentGuide == EnvironmentGuide::never) return;
        packer_.packed.isAlwaysGuided = integrator.environmentGuide == EnvironmentGuide::always;
        if (!GuideBudget::of(frame.width, frame.height, packer_.scene.sampler.pixelSamples).isEnough()) return;
        packer_.packed.require(Feature::ENVIRONMENT_GUIDE,
                               "an infinite light that is the same everywhere, and enough samples to learn where it is seen");
        packer_.packed.require(Feature::LIGHTS, "the same");
        packUnlearnedGuide(tables_);
        if (tables_.light_aliases.empty()) tables_.light_aliases = makeAliasTable(std::vector<double>(tables_.lights.size(), 0.0));
    }

    Packer& packer_;
    SceneTables& tables_;
    std::vector<double> powers_;
    size_t firstInfinite_ = 0;   ///< lights from this one on are infinitely far away
};

void packLights(Packer& packer) { LightPacker(packer).pack(); }

}  // namespace eikonal
