// Material "subsurface": what is inside of it, and the albedo of deep bodies.

#include "kinds/material_kind.h"
#include "color/diffuse_albedo.h"
#include "kinds/medium_kind.h"
#include "read/formats/image.h"
#include "unit/pbrt_reading.h"

#include <cmath>
#include <numbers>
#include <random>
#include <variant>

namespace eikonal {
namespace {

// A half-space of isotropic scattering without a boundary reflects 1 - H(1) sqrt(1 - rho) of what falls on it perpendicularly.
// Chandrasekhar's function H ("Radiative Transfer", 1950, chapter V) solves 1 / H(mu) = sqrt(1 - rho) + rho / 2 integral of x H(x) / (mu +
// x) over [0, 1].
TEST(DiffuseAlbedo, IsChandrasekharsWithoutABoundary) {
    constexpr int steps = 400;
    for (const double rho : {0.1, 0.5, 0.9, 0.99}) {
        const double s = std::sqrt(1 - rho);
        std::vector<double> H(steps, 1.0);
        const auto next = [&](double mu) {
            double integral = 0;
            for (int j = 0; j < steps; ++j) integral += (j + 0.5) / steps * H[j] / (mu + (j + 0.5) / steps) / steps;
            return 1 / (s + rho / 2 * integral);
        };
        for (int iteration = 0; iteration < 100; ++iteration) {
            std::vector<double> better(steps);
            for (int i = 0; i < steps; ++i) better[i] = next((i + 0.5) / steps);
            H = better;
        }
        EXPECT_NEAR(diffuseAlbedo(rho, 0, 1), 1 - next(1) * s, 2e-4) << rho;
    }
}

// Of light that falls perpendicularly on a half-space of index 1.5 and single-scattering albedo 0.9, Giovanelli (1955) has 0.2600 come back
// (as quoted and confirmed by Wang, Jacques and Zheng, "MCML", 1995): 4 % without having entered.
TEST(DiffuseAlbedo, IsGiovanellisBelowABoundary) { EXPECT_NEAR(0.04 + (1 - 0.04) * diffuseAlbedo(0.9, 0, 1.5), 0.2600, 2e-4); }

// Nothing is lost where nothing absorbs, nor found where nothing scatters; more scattering never means less light, and a boundary that
// keeps light inside does.
TEST(DiffuseAlbedo, KeepsWithinItsBounds) {
    for (const double g : {-0.7, 0.0, 0.9})
        for (const double eta : {1.0, 1.33, 2.0}) {
            SCOPED_TRACE(testing::Message() << "g " << g << " eta " << eta);
            EXPECT_EQ(diffuseAlbedo(0, g, eta), 0);
            EXPECT_EQ(diffuseAlbedo(1, g, eta), 1);
            EXPECT_NEAR(diffuseAlbedo(1 - 1e-9, g, eta), 1, 2e-3);   // it falls like a square root
            EXPECT_LT(diffuseAlbedo(0.5, g, eta), diffuseAlbedo(0.8, g, eta));
            if (eta > 1) { EXPECT_LT(diffuseAlbedo(0.8, g, eta), diffuseAlbedo(0.8, g, 1)); }
        }
}

/// The share of walks from the surface of a half-space straight down that come back, without a boundary.
double albedoByWalks(double rho, double g, int walks) {
    std::mt19937 bits(1);
    std::uniform_real_distribution<double> number;
    double sum = 0;
    for (int walk = 0; walk < walks; ++walk) {
        double depth = 0, mu = 1, weight = 1;
        for (;;) {
            depth -= std::log(1 - number(bits)) * mu;
            if (depth < 0) {
                sum += weight;
                break;
            }
            weight *= rho;
            if (weight < 0.1) {
                if (number(bits) < 0.5) break;
                weight *= 2;
            }
            const double s = (1 - g * g) / (1 - g + 2 * g * number(bits)), cosine = (1 + g * g - s * s) / (2 * g);
            mu = mu * cosine +
                 std::sqrt(std::max((1 - mu * mu) * (1 - cosine * cosine), 0.0)) * std::cos(2 * std::numbers::pi * number(bits));
        }
    }
    return sum / walks;
}

// Four standard errors of a share of 100,000 walks are 0.0063 at most.
TEST(DiffuseAlbedo, IsWhatWalksMeasure) {
    for (const auto& [rho, g] : {std::pair{.9, -.99}, {.9, -.8}, {.7, -.5}, {.9, .5}, {.99, .95}, {.9999, .999}}) {
        const double measured = albedoByWalks(rho, g, 100'000);
        EXPECT_NEAR(diffuseAlbedo(rho, g, 1), measured, 0.0063) << "rho " << rho << ", g " << g;
    }
}

TEST(DiffuseAlbedo, IsInvertedByItsTable) {
    for (const double g : {0.0, 0.8}) {
        const DiffuseAlbedoTable table(g, 1.33);
        EXPECT_EQ(table.singleScattering(0), 0);
        EXPECT_EQ(table.singleScattering(-1), 0);
        EXPECT_EQ(table.singleScattering(1), 1);
        for (const double diffuse : {0.001, 0.05, 0.4, 0.8, 0.97})
            EXPECT_NEAR(diffuseAlbedo(table.singleScattering(diffuse), g, 1.33), diffuse, 1e-3) << "g " << g;
    }
}

// Of light from all sides a boundary of index 1.5 reflects 9.18 % (Judd 1942); one that is none, nothing.
TEST(BoundaryTransmittance, IsJudds) {
    EXPECT_NEAR(boundaryTransmittance(1.5), 1 - 0.0918, 1e-4);
    EXPECT_NEAR(boundaryTransmittance(1), 1, 1e-6);
}

class Subsurface : public PbrtTest {
protected:
    Medium inside(const std::string& parameters) {
        const Material material = world("Material \"subsurface\" " + parameters).materials.at(0);
        EXPECT_EQ(material.kind, &subsurface_material);
        EXPECT_EQ(material.inputs.size(), 3u);   // what its boundary is: eta, uroughness, vroughness
        return *material.interior;
    }
};

TEST_F(Subsurface, IsMilkUnlessItIsTold) {
    const Medium milk = inside("");
    expectNear(milk.sigmaA.albedo(), {.0011, .0024, .014});
    expectNear(milk.sigmaS.albedo(), {2.55, 3.21, 3.77});
    EXPECT_STREQ(milk.kind->name, "homogeneous");
    expectNear(inside("\"string name\" \"Skin1\" \"float scale\" 10").sigmaS.albedo(), {7.4, 8.8, 10.1});
    const Medium given = inside("\"rgb sigma_a\" [1 2 3] \"rgb sigma_s\" [4 5 6] \"float scale\" 2 \"float g\" .5");
    expectNear(given.sigmaA.albedo(), {2, 4, 6});
    expectNear(given.sigmaS.albedo(), {8, 10, 12});
    EXPECT_EQ(given.g, .5);
    EXPECT_EQ(world("Material \"subsurface\"").materials.at(0).inputs.at("eta").value.value(), 1.33);
    EXPECT_THAT(warnings_, IsEmpty());
}

// Free paths are mfp * scale long, in each colour, and the diffuse albedo is the reflectance.
TEST_F(Subsurface, ScattersAsMuchAsItsReflectanceAsks) {
    const Medium m = inside("\"rgb reflectance\" [.8 .5 .2] \"rgb mfp\" [.3 .2 .1] \"float scale\" .5 \"float eta\" 1.4 \"float g\" .6");
    expectNear((m.sigmaA.albedo() + m.sigmaS.albedo()) * glm::dvec3(.15, .1, .05), {1, 1, 1});
    const glm::dvec3 rho = m.sigmaS.albedo() / (m.sigmaA.albedo() + m.sigmaS.albedo()), wanted(.8, .5, .2);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(diffuseAlbedo(rho[c], .6, 1.4), wanted[c], 1e-3);
    const Medium white = inside("\"spectrum reflectance\" [400 .5 700 .5]");   // and a mean free path of 1
    EXPECT_EQ(white.sigmaS.kind(), Spectrum::Kind::sampled);
    EXPECT_NEAR(white.sigmaS.curve()(550) + white.sigmaA.curve()(550), 1, 1e-9);
}

TEST_F(Subsurface, SaysWhatIsMissingOrUnused) {
    EXPECT_THAT(errorOfWorld("Material \"subsurface\" \"rgb sigma_a\" [1 1 1]"), HasSubstr("\"sigma_a\" needs a \"sigma_s\""));
    EXPECT_THAT(errorOfWorld("Material \"subsurface\" \"rgb sigma_s\" [1 1 1]"), HasSubstr("\"sigma_s\" needs a \"sigma_a\""));
    EXPECT_THAT(errorOfWorld("Material \"subsurface\" \"string name\" \"Skin\""), HasSubstr("no substance \"Skin\"; did you mean \"Skin"));
    inside("\"string name\" \"Marble\" \"float g\" .5 \"rgb reflectance\" [1 1 1]");
    EXPECT_THAT(warnings_, testing::UnorderedElementsAre(HasSubstr("\"reflectance\" is ignored"), HasSubstr("\"g\" is ignored")));
}

// The profile without a boundary is Christensen and Burley's: at an albedo of 0.8 free paths over 1.05. Scattering counts as reduced, and a
// boundary widens it.
TEST_F(Subsurface, IsDiffusedUnlessItIsToWalk) {
    const auto read = [&](const std::string& parameters) { return world("Material \"subsurface\" " + parameters).materials.at(0); };
    const Material body = read("\"rgb reflectance\" [.8 .8 .8] \"rgb mfp\" [.3 .2 .1] \"float eta\" 1");
    EXPECT_EQ(body.method, SubsurfaceMethod::diffusion);
    expectNear(body.diffusion->albedo.albedo(), {.8, .8, .8});
    expectNear(body.diffusion->length.albedo(), {.3 / 1.05, .2 / 1.05, .1 / 1.05});
    const Material walk =
        read("\"string method\" \"randomwalk\" \"rgb sigma_a\" [1 1 1] \"rgb sigma_s\" [8 8 8] \"float g\" .5 \"float eta\" 1.5");
    EXPECT_EQ(walk.method, SubsurfaceMethod::randomWalk);
    const double A = diffuseAlbedo(8.0 / 9, .5, 1.5);
    EXPECT_NEAR(walk.diffusion->albedo.albedo().g, A, 5e-3);
    EXPECT_NEAR(walk.diffusion->length.albedo().g,
                0.2 * (1 + 1.25 * std::min(3 * A, 0.9)) / (1.85 - A + 7 * std::pow(std::abs(A - 0.8), 3)), 2e-3);
    EXPECT_THAT(errorOfWorld("Material \"subsurface\" \"string method\" \"dipole\""),
                HasSubstr("\"dipole\"; it can be \"diffusion\" or \"randomwalk\""));
}

// At wavelengths colours are spectra before an albedo is made of them. Greys, spectra and what is given by a reflectance are the same
// there.
TEST_F(Subsurface, CoefficientsAreSpectraBeforeTheyAreAnAlbedo) {
    const auto read = [&](const std::string& parameters) {
        return world("Material \"subsurface\" \"float eta\" 1.33 " + parameters).materials.at(0);
    };
    const Material body = read("\"rgb sigma_a\" [.1 .3 1.5] \"rgb sigma_s\" [6 4 2]");
    ASSERT_TRUE(body.diffusion->atWavelengths);
    const DiffuseAlbedoTable table(0, 1.33);
    const DenseCurve a = body.interior->sigmaA.dense(), s = body.interior->sigmaS.dense(),
                     albedo = body.diffusion->atWavelengths->albedo.dense();
    for (const size_t i : {50, 190, 300}) EXPECT_NEAR(albedo[i], table.diffuse(s[i] / (a[i] + s[i])), 1e-6);
    EXPECT_EQ(body.diffusion->albedo.kind(), Spectrum::Kind::rgb);
    EXPECT_NEAR(body.diffusion->albedo.albedo().b, table.diffuse(2 / 3.5), 1e-6);
    for (const char* parameters : {"\"rgb sigma_a\" [1 1 1] \"rgb sigma_s\" [6 6 6]",
                                   "\"spectrum sigma_a\" [400 1 700 2] \"rgb sigma_s\" [6 4 2]", "\"rgb reflectance\" [.8 .5 .3]"})
        EXPECT_FALSE(read(parameters).diffusion->atWavelengths) << parameters;
}

// A texture is looked up where light enters; what is inside has no such place.
TEST_F(Subsurface, TakesItsReflectanceFromATexture) {
    const auto read = [&](const std::string& parameters) {
        return world("Texture \"t\" \"spectrum\" \"checkerboard\" Material \"subsurface\" \"float eta\" 1 " + parameters).materials.at(0);
    };
    const Material body = read("\"texture reflectance\" \"t\" \"rgb mfp\" [.3 .2 .1] \"float scale\" 2");
    EXPECT_EQ(body.kind, &subsurface_material);
    EXPECT_NE(body.diffusion->albedoTexture, none);
    EXPECT_EQ(body.diffusion->pathTexture, none);
    expectNear(body.diffusion->length.albedo(), {.6, .4, .2});
    EXPECT_FALSE(body.interior);
    EXPECT_TRUE(warnings_.empty());
    const Material other = read("\"texture reflectance\" \"t\" \"string name\" \"Skin1\"");
    EXPECT_FALSE(other.diffusion->isTextured());
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("\"reflectance\" is ignored")));
}

TEST_F(Subsurface, TakesItsFreePathsFromATexture) {
    const auto read = [&](const std::string& parameters) {
        return world("Texture \"t\" \"spectrum\" \"checkerboard\" Material \"subsurface\" \"texture mfp\" \"t\" " + parameters)
            .materials.at(0);
    };
    const Material body = read("\"rgb reflectance\" [.3 .4 .5] \"float scale\" 2");
    EXPECT_EQ(body.diffusion->albedoTexture, none);
    EXPECT_NE(body.diffusion->pathTexture, none);
    expectNear(body.diffusion->albedo.albedo(), {.3, .4, .5});
    EXPECT_NEAR(body.diffusion->length.value(), 2, 1e-6);
    EXPECT_FALSE(body.interior);
    EXPECT_TRUE(warnings_.empty());
    EXPECT_FALSE(read("").diffusion->isTextured());
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("\"mfp\" is ignored")));
}

// From both coefficients, either of which may be a constant, come an albedo and a free path; what is a number is multiplied by the scale at
// once.
TEST_F(Subsurface, TakesItsCoefficientsFromTextures) {
    Scene scene;
    const auto read = [&](const std::string& parameters) {
        scene = world("Texture \"t\" \"spectrum\" \"checkerboard\" Material \"subsurface\" \"float g\" .5 \"float eta\" 1.4 " + parameters);
        return scene.materials.at(0);
    };
    const Material body = read("\"texture sigma_a\" \"t\" \"rgb sigma_s\" [4 5 6] \"float scale\" 2");
    EXPECT_EQ(body.kind, &subsurface_material);
    EXPECT_FALSE(body.interior);
    EXPECT_EQ(body.diffusion->length.value(), 1);
    const Texture& albedo = scene.textures.at(body.diffusion->albedoTexture);
    const Texture& path = scene.textures.at(body.diffusion->pathTexture);
    EXPECT_EQ(albedo.g, .5);
    EXPECT_EQ(path.g, .5);
    EXPECT_EQ(albedo.operands.at(0).texture, path.operands.at(0).texture);
    EXPECT_EQ(scene.textures.at(albedo.operands.at(0).texture).operands.at(1).value.value(), 2);
    expectNear(albedo.operands.at(1).value.albedo(), {8, 10, 12});
    expectNear(path.operands.at(1).value.albedo(), {8, 10, 12});
    const ImageData& row = *scene.images.at(albedo.image).pixels;
    EXPECT_EQ(row.height, 1);
    EXPECT_NEAR(row.floats.at(row.floats.size() / 2), diffuseAlbedo(.75 / (1 - .5 * .25), .5, 1.4), 1e-6);   // s = 1/2
    EXPECT_THAT(warnings_, IsEmpty());

    const Material both = read("\"texture sigma_a\" \"t\" \"texture sigma_s\" \"t\" \"rgb reflectance\" [.3 .4 .5]");
    EXPECT_NE(scene.textures.at(both.diffusion->pathTexture).operands.at(1).texture, none);
    EXPECT_THAT(warnings_, ElementsAre(HasSubstr("\"reflectance\" is ignored")));
    EXPECT_FALSE(read("\"string name\" \"Skin1\" \"texture sigma_a\" \"t\"").diffusion->isTextured());
    EXPECT_THAT(errorOfWorld("Texture \"t\" \"spectrum\" \"checkerboard\" Material \"subsurface\" \"texture sigma_a\" \"t\""),
                HasSubstr("\"sigma_a\" needs a \"sigma_s\""));
}

}  // namespace
}  // namespace eikonal
