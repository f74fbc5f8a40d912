#pragma once
// Running one stage alone: queues in, queues out.
//
//     StageBench bench(scene, 256);
//     bench.write("ray", rays);
//     bench.run("intersect_rays", 256);
//     QueueWords intersections = bench.read("intersection");

#include "queue_words.h"
#include "test_device.h"

#include "render/batch_tables.h"
#include "render/device_scene.h"
#include "render/wave_counts.h"
#include "render/wave_queues.h"
#include "scene/scene.h"

#include <map>
#include <memory>
#include <string>

namespace eikonal {

/// What new_x() and the benches fill memory with: a word that no stage may leave in an item that is alive.
constexpr uint poison = 0x7fc0deadu;

/// The scene of some pbrt text. Throws for anything that the reader or the packer complains about. automatic: in RGB, unless spectra are
/// given.
PackedScene packText(const std::string& text, ColorMode color = ColorMode::automatic);

/// A scene on the device, a queue of each kind, and any stage to run over them.
class StageBench {
public:
    /// Queues have room for `paths`, as in a wave (WaveSize), even those that the scene does not require. All words are poison at first,
    /// but paths and film (of as many pixels as there are paths, or `filmPixels`) hold zeros. poisonItems: the device poisons new items,
    /// too.
    StageBench(const PackedScene& scene, unsigned paths, bool poisonItems = true, unsigned filmPixels = 0);

    /// "ray" "next_ray" "intersection" "hit" "scatter" "miss" "emission" "shadow" "path" "film" as on the host.
    QueueWords read(const std::string& queue) const;
    void write(const std::string& queue, const QueueWords& words);
    /// One with the layout of a queue, all poison.
    QueueWords empty(const std::string& queue) const;
    void clear(const std::string& queue, uint word = poison);

    /// The math flags of the stages that run from now on, instead of the shipped ones.
    void setMathFlags(std::string flags) { mathFlags_ = std::move(flags); }
    /// The names of all queues and counters, and what they hold.
    using State = std::map<std::string, std::vector<uint>>;
    State save() const;
    void restore(const State& state);

    /// A number that stages take as an argument.
    void set(const std::string& name, uint number) { bindings_.set(name, number); }
    /// What the slots of the wave stand for; at first nothing. endX, endY: no pixel from there on.
    void set(const Batch& batch, int endX, int endY) { tables_.write(testContext(), batch, endX, endY); }
    /// Sets `first` and `count`, and runs the stage over `count` slots. "shade_hits diffuse" is that stage for a BSDF.
    void run(const std::string& stage, unsigned count, unsigned first = 0);
    /// Runs the stages that the scene requires and that run over `items`, one of next_queue or stage_items, in the order of STAGES.
    void runOver(uint items, SlotRange slots);

    /// What classify_intersections found for each next_queue, and how many rays; and how many shadow rays test_shadows.
    std::vector<uint> counts() const { return readWords("counts", next_queues); }
    uint rays() const { return readWords("counts", wave_counts)[count_of_batches]; }
    uint shadowRays() const { return readWords("shadow_count", 1)[0]; }
    /// Zeroes these, and the cursors.
    void resetCounters();

    /// Where items are that are shaded, after classify_intersections.
    Segments segments() const { return {counts(), testGroup}; }

    unsigned capacity() const { return size_.capacity; }
    const PackedScene& scene() const { return scene_; }

private:
    std::vector<uint> readWords(const std::string& buffer, size_t words) const;
    const PackedScene& scene_;
    WaveSize size_;
    bool poisonItems_;
    DeviceScene onDevice_;
    BatchTables tables_{testContext()};
    std::map<std::string, Buffer> buffers_;
    std::map<std::string, std::pair<QueueLayout, size_t>> layouts_;   ///< and items
    Bindings bindings_;
    std::string mathFlags_ = shippedMathFlags;
    std::map<std::pair<std::string, std::string>, Kernel> kernels_;   ///< by stage and math flags
};

/// The names of all stages of STAGES, shade_hits once for each BSDF.
std::vector<std::string> allStages();

}  // namespace eikonal
