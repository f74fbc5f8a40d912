#pragma once
// Layouts of queues on the host, expanded from the lists that kernels use (include/eikonal/queues.h).

#include "feature_set.h"

#include <string>
#include <vector>

namespace eikonal {

/// One field of a queue.
struct FieldLayout {
    std::string name, type;
    int slot;    ///< first word; the address of word w of item i is ((slot + w) * capacity + i) * 4 bytes
    int words;   ///< 0 if its feature is absent
};

/// The fields of a queue, and the number of words per item.
struct QueueLayout {
    std::string name;
    std::vector<FieldLayout> fields;
    int words = 0;
    /// Throws std::out_of_range for an unknown field.
    const FieldLayout& field(const std::string& name) const;
};

/// The layouts of all queues, in the order of QUEUES, for a scene that requires `features`.
std::vector<QueueLayout> queueLayouts(const Features& features);
/// The layout of the queue `name`. Throws std::out_of_range for an unknown queue.
QueueLayout queueLayout(const std::string& name, const Features& features);
/// The layout of a film pixel. If the film keeps a spectrum, a field "buckets" follows, with BUCKET_WORDS words per bucket; then, if it
/// keeps light groups, "groups", with GROUP_WORDS words per group; then, if it keeps them, "object_mattes" and "material_mattes", with
/// MATTE_SLOTS slots of MATTE_WORDS words.
QueueLayout filmLayout(const Features& features, uint buckets = 0, int lightGroups = 0);
/// Of a stored vertex of a light path, and of its entry in the grid: records, one after the other.
QueueLayout vertexLayout(const Features& features);
QueueLayout gridLayout(const Features& features);
/// The largest number of parameter words of any BSDF.
int bsdfWords(const Features& features);

}  // namespace eikonal
