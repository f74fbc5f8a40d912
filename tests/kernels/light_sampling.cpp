#include "light_sampling.h"

#include "pack/alias_table.h"
#include "pack/colors.h"

namespace eikonal {

static const DeviceFunction<LightResult>& sampler() {
    static const DeviceFunction<LightResult> function(
        {.include = "trace/route_items.clh",
         .type = "light_result",
         .body = R"(
        light_tables tables = BIND_LIGHTS;
        color_tables color_set = BIND_COLORS;
        sampled_wavelengths colors = path_wavelengths(color_set, 0u, 0u);
        light_choice found = choose_this_light(tables, no_choice(), (uint)sample_light_index(tables, count, u).i);
        if (tables.lights[found.light].kind == kind_portal_infinite_light) found = sample_portal(tables, fetch(tables.lights + found.light),
            p, v, found);
        light_sample s = sample_light(tables, colors, found, p, v);
        result.L = s.L; result.wi = s.wi; result.distance = s.distance; result.pdf = s.pdf; result.is_delta = s.is_delta;
        result.index = (uint)sample_light_index(tables, count, u).i;
        light l = fetch(tables.lights + result.index);
        surface at;
        at.p = mul_add(s.wi, s.distance, p);
        at.ng = l.n;
        at.uv = v;
        if (l.kind == kind_ellipsoid_light) at.ng = normalize3(ellipsoid_light_across(l, ellipsoid_light_point(l, v)));
        if (l.kind == kind_cylinder_light) at.ng = normalize3(cylinder_light_across(l, unit_circle(v.x * l.extent)));
        if (l.kind == kind_sphere_light) at.ng = mul(sub(mul_add(s.wi, s.distance, p), l.p), 1.0f / l.radius);
        if (l.kind == kind_bilinear_light) at.ng = normalize3(cross3(mul_add(l.c, v.y, l.a), mul_add(l.c, v.x, l.b)));
        ray_item r = new_ray();
        r.o = r.vertex = p; r.d = s.wi; r.traveled = 0.0f;
        intersection_item f = new_intersection();
        f.t = s.distance; f.u = v.x; f.v = v.y;
        result.pdf_hit = pdf_light(l, make_light_hit(r, f, at, l.kind == kind_implicit_light));
        light_emission emission = eval_infinite_light(tables, colors, l, p, s.wi, 0u);
        result.Le = emission.Le; result.pdf_environment = emission.pdf;)",
         .inputs = {"vec3 p", "float u", "vec2 v", "uint count"},
         .declarations = "typedef struct { spectrum L; vec3 wi; float distance, pdf; int is_delta; uint index; float pdf_hit; spectrum Le; "
                         "float pdf_environment; } light_result;",
         .tables = "LIGHT_TABLES(TABLE) COLOR_TABLES(TABLE)"});
    return function;
}

std::vector<LightResult> sample(const PackedScene& scene, vec3 p, const std::vector<float>& u, const std::vector<vec2>& v) {
    const DeviceScene onDevice(testContext(), scene);
    return sampler().with(onDevice, std::vector<vec3>(u.size(), p), u, v,
                          std::vector<uint>(u.size(), static_cast<uint>(scene.tables.lights.size())));
}

PackedScene sceneOf(const light& l) {
    PackedScene scene;
    scene.tables.lights = {l};
    scene.tables.light_aliases = makeAliasTable(std::vector{1.0});
    scene.tables.frame.resize(1);
    return scene;
}

light newLight(light_kind kind) {
    light l{};
    l.kind = kind;
    l.pmf = 1;
    l.extent = 1;
    l.resolution = l.rows = 1;
    l.element = l.leaf = NONE;
    l.L = packRgb({1, 2, 3});
    return l;
}

}  // namespace eikonal
