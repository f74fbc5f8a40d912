// Every kind defines what the code that knows no kinds calls without asking: one that forgets it is found here, and not by a user.

#include "kinds/camera_kind.h"
#include "kinds/filter_kind.h"
#include "kinds/integrator_kind.h"
#include "kinds/light_kind.h"
#include "kinds/material_kind.h"
#include "kinds/medium_kind.h"
#include "kinds/shape_kind.h"
#include "kinds/texture_kind.h"
#include "scene/film.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

namespace eikonal {
namespace {

/// The parts of a row, one after the other.
template <size_t parts> std::string joined(const char* const (&row)[parts]) {
    std::string text;
    for (const char* part : row)
        if (part) text += std::string(part) + "; ";
    return text;
}

TEST(Kinds, OfCamerasSayWhereTheySeeAPoint) {
    for (const CameraKind& kind : cameraKindList()) {
        EXPECT_TRUE(kind.traits.parameters) << kind.name;
        EXPECT_TRUE(kind.traits.pack) << kind.name;
        EXPECT_TRUE(kind.traits.project) << kind.name;
    }
}

TEST(Kinds, OfLightsArePackedAsWhatTheyAre) {
    for (const LightKind& kind : lightKindList()) {
        EXPECT_EQ(kind.traits.packElement != nullptr, kind.place == LightPlace::AREA) << kind.name;
        EXPECT_EQ(kind.traits.pack != nullptr, kind.place != LightPlace::AREA) << kind.name;
        const bool isSomewhere = kind.place == LightPlace::POINT || kind.place == LightPlace::AREA;
        EXPECT_EQ(kind.traits.bound != nullptr, isSomewhere) << kind.name;
        EXPECT_EQ(kind.traits.directive != nullptr, kind.traits.read != nullptr) << kind.name;
    }
}

TEST(Kinds, OfShapesEmitOrSayWhyNot) {
    for (const ShapeKind& kind : shapeKindList()) {
        EXPECT_FALSE(kind.traits.directives.empty()) << kind.name;
        EXPECT_TRUE(kind.traits.bound) << kind.name;
        EXPECT_TRUE(kind.traits.pack) << kind.name;
        EXPECT_NE(kind.traits.lightKindOf != nullptr, kind.traits.cannotEmit != nullptr) << kind.name;
    }
}

TEST(Kinds, OfMaterialsHaveABsdf) {
    std::set<std::string> names;
    for (const MaterialKind* kind : materialKindList()) {
        EXPECT_TRUE(kind->pack);
        for (const MaterialDirective& directive : kind->directives) {
            EXPECT_TRUE(names.insert(directive.name).second) << directive.name << " is two kinds";
            EXPECT_TRUE(directive.parameters) << directive.name;
        }
        EXPECT_EQ(kind->metalIndices[0] != nullptr, kind->metalIndices[1] != nullptr);
    }
}

TEST(Kinds, OfMediaAreReadAndPacked) {
    for (const MediumKind& kind : mediumKindList()) {
        EXPECT_TRUE(kind.traits.read) << kind.name;
        EXPECT_TRUE(kind.traits.pack) << kind.name;
        EXPECT_NE(joined(kind.traits.parameters).find("float g "), std::string::npos) << kind.name << " has no phase function";
    }
}

TEST(Kinds, OfTexturesReadWhatTheyHave) {
    for (const TextureKind& kind : textureKindList()) {
        const TextureTraits& traits = kind.traits;
        EXPECT_EQ(traits.read != nullptr, !joined(traits.parameters).empty()) << kind.name;
        EXPECT_FALSE(traits.types == TextureTypes::none && traits.read) << kind.name;
        EXPECT_TRUE(traits.isItsOperand || traits.pack || kind.operands > 0) << kind.name << " is the same for all scenes";
        EXPECT_FALSE(traits.isItsOperand && (traits.pack || kind.operands > 0)) << kind.name << " takes no instruction";
        EXPECT_LE(kind.operands, TEXTURE_STACK) << kind.name;
    }
}

TEST(Kinds, OfFiltersHaveAPositiveMiddleAndAreFinite) {
    std::set<std::string> names;
    for (const FilterKind* kind : filterKindList()) {
        EXPECT_TRUE(names.insert(kind->name).second) << kind->name << " is two kinds";
        for (const char* radius : {"float xradius = ", "float yradius = "})
            EXPECT_NE(std::string(kind->parameters).find(radius), std::string::npos) << kind->name;
        ASSERT_TRUE(kind->eval) << kind->name;
        FilterDescription description;
        description.kind = kind;
        EXPECT_GT(kind->eval(description, 0, 2), 0) << kind->name;
        for (double x = 0; x < 2; x += 0.125) EXPECT_TRUE(std::isfinite(kind->eval(description, x, 2))) << kind->name << " at " << x;
    }
}

TEST(Kinds, OfIntegratorsReadWhatTheyHave) {
    std::set<std::string> names{volpathAlias};
    for (const IntegratorKind* kind : integratorKindList()) {
        EXPECT_TRUE(names.insert(kind->name).second) << kind->name << " is two kinds";
        ASSERT_TRUE(kind->parameters) << kind->name;
        EXPECT_EQ(kind->read != nullptr, *kind->parameters != '\0') << kind->name;
        EXPECT_LE(kind->leastDepth, kind->mostDepth) << kind->name;
        EXPECT_GE(kind->leastDepth, 0) << kind->name;
        EXPECT_TRUE(kind->countsMaterials() || !kind->countsMedia) << kind->name << " needs lights for its media";
    }
}

}  // namespace
}  // namespace eikonal
