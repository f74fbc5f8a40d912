/* path -> film.  Adds a batch's samples to their pixels, in sample order. Each work-item has several pixels of the batch's blocks.
   A tracing stage, since samples are a loop; the loop over pixels inside of it is vectorised. */
#include "shade/color.clh"
#include "shade/ray_tree.clh"
#include "stages/queue.clh"
#include "stages/stage.clh"
#include "film/bands.clh"
#include "film/buckets.clh"
#include "film/compensated.clh"
#include "film/exposure.clh"
#include "film/groups.clh"
#include "film/mattes.clh"
#include "film/pixel.clh"
#include "eikonal/film.h"
DEFINE_ITEM(film, FILM_FIELDS, 0)
#include "film/passes.clh"
#include "film/quarters.clh"

/* One step of the majority vote: if one id has a majority, it is the final candidate (Boyer and Moore 1991). */
typedef struct { uint id, lead; } candidate;
FN candidate vote(uint id, uint lead, uint for_id) {
    candidate c = {id, lead};
    if (lead == 0u) c.id = for_id;
    c.lead = lead == 0u || id == for_id ? lead + 1u : lead - 1u;
    return c;
}

/* Distances from the mean are clamped to this; its square is finite. */
#define MOST_DISTANCE 1e18f

/* Add a luminance with a squared weight. The weighted sum of squared deviations, `spread`, grows by the product of its distances from the
   old and the new mean (West 1979). Unlike a sum of squares, this keeps precision when samples hardly differ. */
FN film_item add_luminance(film_item f, float y, float square_weight) {
    float before = y - f.mean;
    f.square_weight += square_weight;
    if (f.square_weight > 0.0f) f.mean += before * (square_weight / f.square_weight);
    float after = y - f.mean;
    float grown = f.spread + square_weight * (clamp1(before, -MOST_DISTANCE, MOST_DISTANCE) * clamp1(after, -MOST_DISTANCE, MOST_DISTANCE));
    f.spread = min1(grown, MOST_SPREAD);
    return f;
}

FN film_item add_sample(film_item f, path_item p, rgb L, sampled_wavelengths colors, __global const settings *frame) {
    add_compensated(&f.sum, &f.compensation, mul(L, p.weight));
    add_compensated(&f.weight, &f.weight_excess, p.weight);
    f = add_luminance(f, luminance(L), square(p.weight));
    f = add_to_quarters(f, p.weight * luminance(L), p.weight);
    f.count += 1;
    f = note_squares(f);
    if (HAS_AOVS)
        add_compensated(&f.albedo, &f.albedo_compensation, mul(color_seen(colors, frame->albedo_curves, p.albedo), p.weight));
    f.normal = mul_add(p.normal, p.weight, f.normal);
    f.ng = mul_add(p.ng, p.weight, f.ng);
    add_compensated(&f.position, &f.position_compensation, p.position);
    add_compensated(&f.uv, &f.uv_compensation, p.uv);
    add_compensated(&f.opening, &f.opening_compensation, p.opening);
    add_compensated(&f.closing, &f.closing_compensation, p.closing);
    add_compensated(&f.distance, &f.distance_compensation, p.distance < FAR_AWAY ? p.distance : 0.0f);
    f.seen += p.distance < FAR_AWAY ? 1.0f : 0.0f;
    candidate object = vote(f.object, f.object_lead, p.object), material = vote(f.material, f.material_lead, p.material);
    f.object = object.id; f.object_lead = object.lead;
    f.material = material.id; f.material_lead = material.lead;
    return f;
}

#define ADD_BRANCH(q, type, name, FEATURE) \
    if (HAS_##FEATURE) p.name = add(p.name, LOAD_FIELD(path, type, name, path, path_capacity, first + branch));
#define BLACKEN(q, type, name, FEATURE) p.name = choose(*is_valid, p.name, uniform_spectrum(0.0f));

/* The state of a camera ray's path, plus the radiance and albedo of all rays that split from it. Invalid radiance becomes black. */
FN path_item gather_path(__global const settings *frame, __global const uint *path, uint path_capacity, uint index, int *is_valid) {
    uint first = state_of_path(frame, index);
    path_item p = load_path(path, path_capacity, first);
    for (uint branch = 1; branch < states_per_path(frame); ++branch) {
        p.L = add(p.L, LOAD_FIELD(path, spectrum, L, path, path_capacity, first + branch));
        RENDER_PASS_FIELDS(ADD_BRANCH, path)
        if (HAS_AOVS) p.albedo = add(p.albedo, LOAD_FIELD(path, spectrum, albedo, path, path_capacity, first + branch));
    }
    *is_valid = is_finite(p.L) & (max_component(p.L) <= MOST_RADIANCE);
    p.L = choose(*is_valid, p.L, uniform_spectrum(0.0f));
    RENDER_PASS_FIELDS(BLACKEN, path)
    return p;
}
/* Whether the pixel gets a sample by it. */
FN int is_sample(path_item p, int is_valid) { return !((p.weight == 0.0f) & is_black(p.L) & is_valid); }
FN spectrum light_of_path(path_item p) { return HAS_IMPORTANCE ? mul(p.L, p.importance) : p.L; }

#define KEEP(q, type, name, FEATURE) if (HAS_##FEATURE) f.name = choose(is_added, f.name, before.name);

/* Adds camera path `index` to the fields of a pixel. Straight-line. */
FN void resolve_path(__global const settings *frame, color_tables color_set, __global const uint *path, uint path_capacity, uint index,
                     __global uint *film, uint pixels, size_t pixel) {
    int is_valid;
    path_item p = gather_path(frame, path, path_capacity, index, &is_valid);
    sampled_wavelengths colors = path_wavelengths(color_set, p.wavelength);
    rgb color = color_of_light(light_of_path(p), colors, frame);
    float scale = exposure_scale(color, frame);

    film_item before = load_film(film, pixels, pixel), f = before;
    f.invalid += is_valid ? 0u : 1u;
    f = add_sample(f, p, mul(color, scale), colors, frame);
    if (HAS_RENDER_PASSES) f = add_passes(f, p, HAS_IMPORTANCE ? p.importance * scale : scale, colors, frame);
    int is_added = is_sample(p, is_valid);
    FILM_FIELDS(KEEP, film)
    store_film(film, pixels, pixel, f);
}

/* What features keep behind the fields of a pixel. */
#define HAS_MORE_THAN_FIELDS (HAS_SPECTRAL_FILM || HAS_GROUPS || HAS_FIREFLIES || HAS_CRYPTO_OBJECT || HAS_CRYPTO_MATERIAL)
FN void resolve_features(__global const settings *frame, color_tables color_set, matte_tables mattes, __global const uint *path,
                         uint path_capacity, uint index, __global uint *film, uint pixels, size_t pixel) {
    int is_valid;
    path_item p = gather_path(frame, path, path_capacity, index, &is_valid);
    if (!is_sample(p, is_valid)) return;
    sampled_wavelengths colors = path_wavelengths(color_set, p.wavelength);
    spectrum light = light_of_path(p);
    rgb color = color_of_light(light, colors, frame);
    float scale = exposure_scale(color, frame), exposed = HAS_IMPORTANCE ? p.importance * scale : scale;

    if (HAS_SPECTRAL_FILM) add_to_buckets(film, film_words, pixels, pixel, frame, colors, mul(mul(light, scale), p.weight));
    size_t groups = film_words + BUCKET_WORDS * frame->bucket_count, bands = groups + GROUP_WORDS * LIGHT_GROUP_COUNT;
    add_groups(film, groups, pixels, pixel, path, path_capacity, state_of_path(frame, index), states_per_path(frame),
               is_valid ? exposed : 0.0f, p.weight, colors, frame);
    color = mul(color, scale);
    if (HAS_FIREFLIES) add_to_bands(film, bands, pixels, pixel, luminance(color), mul(color, p.weight));
    size_t objects = bands + (HAS_FIREFLIES ? GROUP_WORDS * BRIGHTNESS_BANDS : 0);
    if (HAS_CRYPTO_OBJECT) add_to_mattes(film, objects, pixels, pixel, mattes.object_matte_ids[p.object], p.weight);
    size_t materials = objects + (HAS_CRYPTO_OBJECT ? MATTE_WORDS * MATTE_SLOTS : 0);
    if (HAS_CRYPTO_MATERIAL) add_to_mattes(film, materials, pixels, pixel, mattes.material_matte_ids[p.material], p.weight);
}

#define RESOLVE_FILM(TABLE, ARGUMENT) \
    COLOR_TABLES(TABLE) MATTE_TABLES(TABLE) INTERRUPT_TABLES(TABLE) \
    ARGUMENT(__global const settings *, frame) ARGUMENT(__global const uint *, path) ARGUMENT(uint, first_path) \
    ARGUMENT(__global uint *, film) ARGUMENT(__global const layer_range *, block_layers) ARGUMENT(uint, block_log2_width) \
    ARGUMENT(uint, block_log2_height)
TRACING_STAGE(resolve_film, RESOLVE_FILM) {
    /* Paths may have been cut short. If not, no stage before this one has been */
    if (is_interrupted(stop)) return;
    color_tables color_set = BIND_COLORS;
    matte_tables mattes = BIND_MATTES;
    uint log2_pixels = block_log2_width + block_log2_height, within = (1u << log2_pixels) - 1u;
    size_t last = SLOTS_END, end;

    /* Pixels of one block have neighbouring paths in each layer */
    for (size_t start = first_slot; start < last; start = end) {
        end = min(last, (start | within) + 1u);
        layer_range range = block_layers[start >> log2_pixels];
        for (uint layer = range.first; layer < range.first + range.layers; ++layer) {
            uint first = first_path + (layer << log2_pixels) + ((uint)start & within);
            EACH_SLOT_FROM(start, end - start, pixel)
                resolve_path(frame, color_set, path, path_capacity, first + (uint)(pixel - start), film, count, pixel);
            for (size_t pixel = start; HAS_MORE_THAN_FIELDS && pixel < end; ++pixel)
                resolve_features(frame, color_set, mattes, path, path_capacity, first + (uint)(pixel - start), film, count, pixel);
        }
    }
}
