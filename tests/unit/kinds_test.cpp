// Every kind defines what the code that knows no kinds calls without asking: one that forgets it is found here, and not by a user.

#include "kinds/camera_kind.h"
#include "kinds/light_kind.h"
#include "kinds/material_kind.h"
#include "kinds/shape_kind.h"

#include <gtest/gtest.h>

namespace eikonal {
namespace {

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
    for (const MaterialKind* kind : materialKindList()) EXPECT_TRUE(kind->pack);
}

}  // namespace
}  // namespace eikonal
