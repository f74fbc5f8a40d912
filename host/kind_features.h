#pragma once
// The features of kinds by name. Only for files that handle the kinds of a family: a new kind of any family changes this file.

#include "eikonal/kind_features.h"
#include "feature_set.h"

namespace eikonal {

struct KindFeature {
#define NUMBER(NAME, why) NAME##_number,
#define KIND_FEATURE(NAME, kind) NAME##_number,
    enum Number : unsigned char { GENERAL_FEATURES(NUMBER) KIND_FEATURES count };
#undef KIND_FEATURE
#undef NUMBER
#define KIND_FEATURE(NAME, kind) static constexpr Feature NAME{NAME##_number};
    KIND_FEATURES
#undef KIND_FEATURE
};

}  // namespace eikonal
