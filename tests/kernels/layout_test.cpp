// Queues and structs lie alike on both sides: a kernel that expands the same lists reports slots, sizes and offsets as the
// device's compiler sees them, for minimal and full sets of features and each general feature alone.

#include "test_device.h"

#include "device/layout.h"
#include "pack/tables.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace eikonal {
namespace {

/// Members of the structs of the scene's tables, most of them; those of a light are listed in lights.h.
#define STRUCT_MEMBERS(M) \
    M(material, next_queue) M(material, first_input) M(material, input_count) M(material, displacement) M(material, normal_map) \
    M(material, mix_a) M(material, mix_b) \
    M(material, mix_amount) M(material, disperses) \
    M(material, is_delta) M(material, regular) M(material_input, texture) M(material_input, slot) \
    M(material_input, kind) M(material_input, count) M(material_input, value) M(color, c0) M(color, c1) M(color, c2) M(color, scale) \
    M(color, curve) \
    M(settings, view) M(settings, pixel_filter) M(settings, width) M(settings, height) M(settings, seed) \
    M(settings, sequence_sample_bits) M(settings, sequence_tile_bits) M(settings, max_depth) M(settings, light_count) \
    M(settings, first_infinite) M(settings, infinite_count) M(settings, lights_in_tree) M(settings, world_scale) \
    M(settings, sensor_curves) M(settings, albedo_curves) M(settings, bucket_count) M(settings, image_from_light) \
    M(settings, max_component_value) \
    M(wavelength_range, first) M(wavelength_range, extent) M(wavelength_range, share) M(wavelength_range, inverse_pdf) \
    M(wavelength_range, inverse_pdf_beside) \
    M(camera, kind) M(camera, scene_from_camera) M(camera, screen_x) M(camera, screen_y) M(camera, step_x) M(camera, step_y) \
    M(camera, lens_radius) \
    M(camera, focal_distance) M(camera, moving) M(camera, times) M(camera, equal_area) M(camera, element_count) M(camera, rear_z) \
    M(camera, film_radius) \
    M(camera, aperture_width) M(camera, aperture_height) M(camera, medium) M(filter, radius_x) M(filter, radius_y) \
    M(alias_entry, keep) M(alias_entry, other) M(alias_entry, pmf) \
    M(light_node, x) M(light_node, y) M(light_node, z) M(light_node, radius) M(light_node, axis_x) M(light_node, axis_y) \
    M(light_node, axis_z) \
    M(light_node, cos_normals) M(light_node, cos_emission) M(light_node, intensity) M(light_node, two_sided) M(light_node, child) \
    M(light_node, parent) \
    M(shape, kind) M(shape, flags) M(shape, first_element) M(shape, first_index) M(shape, first_vertex) M(shape, first_normal) \
    M(shape, first_tangent) M(shape, first_uv) \
    M(shape, object_space) M(shape, splits) M(shape, material) M(shape, alpha) M(shape, first_light) M(shape, emission) M(shape, id) \
    M(shape, inside) M(shape, outside) \
    M(object_space, object_from_scene) M(object_space, scene_from_object) M(object_space, radius) M(object_space, inner_radius) \
    M(object_space, z_min) M(object_space, z_max) M(object_space, phi_max) M(object_space, center) M(object_space, power) \
    M(curve, p) M(curve, width) M(curve, type) M(curve, normal_angle) M(curve, n) \
    M(instance, object_from_scene) M(instance, scene_from_object) M(instance, root) M(instance, first_motion) M(instance, motion_count) \
    M(instance, id) \
    M(motion, start) M(motion, end) M(motion, start_rotation) M(motion, end_rotation) M(motion, angle) M(motion, centre) \
    M(lens_element, z) M(lens_element, radius) M(lens_element, aperture) M(lens_element, eta) \
    M(pupil_bounds, low_x) M(pupil_bounds, low_y) M(pupil_bounds, high_x) M(pupil_bounds, high_y) \
    M(bvh_node, bounds) M(bvh_node, child) M(bvh_node, order) M(triangle_line, words) \
    M(texture_instruction, kind) M(texture_instruction, mapping) M(texture_instruction, flags) M(texture_instruction, image) \
    M(texture_instruction, value) \
    M(texture_instruction, texture_from_scene) M(texture_program, first) M(texture_program, count) \
    M(texture_program, bump_step_uv) M(texture_program, bump_step) \
    M(image, width) M(image, height) M(image, channels) M(image, format) M(image, wrap) M(image, filter) M(image, first) \
    M(medium, kind) M(medium, sigma_a) M(medium, sigma_s) M(medium, Le) M(medium, g) M(medium, equiangular_lights) \
    M(medium, box_from_scene) \
    M(medium, majorants_x) M(medium, majorants_y) M(medium, majorants_z) M(medium, first_majorant) M(medium, density) \
    M(medium, temperature) M(medium, Le_scale) \
    M(medium, temperature_offset) M(medium, temperature_scale) M(medium, nx) M(medium, ny) M(medium, nz) M(medium, first_sigma_a) \
    M(medium, first_sigma_s) \
    M(medium, first_Le) M(medium, low) M(medium, extent) M(medium, noise_density) M(medium, wispiness) M(medium, frequency)

/// What both sides report, in the same order.
struct Report {
    std::vector<std::string> names;
    std::vector<uint> values;
    void add(const std::string& name, size_t value) { names.push_back(name); values.push_back(static_cast<uint>(value)); }
};

Report hostReport(const Features& features) {
    Report r;
    const auto addLayout = [&](const QueueLayout& l) {
        for (const FieldLayout& f : l.fields) {
            r.add(l.name + "." + f.name + " slot", static_cast<size_t>(f.slot));
            r.add(l.name + "." + f.name + " words", static_cast<size_t>(f.words));
        }
        r.add(l.name + " words", static_cast<size_t>(l.words));
    };
    for (const QueueLayout& l : queueLayouts(features)) addLayout(l);
    /* Of the film the kernels' list has those fields whose number of words no option changes */
    QueueLayout film = filmLayout(features);
    std::erase_if(film.fields, [](const FieldLayout& f) { return f.type == "matte" || f.type == "band"; });
    film.words = film.fields.back().slot + film.fields.back().words;
    addLayout(film);
#define ADD_SIZE(type, name) r.add("sizeof " #type, sizeof(type));
    SCENE_TABLES(ADD_SIZE)
#define ADD_OFFSET(type, member) r.add("offset of " #type "." #member, offsetof(type, member));
    STRUCT_MEMBERS(ADD_OFFSET)
#define ADD_LIGHT_OFFSET(type, member) ADD_OFFSET(light, member)
    LIGHT_FIELDS(ADD_LIGHT_OFFSET)
    return r;
}

std::string probeText() {
    std::string text = R"(
#include "stages/queue.clh"
#include "stages/stage.clh"
#include "eikonal/film.h"
DEFINE_ITEM(film, FILM_FIELDS, 0)
#define PUT(x) words[n++] = (uint)(x);
#define PUT_FIELD(q, type, name, FEATURE) PUT(q##_##name##_slot) PUT(WORDS_##type * HAS_##FEATURE)
#define PUT_ITEM(q, FIELDS) FIELDS(PUT_FIELD, q) PUT(q##_words)
#define PUT_QUEUE(q, FIELDS, ITEMS, FEATURE) PUT_ITEM(q, FIELDS)
#define PUT_SIZE(type, name) PUT(sizeof(type))
#define LAYOUT_PROBE(TABLE, ARGUMENT) ARGUMENT(__global uint *, words)
TRACING_STAGE(layout_probe, LAYOUT_PROBE) {
    uint n = 0;
    if (first_slot > 0) return;
    QUEUES(PUT_QUEUE)
    PUT_ITEM(film, FILM_FIELDS)
    SCENE_TABLES(PUT_SIZE)
)";
#define TEXT_OFFSET(type, member) text += "    PUT(__builtin_offsetof(" #type ", " #member "))\n";
    STRUCT_MEMBERS(TEXT_OFFSET)
#define TEXT_LIGHT_OFFSET(type, member) TEXT_OFFSET(light, member)
    LIGHT_FIELDS(TEXT_LIGHT_OFFSET)
    return text + "}\n";
}

void expectEqualLayout(const Features& features, const std::string& what) {
    const Report host = hostReport(features);
    const Kernel kernel(testCompiler().build(probeText(), "layout_probe", shippedSettings(features)));
    Buffer words(testContext(), host.values.size() * sizeof(uint), "layout");
    Bindings arguments;
    arguments.set("words", words);
    arguments.set("count", 1u);
    for (const char* name : {"capacity", "path_capacity"}) arguments.set(name, 0u);
    kernel.launch(testContext(), {&arguments}, 1, testLocalSize);
    testContext().finish();
    testCompiler().keep(kernel.program());
    std::vector<uint> device(host.values.size());
    words.read(testContext(), device.data(), device.size() * sizeof(uint));
    for (size_t i = 0; i < device.size(); ++i) EXPECT_EQ(device[i], host.values[i]) << host.names[i] << ", features: " << what;
}

TEST(Layout, IsEqualOnBothSides) {
    expectEqualLayout(Features(), "none");
    expectEqualLayout(Features::all(), "all");
    expectEqualLayout(Features().require(Feature::SPECTRAL), "spectral");
    expectEqualLayout(Features::allSpectral(), "all, spectral");
}

/// Features that fields of queues name, each alone.
TEST(Layout, IsEqualForEachFeatureOfAField) {
    for (Feature f : {Feature::MEDIA, Feature::INTERFACE, Feature::TRANSMISSION, Feature::INSTANCES, Feature::ANISOTROPY, Feature::AOVS,
                      Feature::LIGHT_TREE, Feature::PORTALS, Feature::RENDER_PASSES, Feature::LIGHT_GROUPS})
        expectEqualLayout(Features().require(f), featureName(f));
}

/// Only words: no padding anywhere, so a struct's size is the sum of its members' words.
TEST(Layout, TheLastMemberEndsEachStruct) {
    EXPECT_EQ(sizeof(material), offsetof(material, is_delta) + 4);
#define ADD_WORDS(type, member) + WORDS_##type
    EXPECT_EQ(sizeof(light), 4 * (0 LIGHT_FIELDS(ADD_WORDS)));
    EXPECT_EQ(sizeof(shape), offsetof(shape, outside) + 4);
    EXPECT_EQ(sizeof(settings), offsetof(settings, max_component_value) + 4);
    EXPECT_EQ(sizeof(medium), offsetof(medium, frequency) + 4);
}

}  // namespace
}  // namespace eikonal
