/* shadow -> splat.  Adds what light paths send to the camera to the pixels that see it, unless something is in between. A tracing stage.
   splat: SPLAT_WORDS of each pixel of a rectangle of the image. */
#include "camera/camera.clh"
#include "film/exposure.clh"
#include "film/splat.clh"
#include "math/dimension.clh"
#include "trace/interleaved.clh"
#include "trace/test_shadow.clh"
#include "stages/stage.clh"

/* Adds light to a pixel, as the sensor sees it, in units of SPLAT_UNIT over splat_scale. */
FN void add_splat(__global uint *splat, size_t pixels, size_t pixel, __global const settings *frame, sampled_wavelengths colors, spectrum L,
                  uint render_pass, random_stream *numbers) {
    rgb color = color_of_light(L, colors, frame);
    color = mul(color, exposure_scale(color, frame) * frame->splat_scale);
    float largest = max1(fabs(color.r), max1(fabs(color.g), fabs(color.b)));
    if (!(largest < MOST_SPLAT) || !is_finite(largest)) { add_to_splat(splat, pixels, splat_lost, pixel, 1); return; }
    long red = splat_units(color.r * SPLAT_UNITS, next_random(numbers)), green = splat_units(color.g * SPLAT_UNITS, next_random(numbers)),
         blue = splat_units(color.b * SPLAT_UNITS, next_random(numbers));
    add_to_splat(splat, pixels, splat_red, pixel, red);
    add_to_splat(splat, pixels, splat_green, pixel, green);
    add_to_splat(splat, pixels, splat_blue, pixel, blue);
    if (HAS_RENDER_PASSES && render_pass != pass_indirect) {
        uint first = render_pass == pass_direct ? splat_direct_red : splat_volume_red;
        add_to_splat(splat, pixels, first, pixel, red);
        add_to_splat(splat, pixels, first + 1u, pixel, green);
        add_to_splat(splat, pixels, first + 2u, pixel, blue);
    }
    float square_luminance = min1(square(luminance(color)), MOST_SPLAT_SQUARE);
    add_to_splat(splat, pixels, splat_square, pixel, splat_units(square_luminance * SPLAT_SQUARE_UNITS, next_random(numbers)));
}

/* The part of the film that splats go to. */
typedef struct { uint x, y, width, height; } splat_image;

/* Where a ray's light goes: a pixel of the image, and its weight; 0 outside. numbers: what is left of its random numbers. */
typedef struct { size_t pixel; float weight; random_stream numbers; } splat_place;
FN splat_place place_splat(camera_tables camera_set, __global const settings *frame, splat_image image, shadow_item s) {
    splat_place place = {0, 0.0f, make_stream(s.seed, s.sample, bounce_dimension_of(s.depth, dimension_splat))};
    filter f = frame->pixel_filter;
    /* Far outside the image, positions may not fit an integer */
    if (!(fabs(s.raster.x) < 1e6f && fabs(s.raster.y) < 1e6f)) return place;
    splat_pixel x = pixel_of_splat(camera_set, 0u, f.cells, f.radius_x, s.raster.x, next_random(&place.numbers));
    splat_pixel y = pixel_of_splat(camera_set, 1u, f.cells, f.radius_y, s.raster.y, next_random(&place.numbers));
    pixel_place at = {x.at, y.at};
    if (frame->view.is_around) at = wrap_pixel(frame, x.at, y.at);
    int column = at.x - (int)image.x, row = at.y - (int)image.y;
    if (column < 0 || row < 0 || column >= (int)image.width || row >= (int)image.height) return place;
    place.weight = x.weight * y.weight;
    place.pixel = (size_t)row * image.width + (size_t)column;
    return place;
}

FN int begin_ray(traversal *w, geometry g, texture_tables tables, color_tables color_set, camera_tables camera_set,
                 __global const settings *frame, splat_image image, __global const uint *shadow, uint capacity, __global const uint *stop,
                 uint i, uint *tested) {
    if (is_interrupted(stop) || LOAD_FIELD(shadow, float, t_max, shadow, capacity, i) < 0.0f) return 0;
    shadow_item s = load_shadow(shadow, capacity, i);
    if (place_splat(camera_set, frame, image, s).weight == 0.0f) return 0;
    ++*tested;
    return begin_shadow(w, g, tables, color_set, s);
}
FN void end_ray(const traversal *w, geometry g, texture_tables tables, medium_tables medium_set, color_tables color_set,
                camera_tables camera_set, __global const settings *frame, splat_image image, __global const uint *shadow, uint capacity,
                __global uint *splat) {
    if (w->found) return;
    shadow_item s = load_shadow(shadow, capacity, w->slot);
    spectrum L = unblocked_light(g, tables, medium_set, color_set, s);
    if (is_black(L)) return;
    splat_place place = place_splat(camera_set, frame, image, s);
    if (HAS_FILTER) L = mul(L, place.weight / frame->pixel_filter.mean);
    add_splat(splat, (size_t)image.width * image.height, place.pixel, frame, path_wavelengths(color_set, s.seed, s.sample), L,
              s.render_pass, &place.numbers);
}

#define BEGIN_RAY(w, i) begin_ray(w, g, tables, color_set, camera_set, frame, image, shadow, capacity, stop, i, &tested)
#define END_RAY(w) end_ray(w, g, tables, medium_set, color_set, camera_set, frame, image, shadow, capacity, splat)

#define SPLAT_SHADOWS(TABLE, ARGUMENT) \
    GEOMETRY_TABLES(TABLE) TEXTURE_TABLES(TABLE) MEDIUM_TABLES(TABLE) COLOR_TABLES(TABLE) CAMERA_TABLES(TABLE) \
    ARGUMENT(__global const settings *, frame) ARGUMENT(__global const uint *, shadow) ARGUMENT(__global uint *, splat) \
    ARGUMENT(uint, splat_x) ARGUMENT(uint, splat_y) ARGUMENT(uint, splat_width) ARGUMENT(uint, splat_height) \
    ARGUMENT(__global uint *, shadow_count)
TRACING_STAGE(splat_shadows, SPLAT_SHADOWS) {
    geometry g = BIND_GEOMETRY;
    texture_tables tables = BIND_TEXTURES;
    medium_tables medium_set = BIND_MEDIA;
    color_tables color_set = BIND_COLORS;
    camera_tables camera_set = BIND_CAMERA;
    splat_image image = {splat_x, splat_y, splat_width, splat_height};
    uint tested = 0;
    TRAVERSE_INTERLEAVED(g, tables, traversal_blocker, SLOTS_END, BEGIN_RAY, END_RAY);
    if (tested) atomic_add(shadow_count, tested);
}
