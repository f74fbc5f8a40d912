#include "tracers.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <limits>

namespace eikonal {

EmbreeTracer::EmbreeTracer(const BenchMesh& mesh, int threads, bool robust, bool highQuality) : threads_(threads) {
    device_ = rtcNewDevice(fmt::format("threads={}", threads).c_str());
    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    void* positions = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(vec3), mesh.positions.size());
    void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(uint), mesh.triangles());
    std::copy_n(mesh.positions.data(), mesh.positions.size(), static_cast<vec3*>(positions));
    std::copy_n(mesh.indices.data(), mesh.indices.size(), static_cast<uint*>(indices));
    rtcCommitGeometry(geometry);
    scene_ = rtcNewScene(device_);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    if (robust) rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene_, highQuality ? RTC_BUILD_QUALITY_HIGH : RTC_BUILD_QUALITY_MEDIUM);
    const auto start = std::chrono::steady_clock::now();
    rtcCommitScene(scene_);
    buildSeconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

EmbreeTracer::~EmbreeTracer() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
}

static RTCRay toRay(const BenchRay& r) {
    RTCRay ray{};
    ray.org_x = r.o.x; ray.org_y = r.o.y; ray.org_z = r.o.z;
    ray.dir_x = r.d.x; ray.dir_y = r.d.y; ray.dir_z = r.d.z;
    ray.tfar = r.tMax;
    ray.mask = ~0u;
    return ray;
}

/// Calls trace(i) for all i on a number of threads.
template <class Trace> static void forEachRay(int threads, size_t first, size_t count, Trace trace) {
    tbb::task_arena arena(threads);
    arena.execute([&] {
        const size_t grain = std::clamp<size_t>(count / 64, 16, 1024);
        tbb::parallel_for(tbb::blocked_range<size_t>(first, first + count, grain), [&](const tbb::blocked_range<size_t>& part) {
            RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            for (size_t i = part.begin(); i < part.end(); ++i) trace(context, i);
        }, tbb::simple_partitioner());
    });
}

void EmbreeTracer::intersect(const std::vector<BenchRay>& rays, std::vector<BenchHit>& hits, size_t first, size_t count) const {
    forEachRay(threads_, first, count, [&](RTCIntersectContext& context, size_t i) {
        RTCRayHit ray{toRay(rays[i]), {}};
        ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene_, &context, &ray);
        const bool missed = ray.hit.geomID == RTC_INVALID_GEOMETRY_ID;
        hits[i] = {missed ? -1 : ray.ray.tfar, missed ? NONE : ray.hit.primID};
    });
}

void EmbreeTracer::occlude(const std::vector<BenchRay>& rays, std::vector<BenchHit>& hits, size_t first, size_t count) const {
    forEachRay(threads_, first, count, [&](RTCIntersectContext& context, size_t i) {
        RTCRay ray = toRay(rays[i]);
        rtcOccluded1(scene_, &context, &ray);
        hits[i] = {ray.tfar < 0 ? 0.f : -1.f, NONE};
    });
}

}  // namespace eikonal
