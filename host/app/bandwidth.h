#pragma once
// How far a stage is from what memory would let it do: the bytes of queues that it moves, beside a kernel that does nothing but move them.

#include "device/program.h"
#include "render/stages.h"

namespace eikonal {

/// Bytes of queues that a stage reads and writes for a slot, in a scene with these features: all fields of what it reads and writes; if it
/// chooses among dense queues, of the widest that it writes alone; of a path that it adds light to, its radiance twice. Tables of the scene
/// do not count. 0 for resolve_film, whose slots are pixels.
double queueBytesPerSlot(const StageProgram& stage, const Features& features);

/// Bytes a second, read and written, at which items of 16 words are copied from a queue into another that is too large for a cache: the
/// best of five.
double queueCopyRate(const Context& context, Compiler& compiler, const StageShape& shape);

}  // namespace eikonal
