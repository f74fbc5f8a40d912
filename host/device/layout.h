#pragma once
// Queues as the host sees them: the same lists (include/eikonal/queues.h), expanded into tables.

#include "eikonal/film.h"
#include "eikonal/queues.h"
#include "feature_set.h"

#include <string>
#include <vector>

namespace eikonal {

/// One field of a queue: where it lies, in words from the start of an item's words.
struct FieldLayout {
    std::string name, type;
    int slot;    ///< first word; the address of word w of item i is ((slot + w) * capacity + i) * 4 bytes
    int words;   ///< 0 if its feature is absent
};

/// A queue: its fields and how many words an item has.
struct QueueLayout {
    std::string name;
    std::vector<FieldLayout> fields;
    int words = 0;
    /// Throws std::out_of_range for a name that no field has.
    const FieldLayout& field(const std::string& name) const;
};

/// Layout of every queue, in the order of QUEUES, for a scene that requires `features`.
std::vector<QueueLayout> queueLayouts(const Features& features);
/// Of the one called `name`.
QueueLayout queueLayout(const std::string& name, const Features& features);
/// Of a pixel of the film. If it keeps a spectrum, its last field is "buckets", of BUCKET_WORDS for each.
QueueLayout filmLayout(const Features& features, uint buckets = 0);
/// The most words that the parameters of any BSDF take.
int bsdfWords(const Features& features);

}  // namespace eikonal
