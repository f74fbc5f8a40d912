// Sums of very many samples, and auxiliary channels where no path scatters.

#include "rendering.h"
#include "run_program.h"

#include "device/math_flags.h"

#include <gmock/gmock.h>

#include <filesystem>

namespace eikonal {
namespace {

constexpr const char* wall = "LightSource \"point\" Material \"diffuse\" \"rgb reflectance\" [.5 .4 .3] Shape \"bilinearmesh\" "
                             "\"point3 P\" [-9 -9 2  9 -9 2  -9 9 2  9 9 2]\n";

Rendered renderAovs(const View& view, const std::string& world) {
    PackedScene scene = packScene(sceneText(view, world));
    scene.require(Feature::AOVS, "the test");
    return render(std::move(scene));
}

/// All samples see one point, (3, 1, 2), but for the width of a pixel, 1e-3 of which is left by 2^20 samples; its (u, v) is that of the
/// wall's 18 units from -9 on. Uncompensated sums were 1.4 % off.
TEST(ExtremeSums, MeansOfAMillionPositionsAreExact) {
    View v;
    v.width = v.height = 1;
    v.samples = 1 << 20;
    v.maxDepth = 0;
    v.lookAt = "3 1 -4  3 1 0  0 1 0";
    const Rendered r = renderAovs(v, wall);
    const glm::vec3 p = r.image.position[0], expected(3, 1, 2);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(p[c], expected[c], 1e-5);
    EXPECT_NEAR(r.image.uv[0].x, 12. / 18, 1e-6);
    EXPECT_NEAR(r.image.uv[0].y, 10. / 18, 1e-6);
    EXPECT_NEAR(r.image.depth[0], 6, 1e-5);
    EXPECT_NEAR(r.image.albedo[0].g, .4, 1e-6);
}

/// Auxiliary channels do not depend on the depth of paths; no light arrives without scattering.
TEST(ExtremeSums, ChannelsAreFilledAtDepthZero) {
    View v;
    v.samples = 4;
    v.maxDepth = 2;
    const Rendered deep = renderAovs(v, wall);
    v.maxDepth = 0;
    const Rendered r = renderAovs(v, wall);
    EXPECT_EQ(r.image.position, deep.image.position);
    EXPECT_EQ(r.image.normal, deep.image.normal);
    EXPECT_EQ(r.image.uv, deep.image.uv);
    EXPECT_EQ(r.image.albedo, deep.image.albedo);
    EXPECT_EQ(r.image.depth, deep.image.depth);
    EXPECT_GT(deep.image.color[0].g, 0);
    for (const glm::vec3& c : r.image.color) EXPECT_EQ(c, glm::vec3(0));
}

class InexactFlags : public ProgramTest {};
TEST_F(InexactFlags, AreWarnedOf) {
    write("tiny.pbrt", tinyScene());
    const Outcome run = this->run({"render", "tiny.pbrt", "-o", "a.exr", "--build-options=-cl-fast-relaxed-math"});
    EXPECT_EQ(run.status, 0) << run.error;
    EXPECT_THAT(run.error, testing::HasSubstr("-cl-fast-relaxed-math lets the compiler drop the compensation of sums"));
}

/// --math-flags replaces the flags of the stage that it names, and of no other.
TEST_F(InexactFlags, BelongToTheirStage) {
    write("tiny.pbrt", tinyScene());
    const Outcome run =
        this->run({"render", "tiny.pbrt", "-o", "a.exr", "--dump-kernels", "k", "--math-flags=resolve_film:-cl-mad-enable"});
    EXPECT_EQ(run.status, 0) << run.error;
    int relaxed = 0, shipped = 0;
    for (const auto& file : std::filesystem::directory_iterator(path("k"))) {
        const std::string options = read(file.path().string()).substr(0, 200);
        const bool isFilm = file.path().filename().string().starts_with("resolve_film");
        EXPECT_EQ(options.find("-cl-mad-enable") != std::string::npos, isFilm) << file.path();
        EXPECT_EQ(options.find(shippedMathFlags) != std::string::npos, !isFilm) << file.path();
        ++(isFilm ? relaxed : shipped);
    }
    EXPECT_EQ(relaxed, 1);
    EXPECT_GT(shipped, 4);
}

}  // namespace
}  // namespace eikonal
