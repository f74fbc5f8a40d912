#pragma once
// A scene with something of everything, and the queues of one wave through it, made by the stages before the one that is tested
// (each of which is tested on its own).

#include "stage.h"

#include <gtest/gtest.h>

namespace eikonal {

constexpr unsigned side = 16, samples = 4, paths = side * side * samples;
/// All of it.
inline const Batch wholeImage{{4, 4}, {{0, 0, 0, samples}}};

/// Something of everything: all BSDFs but media, textures, bumps, a mix, instances, cut-outs, emitters, an environment.
const PackedScene& sceneOfEverything();

/// A wave, one stage after the other, with what each left behind.
class StageTest : public testing::Test {
protected:
    StageBench bench{sceneOfEverything(), paths, true, side * side};

    void generate(unsigned count = paths, int endX = side, int endY = side) {
        bench.set(wholeImage, endX, endY);
        bench.run("generate_rays", count);
    }
    void intersect() { generate(); bench.run("intersect_rays", paths); }
    void classify() { intersect(); bench.resetCounters(); bench.run("classify_intersections", paths); }
    void route() { classify(); bench.run("route_intersections", paths); }

    /// First slot of a queue's segment.
    unsigned segmentStart(uint next_queue) const { return bench.segments()[next_queue].first; }
};

/// No word of item i of a queue is poison.
void expectClean(const QueueWords& q, size_t i, int words = -1);

double lengthOf(vec3 v);

}  // namespace eikonal
