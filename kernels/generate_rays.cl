/* pixels -> ray, path.  A camera ray for each sample of some blocks of the image (film/pixel.clh says which slot holds which).
   Straight-line: one slot a work-item; slots outside of the image hold dead rays. */
#include "queue.clh"
#include "scene.clh"
#include "camera/camera.clh"
#include "film/pixel.clh"

typedef struct { ray_item ray; path_item path; } camera_path;

/* The ray and the path of a slot; `inside` says whether it belongs to the image. */
FN camera_path start_path(camera_tables tables, __global const settings *frame, uint x, uint y, uint sample_index, uint slot, int inside) {
    camera_sample sample = generate_ray(tables, frame, x, y, sample_index, path_of_slot(frame, slot));
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
    p.path.object = p.path.material = 0u;
    p.path.distance = FAR_AWAY;
    return p;
}

#ifndef AS_LIBRARY
STAGE generate_rays(CAMERA_ARGUMENTS
                    __global const settings *frame, __global uint *ray, __global uint *path, uint capacity,
                    BATCH_ARGUMENTS uint count) {
    camera_tables tables = BIND_CAMERA;
    FOR_EACH_SLOT(i, count) {
        pixel_sample at = LOCATE_SLOT((uint)i);
        camera_path p = start_path(tables, frame, at.x, at.y, at.sample, (uint)i, at.is);
        store_ray(ray, capacity, i, p.ray);
        store_path(path, capacity, HAS_TREE ? p.ray.path : i, p.path);
    }
}
#endif
