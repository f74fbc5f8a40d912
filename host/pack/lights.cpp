// Lights without a shape; then the light sampler.

#include "color/luminance.h"
#include "pack/alias_table.h"
#include "pack/environment_guide.h"
#include "pack/image_lights.h"
#include "pack/light_sampler.h"

#include <algorithm>
#include <cmath>

namespace eikonal {

light newLight(light_kind kind, const color& L) {
    light l{};
    l.kind = kind;
    l.L = L;
    l.pmf = 1;
    l.extent = 1;
    l.element = l.leaf = NONE;
    l.resolution = l.rows = 1;
    return l;
}

class LightPacker {
public:
    explicit LightPacker(Packer& packer) : packer_(packer), tables_(packer.packed.tables) {}

    void pack() {
        if (!countsMaterials(packer_.scene.integrator)) return;
        powers_ = packer_.areaPowers;
        for (const bool infinite : {false, true}) {
            firstInfinite_ = tables_.lights.size();
            for (const Light& description : packer_.scene.lights)
                std::visit([&](const auto& kind) { if (isInfinite(kind) == infinite) add(description, kind); }, description.kind);
        }
        packLightSampler(packer_, std::move(powers_), firstInfinite_);
        packGuide();
    }

private:
    /// Whether the light sampler takes it for a light that is infinitely far away. A sky that is the same everywhere it leaves alone where paths follow BSDFs, which
    /// find it best in the open (Karlík et al. 2019, "MIS compensation"); where a scene is closed, the environment guide samples it.
    bool isInfinite(const ConstantInfiniteLight&) const { return !followsBsdfs(packer_.scene.integrator); }
    static bool isInfinite(const DistantLight&) { return true; }
    static bool isInfinite(const ImageInfiniteLight&) { return true; }
    static bool isInfinite(const PortalInfiniteLight&) { return true; }
    template <class Kind> static bool isInfinite(const Kind&) { return false; }

    /// Intensities fall with the square of the distance, which is in scene units.
    double intensityScale() const { return packer_.space.scale * packer_.space.scale; }
    double sceneRadius() const { return packer_.bounds.empty() ? 1 : std::max(packer_.bounds.radius() * packer_.space.scale, 1e-6); }

    void push(const Light& description, light l, double power, Feature feature) {
        packer_.packed.require(feature, description.where.toString());
        tables_.lights.push_back(l);
        powers_.push_back(power);
    }

    void add(const Light& d, const PointLight& k) {
        const double factor = d.scale * intensityScale();
        light l = newLight(kind_point_light, packEmission(packer_, k.I, factor));
        l.p = toVec3(transformPoint(packer_.space.sceneFromWorld() * d.worldFromLight, k.from));
        push(d, l, 4 * M_PI * luminanceOf(k.I, factor), Feature::LIGHT_POINT);
    }

    void add(const Light& d, const SpotLight& k) {
        const double outer = std::cos(glm::radians(k.coneAngle)), inner = std::cos(glm::radians(k.coneAngle - k.coneDeltaAngle));
        const double solidAngle = 2 * M_PI * ((1 - inner) + (inner - outer) / 2);
        const double factor = d.scale * intensityScale();
        light l = newLight(kind_spot_light, packEmission(packer_, k.I, factor));
        l.p = toVec3(transformPoint(packer_.space.sceneFromWorld() * d.worldFromLight, k.from));
        l.n = toVec3(glm::normalize(transformVector(d.worldFromLight, k.to - k.from)));
        l.cos_inner = static_cast<float>(inner);
        l.cos_outer = static_cast<float>(outer);
        packer_.packed.require(Feature::LIGHT_POINT, d.where.toString());
        push(d, l, solidAngle * luminanceOf(k.I, factor), Feature::LIGHT_SPOT);
    }

    void add(const Light& d, const DistantLight& k) {
        light l = newLight(kind_distant_light, packEmission(packer_, k.L, d.scale));
        l.n = toVec3(glm::normalize(transformVector(d.worldFromLight, k.from - k.to)));
        push(d, l, M_PI * sceneRadius() * sceneRadius() * luminanceOf(k.L, d.scale), Feature::LIGHT_DISTANT);
    }

    void add(const Light& d, const ConstantInfiniteLight& k) {
        const light l = newLight(kind_constant_environment, packEmission(packer_, k.L, d.scale));
        tables_.environments.push_back(static_cast<uint>(tables_.lights.size()));
        push(d, l, isInfinite(k) ? 4 * M_PI * M_PI * sceneRadius() * sceneRadius() * luminanceOf(k.L, d.scale) : 0, Feature::LIGHT_CONSTANT_ENVIRONMENT);
    }

    /// Makes room for an environment guide, where one may pay.
    void packGuide() {
        const IntegratorDescription& integrator = packer_.scene.integrator;
        const settings& frame = packer_.packed.frame();
        const auto isConstant = [](const light& l) { return l.kind == kind_constant_environment; };
        if (!followsBsdfs(integrator) || !samplesLights(integrator) || packer_.packed.features.has(Feature::LIGHT_TREE) || std::ranges::none_of(tables_.lights, isConstant)) return;
        if (integrator.environmentGuide == EnvironmentGuide::never) return;
        packer_.packed.isAlwaysGuided = integrator.environmentGuide == EnvironmentGuide::always;
        if (!GuideBudget::of(frame.width, frame.height, packer_.scene.sampler.pixelSamples).isEnough()) return;
        packer_.packed.require(Feature::ENVIRONMENT_GUIDE, "an infinite light that is the same everywhere, and enough samples to learn where it is seen");
        packer_.packed.require(Feature::LIGHTS, "the same");
        packUnlearnedGuide(tables_);
        if (tables_.light_aliases.empty()) tables_.light_aliases = makeAliasTable(std::vector<double>(tables_.lights.size(), 0.0));
    }

    template <class Kind> void addImageLight(const Light& d, const Kind& k, Feature feature) {
        const PackedLight packed = packImageLight(packer_, d, k);
        push(d, packed.l, packed.power, feature);
    }
    void add(const Light& d, const GoniometricLight& k) { addImageLight(d, k, Feature::LIGHT_GONIOMETRIC); }
    void add(const Light& d, const ProjectionLight& k) { addImageLight(d, k, Feature::LIGHT_PROJECTION); }
    void add(const Light& d, const PortalInfiniteLight& k) {
        tables_.environments.push_back(static_cast<uint>(tables_.lights.size()));
        addImageLight(d, k, Feature::LIGHT_PORTAL_ENVIRONMENT);
    }

    void add(const Light& d, const ImageInfiniteLight& k) {
        const ImageData& image = sphereImage(packer_, d, k.image);
        light l = newLight(kind_image_environment, packWhite(packer_));
        l.resolution = static_cast<uint>(image.width);
        l.first_texel = nextTexel(packer_);
        l.first_alias = static_cast<uint>(tables_.environment_aliases.size());
        const glm::dmat4 m = d.worldFromLight;
        l.a = toVec3(glm::normalize(glm::dvec3(m[0]))); l.b = toVec3(glm::normalize(glm::dvec3(m[1]))); l.n = toVec3(glm::normalize(glm::dvec3(m[2])));
        const double mean = addTexels(image, d);
        packer_.packed.require(Feature::LIGHT_IMAGE_ENVIRONMENT, d.where.toString());
        tables_.environments.push_back(static_cast<uint>(tables_.lights.size()));
        push(d, l, 4 * M_PI * M_PI * sceneRadius() * sceneRadius() * mean, Feature::LIGHT_IMAGE_ENVIRONMENT);
    }

    /// Radiance of each texel, and alias tables over rows and within each row. Returns the mean luminance.
    double addTexels(const ImageData& image, const Light& d) {
        const int n = image.width;
        double scale = d.scale, sum = 0;
        std::vector<glm::vec3> texels;
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) texels.emplace_back(texelOf(image, x, y));
        if (d.illuminance) scale *= *d.illuminance / upwardIlluminance(image);
        std::vector<double> weights;
        for (glm::vec3& t : texels) {
            t = {static_cast<float>(t.r * scale), static_cast<float>(t.g * scale), static_cast<float>(t.b * scale)};
            weights.push_back((t.r + t.g + t.b) / 3);
            sum += luminance(t);
        }
        const Table<alias_entry> aliases = makeAliasSquare(weights, static_cast<size_t>(n));
        tables_.environment_aliases.insert(tables_.environment_aliases.end(), aliases.begin(), aliases.end());
        packTexels(packer_, texels);
        return sum / (static_cast<double>(n) * n);
    }

    Packer& packer_;
    SceneTables& tables_;
    std::vector<double> powers_;
    size_t firstInfinite_ = 0;   ///< lights from this one on are infinitely far away
};

void packLights(Packer& packer) { LightPacker(packer).pack(); }

}  // namespace eikonal
