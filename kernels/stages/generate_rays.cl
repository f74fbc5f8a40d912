/* pixels -> ray, path.  Generates a camera ray for each sample of some blocks of the image, in the slots from `first` on. Starts with path
   number `begun` of the batch (film/pixel.clh maps it to a pixel and sample); the batch's path states start at `first_path`. Straight-line;
   paths outside the image get dead rays. */
#include "stages/queue.clh"
#include "stages/stage.clh"
#include "camera/camera.clh"
#include "film/pixel.clh"

typedef struct { ray_item ray; path_item path; } camera_path;

/* The ray and the state of a path. inside: whether its pixel lies in the image. */
FN camera_path start_path(camera_tables tables, __global const settings *frame, uint x, uint y, uint sample_index, uint path, int inside) {
    camera_sample sample = generate_ray(tables, frame, x, y, sample_index, state_of_path(frame, path));
    camera_path p;
    p.ray = sample.ray;
    p.ray.t_max = inside ? p.ray.t_max : -1.0f;
    p.path = new_path();
    p.path.seed = p.ray.seed;
    p.path.sample = p.ray.sample;
    p.path.L = uniform_spectrum(0.0f);
    p.path.weight = inside ? sample.weight : 0.0f;
    p.path.importance = sample.importance;
    p.path.albedo = uniform_spectrum(0.0f);
    p.path.normal = p.path.ng = p.path.position = p.path.opening = p.path.closing = make_vec3(0.0f, 0.0f, 0.0f);
    p.path.uv = make_vec2(0.0f, 0.0f);
    p.path.object = p.path.material = 0u;
    p.path.distance = FAR_AWAY;
    return p;
}

#ifndef AS_LIBRARY
#define GENERATE_RAYS(TABLE, ARGUMENT) \
    CAMERA_TABLES(TABLE) \
    ARGUMENT(__global const settings *, frame) ARGUMENT(__global uint *, ray) ARGUMENT(__global uint *, path) BATCH_ARGUMENTS(ARGUMENT) \
    ARGUMENT(uint, begun) ARGUMENT(uint, first_path) ARGUMENT(uint, first)
STAGE(generate_rays, GENERATE_RAYS) {
    camera_tables tables = BIND_CAMERA;
    FOR_EACH_SLOT(i, count) {
        uint of_batch = begun + (uint)i;
        pixel_sample at = LOCATE_PATH(of_batch);
        camera_path p = start_path(tables, frame, at.x, at.y, at.sample, first_path + of_batch, at.in_image);
        store_ray(ray, capacity, first + i, p.ray);
        store_path(path, path_capacity, HAS_TREE ? p.ray.path : first_path + begun + i, p.path);
    }
}
#endif
