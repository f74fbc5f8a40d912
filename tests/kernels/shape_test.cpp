// Every shape of the list SHAPES, at points that rays meet: the point is on the ray, its frame is that of the surface around it, and
// rays that leave it do not meet it again.

#include "kind_features.h"
#include "device_function.h"
#include "pack/pack.h"
#include "random_inputs.h"
#include "stage.h"

#include <gtest/gtest.h>

#include <cmath>

namespace eikonal {
namespace {

#define SHAPE_NAME(name, FEATURE, SPACE) #name,
const std::string kindNames[] = {SHAPES(SHAPE_NAME)};

/// Every shape and instances; no textures, which would take minutes to compile and cut nothing out here.
Features shapeFeatures() {
    Features features;
    features.require(Feature::INSTANCES).require(Feature::TANGENTS);
#define REQUIRE_SHAPE(name, FEATURE, SPACE) features.require(KindFeature::FEATURE);
    SHAPES(REQUIRE_SHAPE)
#undef REQUIRE_SHAPE
    return features;
}

/// A shape of each kind, as a pbrt file has it, around the origin.
std::string textOf(const std::string& kind) {
    if (kind == "triangle")
        return "Shape \"trianglemesh\" \"point3 P\" [ -1 -1 0  1 -1 .3  0 1 -.2 ] \"normal N\" [ -.2 0 1  .3 0 1  0 .4 1 ] \"point2 uv\" [ "
               "0 0  1 .2  .3 1 ]";
    if (kind == "bilinear")
        return "Shape \"bilinearmesh\" \"point3 P\" [ -1 -1 0  1 -1 .4  -1 1 .1  1 1 -.5 ] \"point2 uv\" [ 0 0  1 .2  .3 1  1.2 .9 ]";
    if (kind == "curve")
        return "Shape \"curve\" \"string type\" \"cylinder\" \"float width0\" .8 \"float width1\" .4 \"point3 P\" [ -1 0 0  -.3 .4 0  .3 "
               "-.2 .3  1 .2 .1 ]";
    if (kind == "implicit")
        return "Shape \"implicit\" \"string F\" \"x^4 + y^4 + z^4 - .3 + .1*sin(3*x)*y\" \"point3 bounds\" [ -1 -1 -1  1 .9 1 ]";
    const std::string part = kind == "disk" ? "\"float innerradius\" .2 \"float height\" .2 " : "\"float zmin\" -.7 \"float zmax\" .6 ";
    return "Shape \"" + kind + "\" \"float phimax\" 290 " + part;
}

/// The same under transforms: none, turned and scaled, stretched and mirrored; or in instances.
std::vector<std::string> scenesOf(const std::string& kind) {
    const std::string shape = textOf(kind) + "\n", stretched = "Rotate 40 1 2 3 Scale 1.5 -.7 .9 Rotate 70 2 -1 .3 ";
    return {"WorldBegin " + shape, "WorldBegin Translate 3 1 2 Rotate 50 1 1 0 Scale 7 7 7 " + shape,
            "WorldBegin ReverseOrientation " + stretched + shape,
            "WorldBegin ObjectBegin \"o\" " + shape + "ObjectEnd ObjectInstance \"o\" Translate 1.5 .5 0 " + stretched +
                "ObjectInstance \"o\""};
}

struct Probe { float t; uint element, instance; float u, v; vec3 p, error, ng, ns, dpdu, dpdv, dndu, dndv, tangent; vec2 uv; float again; };

/// What a ray meets, and how far a ray from there gets, on the side of the normal for side > 0 and on the other one for side < 0, before it
/// meets the same element again (-1: never).
std::vector<Probe> probe(const PackedScene& scene, const std::vector<vec3>& o, const std::vector<vec3>& d, const std::vector<vec3>& w,
                         const std::vector<float>& side) {
    static const DeviceFunction<Probe> function(
        {.include = "trace/bvh.clh",
         .type = "probe",
         .body = R"(
        geometry g = BIND_GEOMETRY;
        texture_tables tables = BIND_TEXTURES;
        nearest_hit best;
        best.t_max = FAR_AWAY;
        traverse_bvh(g, tables, o, d, 0.0f, traversal_nearest, no_aim(), &best);
        shape_hit hit = {best.t_max, best.u, best.v};
        result.t = best.element == NONE ? -1.0f : best.t_max; result.element = best.element; result.instance = best.instance;
            result.u = best.u; result.v = best.v;
        result.again = -1.0f;
        if (best.element != NONE) {
            surface at = eval_surface(g, tables, best.element, best.instance, o, d, 0.0f, hit);
            result.p = at.p; result.error = at.error; result.ng = at.ng; result.ns = at.ns; result.uv = at.uv;
            result.dpdu = at.dpdu; result.dpdv = at.dpdv; result.dndu = at.dndu; result.dndv = at.dndv;
                result.tangent = surface_tangent(at);
            vec3 leaving = mul(w, dot3(w, at.ng) * side < 0.0f ? -1.0f : 1.0f);
            nearest_hit next;
            next.t_max = FAR_AWAY;
            vec3 from = offset_origin(at.p, surface_offset(at), at.ng, leaving);
            traverse_bvh(g, tables, from, leaving, 0.0f, traversal_nearest, no_aim(), &next);
            if (next.element == best.element && next.instance == best.instance) result.again = next.t_max;
        })",
         .inputs = {"vec3 o", "vec3 d", "vec3 w", "float side"},
         .declarations = "typedef struct { float t; uint element, instance; float u, v; vec3 p, error, ng, ns, dpdu, dpdv, dndu, dndv, "
                         "tangent; vec2 uv; float again; } probe;",
         .tables = "GEOMETRY_TABLES(TABLE) TEXTURE_TABLES(TABLE)",
         .features = shapeFeatures()});
    const DeviceScene onDevice(testContext(), scene);
    return function.with(onDevice, o, d, w, side);
}

glm::dvec3 toGlm(vec3 v) { return {v.x, v.y, v.z}; }

class Shapes : public testing::TestWithParam<std::string> {
protected:
    struct Rays { std::vector<vec3> o, d, w; std::vector<float> side; };

    /// Rays at the shapes from all around, and from within their box.
    static Rays rays(size_t count, std::uint64_t seed) {
        Random random(seed);
        Rays r;
        for (size_t i = 0; i < count; ++i) {
            const vec3 target = random.box(0.6f), from = random.direction();
            const float distance = i % 2 ? 2.0f : 0.3f;
            r.o.push_back({target.x + distance * from.x, target.y + distance * from.y, target.z + distance * from.z});
            r.d.push_back({-from.x, -from.y, -from.z});
            r.w.push_back(random.direction());
            r.side.push_back(random.below(2) ? 1.0f : -1.0f);
        }
        return r;
    }
};

TEST_P(Shapes, PointsLieOnTheRayWithinTheirError) {
    for (const std::string& text : scenesOf(GetParam())) {
        const PackedScene scene = packText(text);
        const Rays r = rays(4000, 80);
        const auto probes = probe(scene, r.o, r.d, r.w, r.side);
        size_t met = 0;
        for (size_t i = 0; i < probes.size(); ++i) {
            const Probe& at = probes[i];
            if (at.t < 0) continue;
            ++met;
            /* Off the ray only along the surface's normal, within what the offset of a new ray makes up for, or by the rounding of t */
            const glm::dvec3 away = toGlm(at.p) - (toGlm(r.o[i]) + static_cast<double>(at.t) * toGlm(r.d[i]));
            const double cosine = std::abs(dot(at.ng, r.d[i]));
            ASSERT_LT(glm::length(away), 3e-5 / std::max(cosine, 1e-2)) << "ray " << i;
            ASSERT_NEAR(dot(at.ng, at.ng), 1, 1e-5);
            ASSERT_NEAR(dot(at.ns, at.ns), 1, 1e-5);
            ASSERT_GT(dot(at.ng, at.ns), 0);
        }
        EXPECT_GT(met, probes.size() / 40) << text;
    }
}

/// On either side, the next hit on the same element is beyond rounding.
TEST_P(Shapes, RaysDoNotMeetTheSurfaceTheyLeave) {
    for (const std::string& text : scenesOf(GetParam())) {
        const PackedScene scene = packText(text);
        const Rays r = rays(8000, 81);
        const auto probes = probe(scene, r.o, r.d, r.w, r.side);
        for (size_t i = 0; i < probes.size(); ++i) {
            if (probes[i].t < 0) continue;
            ASSERT_FALSE(probes[i].again >= 0 && probes[i].again < 2e-5f) << "ray " << i << " meets it after " << probes[i].again << "\n"
                                                                          << text;
        }
    }
}

/// The frame is that of the surface: where a ray nearby meets it, p and ns have changed by what the derivatives say.
TEST_P(Shapes, DerivativesFollowTheSurface) {
    /* A curve's strip turns with the ray; its derivatives are made to fit hair, not the strip */
    if (GetParam() == "curve") GTEST_SKIP() << "has no surface of its own";
    for (const std::string& text : scenesOf(GetParam())) {
        const PackedScene scene = packText(text);
        const Rays r = rays(4000, 82);
        std::vector<vec3> nearby = r.d;
        Random random(83);
        constexpr float step = 2e-3f;
        for (vec3& d : nearby) {
            const vec3 by = random.box(step);
            const glm::dvec3 n = glm::normalize(toGlm(d) + toGlm(by));
            d = {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)};
        }
        const auto here = probe(scene, r.o, r.d, r.w, r.side), there = probe(scene, r.o, nearby, r.w, r.side);
        size_t compared = 0;
        for (size_t i = 0; i < here.size(); ++i) {
            const Probe &a = here[i], &b = there[i];
            if (a.t < 0 || b.t < 0 || a.element != b.element || a.instance != b.instance) continue;
            const glm::dvec3 change = toGlm(b.p) - toGlm(a.p);
            const double du = static_cast<double>(b.uv.x) - static_cast<double>(a.uv.x),
                         dv = static_cast<double>(b.uv.y) - static_cast<double>(a.uv.y), moved = glm::length(change);
            /* An implicit surface's texture coordinates jump, or turn, from one face of its box to another */
            const double u_length = glm::length(toGlm(a.dpdu)), v_length = glm::length(toGlm(a.dpdv));
            const bool turns =
                glm::length(toGlm(b.dpdu) - toGlm(a.dpdu)) > 0.5 * u_length || glm::length(toGlm(b.dpdv) - toGlm(a.dpdv)) > 0.5 * v_length;
            if (GetParam() == "implicit" && (turns || std::abs(du) * u_length + std::abs(dv) * v_length > 4 * moved)) continue;
            /* The far side of the same shape, the seam, or a grazing ray that gets far */
            if (moved > 0.02 || std::abs(du) > 0.5 || std::abs(dot(a.ng, r.d[i])) < 0.2 || moved < 2e-4) continue;
            ++compared;
            const glm::dvec3 p = du * toGlm(a.dpdu) + dv * toGlm(a.dpdv), n = du * toGlm(a.dndu) + dv * toGlm(a.dndv),
                             turned = toGlm(b.ns) - toGlm(a.ns);
            ASSERT_LT(glm::length(p - change), 0.2 * moved + 1e-4) << "ray " << i << "\n" << text;
            ASSERT_LT(std::abs(dot(a.ng, a.dpdu)), 1e-4 * glm::length(toGlm(a.dpdu)) + 1e-6);
            ASSERT_LT(std::abs(dot(a.ng, a.dpdv)), 1e-4 * glm::length(toGlm(a.dpdv)) + 1e-6);
            ASSERT_LT(glm::length(n - turned - glm::dot(n - turned, toGlm(a.ns)) * toGlm(a.ns)), 0.25 * glm::length(turned) + 2e-3)
                << "ray " << i << "\n"
                << text;
        }
        EXPECT_GT(compared, 50u) << text;
    }
}

/// A mesh's tangents are interpolated, go with it through its transforms, and turn what depends on the direction along the surface, which
/// stays as it is otherwise.
TEST(Tangents, TurnTheFrame) {
    const std::string corners = "Shape \"trianglemesh\" \"point3 P\" [ -1 -1 0  1 -1 0  0 1 0 ] ",
                      mesh = corners + "\"vector3 S\" [ 1 0 0  1 2 3  -1 1 0 ] ";
    const std::string turned = "Rotate 90 0 0 1 Scale 2 1 1 ", normals = "\"normal N\" [ 0 .6 .8  0 .6 .8  0 .6 .8 ] ";
    const std::vector<vec3> o{{0, -0.2f, 3}}, d{{0, 0, -1}}, w{{0, 0, 1}};
    const auto meet = [&](const std::string& text) { return probe(packText("WorldBegin " + text), o, d, w, {1}).front(); };
    const auto expectTangent = [&](const Probe& at, glm::dmat3 m) {
        const double u = static_cast<double>(at.u), v = static_cast<double>(at.v);
        const glm::dvec3 t = m * ((1 - u - v) * glm::dvec3(1, 0, 0) + u * glm::dvec3(1, 2, 3) + v * glm::dvec3(-1, 1, 0)),
                         ns = toGlm(at.ns);
        ASSERT_GE(at.t, 0);
        EXPECT_LT(glm::length(toGlm(at.tangent) - glm::normalize(t - glm::dot(t, ns) * ns)), 1e-5);
    };
    const glm::dmat3 turn(glm::dvec3(0, 2, 0), glm::dvec3(-1, 0, 0), glm::dvec3(0, 0, 1));   // columns
    for (const std::string& more : {std::string(), normals, "ReverseOrientation " + normals}) {
        const auto with = [&](const std::string& before, const std::string& shape) {
            return more.starts_with("R") ? before + "ReverseOrientation " + shape + normals : before + shape + more;
        };
        expectTangent(meet(with("", mesh)), glm::dmat3(1));
        expectTangent(meet(with(turned, mesh)), turn);
        /* An object that is used once is part of the world, one that is used twice is not */
        const std::string once = with("ObjectBegin \"o\" ", mesh) + "ObjectEnd " + turned + "ObjectInstance \"o\" ";
        expectTangent(meet(once), turn);
        expectTangent(meet(once + "Translate 0 0 -1 ObjectInstance \"o\""), turn);
        const Probe plain = meet(with("", corners)), zero = meet(with("", corners + "\"vector3 S\" [ 0 0 0  0 0 0  0 0 0 ] ")),
                    still = meet(with("", mesh));
        EXPECT_EQ(toGlm(zero.tangent), toGlm(plain.tangent)) << "no tangent: that of the texture coordinates";
        EXPECT_EQ(toGlm(still.dpdu), toGlm(plain.dpdu)) << "textures stay where they are";
        EXPECT_EQ(toGlm(still.dpdv), toGlm(plain.dpdv));
        const Probe huge = meet(with("", corners + "\"vector3 S\" [ 1e30 1e30 0  1e30 1e30 0  1e30 1e30 0 ] ")),
                    small = meet(with("", corners + "\"vector3 S\" [ 1e-30 1e-30 0  1e-30 1e-30 0  1e-30 1e-30 0 ] "));
        EXPECT_LT(glm::length(toGlm(huge.tangent) - toGlm(small.tangent)), 1e-6);
    }
}

/// Rays beside a flat patch and parallel to it miss it; and distances count in lengths of d, also where they are small.
TEST(BilinearPatch, ParallelRaysMissAndDirectionsHaveAnyLength) {
    const DeviceFunction<float> function({.include = "shape/shapes.clh",
                                          .type = "float",
                                          .body = "patch q = {make_vec3(0.0f, 0.0f, 0.0f), make_vec3(1.0f, 0.0f, 0.0f), make_vec3(0.0f, "
                                                  "1.0f, 0.0f), make_vec3(1.0f, 1.0f, 0.0f)}; result = intersect_patch(q, o, d, 1e30f).t;",
                                          .inputs = {"vec3 o", "vec3 d"},
                                          .features = shapeFeatures()});
    const std::vector<vec3> o{{-1, .5f, 5}, {.5f, -1, 1e-3f}, {.3f, .5f, .01f}, {.3f, .5f, .01f}, {.3f, .5f, .01f}},
        d{{1, 0, 0}, {0, 1, 0}, {0, 0, -1e4f}, {0, 0, -1e-4f}, {0, 0, 1}};
    const float expected[] = {-1, -1, 1e-6f, 100, -1};
    const std::vector<float> t = function(o, d);
    for (size_t i = 0; i < t.size(); ++i) EXPECT_NEAR(t[i], expected[i], 1e-6f * std::abs(expected[i])) << i;
}

INSTANTIATE_TEST_SUITE_P(Kinds, Shapes, testing::ValuesIn(kindNames), [](const auto& info) { return info.param; });

}  // namespace
}  // namespace eikonal
