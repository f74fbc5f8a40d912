// Several devices render one image: the same bits as one, also if a device fails in the middle.

#include "rendering.h"

#include "render/scene_on_device.h"
#include "read/pbrt/read_pbrt.h"
#include "test_paths.h"

#include <gmock/gmock.h>

namespace eikonal {
namespace {

constexpr const char* lamp = "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [2 3 4] Translate 0 1.5 0 Rotate 90 1 0 0 Shape "
                             "\"disk\" \"float radius\" 0.5 AttributeEnd ";
constexpr const char* balls = "Material \"diffuse\" \"rgb reflectance\" [.8 .5 .3] Shape \"sphere\" \"float radius\" .8 Material "
                              "\"dielectric\" Translate 1.2 0 0 Shape \"sphere\" \"float radius\" 0.4";

constexpr unsigned meanwhile = 1u << 16, never = meanwhile - 1;

/// What a device does, until it fails.
class FailingTracer : public Tracer {
public:
    /// Fails when it has traced so many batches; with `meanwhile` added, when it has asked the host so often to work meanwhile.
    FailingTracer(Tracer& tracer, unsigned batches) : tracer_(tracer), left_(batches) {}
    unsigned mostPaths() const override { return tracer_.mostPaths(); }
    const StopFlag& stopFlag() const override { return tracer_.stopFlag(); }
    unsigned mostStoredPasses() const override { return tracer_.mostStoredPasses(); }
    void trace(const BatchStream& stream) override { tracer_.trace(failing(stream)); }
    void traceLights(const BatchStream& stream, const Buffer& splat, const PixelRect& part) override {
        tracer_.traceLights(failing(stream), splat, part);
    }
    void resolve(const Batch& batch, const Buffer& film) override { tracer_.resolve(batch, film); }

private:
    BatchStream failing(BatchStream stream) {
        stream.traced = [this, traced = stream.traced](const Batch& batch) {
            if (left_ == 0) throw DeviceError("lost");
            if (!(left_ & meanwhile)) --left_;
            traced(batch);
        };
        stream.meanwhile = [this, work = stream.meanwhile] {
            if (left_ == meanwhile) throw DeviceError("lost");
            if (left_ & meanwhile) --left_;
            work();
        };
        return stream;
    }
    Tracer& tracer_;
    unsigned left_;
};

struct Shared {
    FilmImage image;
    std::vector<std::uint64_t> paths;   ///< that each device has traced
    unsigned dropped = 0;
};

class Devices : public testing::Test {
protected:
    /// Renders on as many devices as `fails` has elements, each of which fails after so many batches.
    static Shared share(const PackedScene& scene, const std::vector<unsigned>& fails, std::optional<double> targetError = {}) {
        DeviceOptions options;
        options.device = "Portable Computing Language";
        options.wavePaths = 4096;
        std::vector<std::unique_ptr<SceneOnDevice>> devices;
        std::vector<std::unique_ptr<FailingTracer>> tracers;
        std::vector<RenderDevice> team;
        device();   // where kernels are kept
        for (const unsigned batches : fails) {
            auto& d = *devices.emplace_back(std::make_unique<SceneOnDevice>(std::make_shared<OpenDevice>(options, false)));
            d.build(scene, 0, [] {});
            d.upload(scene);
            d.launch(scene, fails.size() > 1);
            d.keep();
            tracers.push_back(std::make_unique<FailingTracer>(d.wave(), batches));
            team.push_back({&d.context(), tracers.back().get(), &d.profile()});
        }
        Film film(scene);
        Shared result;
        RenderControl control;
        control.endSample = static_cast<unsigned>(scene.samples);
        control.targetError = targetError;
        control.dropped = [&](const RenderDevice&, const DeviceError&) { ++result.dropped; };
        EXPECT_TRUE(eikonal::render(team, film, control).isFinished);
        result.image = film.totals().develop(scene);
        for (const auto& d : devices) result.paths.push_back(d->profile().paths);
        return result;
    }
    static PackedScene scene(const std::string& more = "") {
        return packScene(sceneText({.fov = 50, .width = 48, .height = 40, .samples = 45, .more = more}, std::string(lamp) + balls));
    }
    static void expectSame(const PackedScene& scene, const std::vector<unsigned>& fails, unsigned dropped,
                           std::optional<double> targetError = {}) {
        const Shared one = share(scene, {never}, targetError), more = share(scene, fails, targetError);
        expectSameBits(one.image, more.image, testing::PrintToString(fails));
        EXPECT_EQ(more.dropped, dropped);
        std::uint64_t paths = 0;
        for (const std::uint64_t p : more.paths) paths += p;
        EXPECT_EQ(paths, one.paths.front()) << "each path counts once";
    }
};

TEST_F(Devices, ShareAnImage) {
    expectSame(scene(), {never, never}, 0);
    expectSame(scene(), {never, never, never}, 0);
}

TEST_F(Devices, ShareAnAdaptiveRender) { expectSame(scene(), {never, never}, 0, 0.1); }

TEST_F(Devices, AreReplacedByTheOthersWhenTheyFail) {
    for (const unsigned batches : {0u, 1u, 5u, 9u}) {
        expectSame(scene(), {never, batches}, 1);
        expectSame(scene(), {batches, never}, 1);
        expectSame(scene(), {batches, never, batches + 2}, 2);
        expectSame(scene(), {never, meanwhile + batches}, 1);   // while a batch is on its way to the film
    }
}

TEST_F(Devices, FailTogether) {
    EXPECT_THROW(share(scene(), {3, 2}), DeviceError);
    EXPECT_THROW(share(scene(), {meanwhile + 6}), DeviceError);
}

TEST_F(Devices, ShareLightPaths) {
    PackedScene both = scene("Integrator \"bdpt\" \"integer maxdepth\" 4");
    ASSERT_TRUE(both.features.has(Feature::LIGHT_PATHS));
    both.features = both.features.without(Feature::CONNECTIONS);   // hits are kept on one device, as vertices are below
    expectSame(both, {never, never}, 0);
    expectSame(both, {never, 3}, 1);
    expectSame(both, {8, never}, 1);
}

TEST_F(Devices, MergePathsOnOneOfThem) {
    const PackedScene merging = scene("Integrator \"vcm\" \"integer maxdepth\" 4");
    ASSERT_TRUE(merging.features.has(Feature::MERGING));
    expectSame(merging, {never, never}, 0);
    for (const unsigned batches : {1u, 4u, 30u}) expectSame(merging, {batches, never}, 1);
}

}  // namespace
}  // namespace eikonal
