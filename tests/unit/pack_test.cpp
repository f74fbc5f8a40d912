// What the device's tables hold of a scene.

#include "pack/pack.h"

#include "unit/pbrt_reading.h"

namespace eikonal {
namespace {

class Pack : public PbrtTest {
protected:
    PackedScene pack(const std::string& text) {
        Diagnostics diagnostics(LogLevel::silent, true);
        return packScene(world(text), diagnostics);
    }
};

// A sphere of radius 4 and relief of 0.5 is the same scene as one of radius 1 and relief of 0.125: once both are of order one, a
// displacement of one constant is the same number of scene units.
TEST_F(Pack, DisplacementsAreScaledWithTheScene) {
    const auto reliefOf = [&](double radius, double height) {
        const PackedScene scene = pack("Texture \"relief\" \"float\" \"constant\" \"float value\" " + std::to_string(height) +
                                       "\nMaterial \"diffuse\" \"texture displacement\" \"relief\"\nShape \"sphere\" \"float radius\" " + std::to_string(radius));
        const texture_program program = scene.tables.programs.at(scene.tables.materials.at(0).displacement);
        double product = 1;   // a constant, and as long as it is not 1 the scale of the scene
        for (uint i = program.first; i < program.first + program.count; ++i)
            if (scene.tables.instructions[i].kind == kind_constant_texture) product *= scene.tables.instructions[i].value.scale;
        return product;
    };
    EXPECT_EQ(reliefOf(4, 0.5), reliefOf(1, 0.125));
    EXPECT_EQ(reliefOf(4, 0.5) * pack("Shape \"sphere\" \"float radius\" 4").worldScale, 0.5);
}

}  // namespace
}  // namespace eikonal
