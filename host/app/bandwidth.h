#pragma once
// How close a stage comes to the bandwidth limit: the bytes of queues that it moves, compared with a kernel that only copies a queue.

#include "device/program.h"
#include "render/stages.h"

namespace eikonal {

/// Bytes of queues that a stage reads and writes per slot, in a scene with these features. All fields of the queues that it reads and writes
/// count. Of the queues that route_intersections chooses among, the widest counts; of a path that a stage adds light to, only its radiance,
/// read and written. Scene tables do not count. 0 for resolve_film, whose slots are pixels.
double queueBytesPerSlot(const StageProgram& stage, const Features& features);

/// Bytes per second, read plus written, when items of 16 words are copied between two queues that are too large for the caches; the best of
/// five runs.
double queueCopyRate(const Context& context, Compiler& compiler, const StageShape& shape);

}  // namespace eikonal
