// Lights of every kind, and the light sampler: an alias table, or a tree.

#include "pack/packer.h"

#include "pack/image_lights.h"
#include "pack/light_tree.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace eikonal {

template <class... F> struct Overloaded : F... { using F::operator()...; };

static double luminanceOf(glm::vec3 s) { return 0.2126 * s.r + 0.7152 * s.g + 0.0722 * s.b; }
static glm::dvec3 toGlm(vec3 v) { return {v.x, v.y, v.z}; }

std::vector<alias_entry> makeAliasTable(const std::vector<double>& weights) {
    const size_t n = weights.size();
    double sum = 0;
    for (double w : weights) {
        if (!(w >= 0)) throw std::logic_error("a weight of an alias table is negative");
        sum += w;
    }
    std::vector<alias_entry> table(n);
    std::vector<double> scaled(n);
    std::vector<size_t> small, large;
    for (size_t i = 0; i < n; ++i) {
        const double p = sum > 0 ? weights[i] / sum : 1.0 / static_cast<double>(n);
        table[i].pmf = static_cast<float>(p);
        scaled[i] = p * static_cast<double>(n);
        (scaled[i] < 1 ? small : large).push_back(i);
    }
    while (!small.empty() && !large.empty()) {
        const size_t s = small.back(), l = large.back();
        small.pop_back();
        table[s].keep = static_cast<float>(scaled[s]);
        table[s].other = static_cast<uint>(l);
        scaled[l] -= 1 - scaled[s];
        if (scaled[l] < 1) { large.pop_back(); small.push_back(l); }
    }
    for (const std::vector<size_t>& rest : {small, large})
        for (size_t i : rest) { table[i].keep = 1; table[i].other = static_cast<uint>(i); }
    return table;
}

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

// ---- areas --------------------------------------------------------------------------------------------------------

/// The normal on whose side a flat element emits: its geometric one, on the side of its vertex normals if it has any.
static glm::dvec3 emittingNormal(const SceneTables& tables, const shape& s, glm::dvec3 n, const uint* corners, int count) {
    if (s.first_normal == NONE) return s.flags & shape_reversed ? -n : n;
    glm::dvec3 sum(0);
    for (int i = 0; i < count; ++i) sum += toGlm(tables.normals[s.first_normal + corners[i]]);
    return glm::dot(sum, n) < 0 ? -n : n;
}

static light triangleLight(const SceneTables& tables, const shape& s, size_t element, const color& L) {
    const uint* corner = &tables.indices[s.first_index + 3 * element];
    const vec3* p = &tables.positions[s.first_vertex];
    const glm::dvec3 a = toGlm(p[corner[0]]), b = toGlm(p[corner[1]]), c = toGlm(p[corner[2]]);
    const glm::dvec3 across = glm::cross(b - a, c - a);
    const double area = glm::length(across) / 2;
    light l = newLight(kind_triangle_light, L);
    l.p = toVec3(a); l.a = toVec3(b - a); l.b = toVec3(c - a);
    if (area > 0) {
        l.n = toVec3(emittingNormal(tables, s, across / (2 * area), corner, 3));
        l.inverse_area = static_cast<float>(1 / area);
    } else l.pmf = 0;
    return l;
}

static light bilinearLight(const SceneTables& tables, const shape& s, size_t element, const color& L) {
    const uint* corner = &tables.indices[s.first_index + 4 * element];
    const vec3* p = &tables.positions[s.first_vertex];
    const glm::dvec3 p00 = toGlm(p[corner[0]]), p10 = toGlm(p[corner[1]]), p01 = toGlm(p[corner[2]]), p11 = toGlm(p[corner[3]]);
    light l = newLight(kind_bilinear_light, L);
    l.p = toVec3(p00); l.a = toVec3(p10 - p00); l.b = toVec3(p01 - p00); l.c = toVec3(p11 - p10 - p01 + p00);
    glm::dvec3 n = glm::cross(p10 + p11 - p00 - p01, p01 + p11 - p00 - p10);
    /* The area by quadrature: what the sampler's probability needs */
    double area = 0;
    constexpr int steps = 16;
    for (int i = 0; i < steps * steps; ++i) {
        const double u = (i % steps + 0.5) / steps, v = (i / steps + 0.5) / steps;
        area += glm::length(glm::cross(toGlm(l.a) + v * toGlm(l.c), toGlm(l.b) + u * toGlm(l.c))) / (steps * steps);
    }
    if (area > 0) {
        n = glm::normalize(n);
        l.n = toVec3(emittingNormal(tables, s, n, corner, 4));
        l.inverse_area = static_cast<float>(1 / area);
    } else l.pmf = 0;
    return l;
}

static light sphereLight(Packer& packer, const Shape& description, const shape& s, const Sphere& sphere, const glm::dmat4& m, const color& L) {
    light l = newLight(kind_sphere_light, L);
    const double scale = uniformScale(m), radius = sphere.radius * scale;
    l.p = toVec3(transformPoint(m, glm::dvec3(0)));
    l.radius = static_cast<float>(radius);
    l.inverse_area = static_cast<float>(1 / (4 * M_PI * radius * radius));
    l.n = {s.flags & shape_reversed ? -1.0f : 1.0f, 0, 0};
    const bool whole = sphere.zMin <= -sphere.radius && sphere.zMax >= sphere.radius && sphere.phiMax >= 360;
    if (scale == 0 || !whole) {
        packer.diagnostics.warnOnce("partial sphere light", description.where,
                                    "a part of a sphere, or a sphere stretched to an ellipsoid, emits light but is not sampled as a light: expect noise");
        l.pmf = 0;
        l.inverse_area = 0;
    }
    return l;
}

static light diskLight(const shape& s, const Disk& disk, const glm::dmat4& m, const color& L) {
    light l = newLight(kind_disk_light, L);
    const glm::dvec3 a = transformVector(m, {disk.radius, 0, 0}), b = transformVector(m, {0, disk.radius, 0});
    l.p = toVec3(transformPoint(m, {0, 0, disk.height}));
    l.a = toVec3(a); l.b = toVec3(b);
    const double hole = disk.innerRadius / disk.radius, extent = std::clamp(disk.phiMax, 0.0, 360.0) / 360;
    l.radius = static_cast<float>(hole);
    l.extent = static_cast<float>(extent);
    const double area = glm::length(glm::cross(a, b)) * M_PI * (1 - hole * hole) * extent;
    l.inverse_area = static_cast<float>(1 / area);
    l.n = toVec3(transformNormal(m, {0, 0, 1}) * (s.flags & shape_reversed ? -1.0 : 1.0));
    return l;
}

static light cylinderLight(const shape& s, const Cylinder& cylinder, const glm::dmat4& m, const color& L) {
    light l = newLight(kind_cylinder_light, L);
    const glm::dvec3 a = transformVector(m, {cylinder.radius, 0, 0}), b = transformVector(m, {0, cylinder.radius, 0});
    const glm::dvec3 c = transformVector(m, {0, 0, cylinder.zMax - cylinder.zMin});
    l.p = toVec3(transformPoint(m, {0, 0, cylinder.zMin}));
    l.a = toVec3(a); l.b = toVec3(b); l.c = toVec3(c);
    l.extent = static_cast<float>(std::clamp(cylinder.phiMax, 0.0, 360.0) / 360);
    /* The area by quadrature: what the sampler's probability needs */
    double area = 0;
    constexpr int steps = 256;
    for (int i = 0; i < steps; ++i) {
        const double phi = 2 * M_PI * l.extent * (i + 0.5) / steps;
        area += glm::length(glm::cross(std::cos(phi) * b - std::sin(phi) * a, c)) * 2 * M_PI * l.extent / steps;
    }
    l.inverse_area = static_cast<float>(1 / area);
    /* dp/dphi x c points outwards, unless the transform mirrors it */
    l.n = {((s.flags & shape_reversed) != 0) != swapsHandedness(m) ? -1.0f : 1.0f, 0, 0};
    return l;
}

/// Emitted power in scene units: what the sampler's probabilities follow.
static double areaPower(const light& l, double luminance) { return l.pmf > 0 ? M_PI * luminance / l.inverse_area * (l.two_sided ? 2 : 1) : 0; }

void packAreaLight(Packer& packer, const Shape& s, shape& packed, const glm::dmat4& m, size_t elements) {
    const AreaLight& description = packer.scene.areaLights[static_cast<size_t>(s.areaLight)];
    std::vector<light>& lights = packer.packed.tables.lights;
    packed.first_light = static_cast<uint>(lights.size());
    const bool isUnseen = s.alpha.texture == none && s.alpha.value.value() <= 0;
    if (isUnseen) packed.flags |= shape_is_unseen;
    if (description.image != none) packed.emission = packEmissionImage(packer, description);
    const bool hasPattern = packed.emission != NONE || (packed.alpha != NONE && !isUnseen);
    const double scale = description.scale * (description.image != none ? meanLuminance(packer, description.image) : 1);
    const color L = packEmission(packer, description.L, scale);
    const SceneTables& tables = packer.packed.tables;
    for (size_t e = 0; e < elements; ++e) {
        light l = std::visit(Overloaded{
            [&](const TriangleMesh&) { return triangleLight(tables, packed, e, L); },
            [&](const BilinearMesh&) { return bilinearLight(tables, packed, e, L); },
            [&](const Sphere& q) { return sphereLight(packer, s, packed, q, m, L); },
            [&](const Disk& q) { return diskLight(packed, q, m, L); },
            [&](const Cylinder& q) { return cylinderLight(packed, q, m, L); },
            [&](const CurveShape&) -> light { throw std::logic_error("curves do not emit"); },
            [&](const ImplicitSurface&) -> light { throw std::logic_error("implicit surfaces do not emit"); }}, s.kind);
        l.two_sided = description.twoSided ? 1 : 0;
        /* Cut out altogether, it shines unseen (as in pbrt-v4) */
        l.invisible = isUnseen;
        if (hasPattern) l.element = packed.first_element + static_cast<uint>(e);
        /* A power in watts is that of the whole shape without its holes, through each of its elements alike (pbrt-v4) */
        double factor = scale;
        if (description.power && l.inverse_area > 0) {
            const double area = 1 / (l.inverse_area * packer.space.scale * packer.space.scale);
            factor = description.scale * *description.power / (M_PI * area * (description.twoSided ? 2 : 1));
            l.L = packEmission(packer, description.L, factor);
        }
        packer.areaPowers.push_back(areaPower(l, luminanceOf(description.L, factor)));
        lights.push_back(l);
    }
    const std::string why = description.where.toString() + ": area light";
    packer.packed.require(Feature::EMITTERS, why);
    if (hasPattern) packer.packed.require(Feature::LIGHT_PATTERN, why);
    packer.packed.require(std::visit(Overloaded{
        [](const TriangleMesh&) { return Feature::LIGHT_TRIANGLE; }, [](const BilinearMesh&) { return Feature::LIGHT_BILINEAR; },
        [](const Sphere&) { return Feature::LIGHT_SPHERE; }, [](const Disk&) { return Feature::LIGHT_DISK; },
        [](const Cylinder&) { return Feature::LIGHT_CYLINDER; },
        [](const CurveShape&) -> Feature { throw std::logic_error("curves do not emit"); },
        [](const ImplicitSurface&) -> Feature { throw std::logic_error("implicit surfaces do not emit"); }}, s.kind), why);
}

// ---- lights without a shape ---------------------------------------------------------------------------------------

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
        makeSampler();
    }

private:
    static bool isInfinite(const DistantLight&) { return true; }
    static bool isInfinite(const ConstantInfiniteLight&) { return true; }
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
        push(d, l, 4 * M_PI * M_PI * sceneRadius() * sceneRadius() * luminanceOf(k.L, d.scale), Feature::LIGHT_CONSTANT_ENVIRONMENT);
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
        std::vector<double> rows;
        std::vector<alias_entry> columns;
        for (int y = 0; y < n; ++y) {
            std::vector<double> row;
            for (int x = 0; x < n; ++x) {
                glm::vec3& t = texels[static_cast<size_t>(y) * n + x];
                t = {static_cast<float>(t.r * scale), static_cast<float>(t.g * scale), static_cast<float>(t.b * scale)};
                row.push_back((t.r + t.g + t.b) / 3);
                sum += luminanceOf(t);
            }
            double total = 0;
            for (double w : row) total += w;
            rows.push_back(total);
            const auto aliases = makeAliasTable(row);
            columns.insert(columns.end(), aliases.begin(), aliases.end());
        }
        const auto aliases = makeAliasTable(rows);
        tables_.environment_aliases.insert(tables_.environment_aliases.end(), aliases.begin(), aliases.end());
        tables_.environment_aliases.insert(tables_.environment_aliases.end(), columns.begin(), columns.end());
        packTexels(packer_, texels);
        return sum / (static_cast<double>(n) * n);
    }

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
        for (size_t i = 0; i < firstInfinite_; ++i) bounds.push_back(powers_[i] > 0 ? boundsOfLight(tables_.lights[i], powers_[i]) : LightBounds{});
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

    void makeSampler() {
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
        const bool looksAtAll = packer_.scene.integrator.kind == IntegratorKind::whitted && powers_.size() <= MOST_TREE_LIGHTS && !packer_.packed.features.has(Feature::PORTALS);
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

    Packer& packer_;
    SceneTables& tables_;
    std::vector<double> powers_;
    size_t firstInfinite_ = 0;   ///< lights from this one on are infinitely far away
};

void packLights(Packer& packer) { LightPacker(packer).pack(); }

}  // namespace eikonal
