/* pixels -> ray, path.  Generates a camera ray for each sample of some blocks of the image, in the slots from `first` on. Starts with path
   number `begun` of the batch (film/pixel.clh maps it to a pixel and sample); the batch's path states start at `first_path`. Straight-line;
   paths outside the image, and slots behind the last path, get dead rays.

   STAGE (stages/stage.clh) makes a kernel of a list of arguments: tables of the scene, then the stage's own. It adds `capacity` and
   `path_capacity`, the slots of the queues and of the path queue, and `count`, how many slots hold items.
   `frame` holds the settings of the render. */
#include "camera/start_path.clh"
#include "stages/stage.clh"
#include "film/pixel.clh"
#include "shade/ray_tree.clh"

#define GENERATE_RAYS(TABLE, ARGUMENT) \
    CAMERA_TABLES(TABLE) COLOR_TABLES(TABLE) \
    ARGUMENT(__global const settings *, frame) ARGUMENT(__global uint *, ray) ARGUMENT(__global uint *, path) BATCH_ARGUMENTS(ARGUMENT) \
    ARGUMENT(uint, begun) ARGUMENT(uint, first_path) ARGUMENT(uint, first)
STAGE(generate_rays, GENERATE_RAYS) {
    camera_tables tables = BIND_CAMERA;
    FOR_EACH_SLOT_OF_GROUP(i, count) {
        uint of_batch = begun + (uint)i;
        pixel_sample at = LOCATE_PATH(of_batch);  /* in_image: 0 beyond the edge of the image, and behind the last path of the batch */
        camera_path p = start_path(tables, wavelengths, frame, at.x, at.y, at.sample, first_path + of_batch, at.in_image);
        store_ray(ray, capacity, first + i, p.ray);
        /* At p.ray.path. Where rays do not split that is first_path + begun + i, computed so that the compiler sees neighbours */
        size_t state = state_to_start(p.ray.path, first_path, begun + i);
        store_path(path, path_capacity, state, p.path);
        clear_groups(path, path_capacity, state);
    }
}
