#pragma once
// What a scene requires, as bits: the host's side of include/eikonal/features.h.

#include "eikonal/features.h"

#include <bitset>
#include <string>
#include <vector>

namespace eikonal {

enum class Feature {
#define GENERAL(NAME, why) NAME,
#define KIND_FEATURE(NAME, kind) NAME,
    GENERAL_FEATURES(GENERAL) KIND_FEATURES
#undef GENERAL
#undef KIND_FEATURE
    count
};

constexpr size_t featureCount = static_cast<size_t>(Feature::count);

/// A set of features. The device sees each as HAS_<name>, 0 or 1.
class Features {
public:
    bool has(Feature f) const { return bits_[static_cast<size_t>(f)]; }
    Features& require(Feature f) { bits_.set(static_cast<size_t>(f)); return *this; }
    Features operator|(const Features& other) const { Features both; both.bits_ = bits_ | other.bits_; return both; }
    bool operator==(const Features&) const = default;
    Features without(Feature f) const { Features fewer = *this; fewer.bits_.reset(static_cast<size_t>(f)); return fewer; }
    /// Every feature of rendering in RGB.
    static Features all() { return allSpectral().without(Feature::SPECTRAL).without(Feature::DISPERSION); }
    /// Every feature of rendering at wavelengths that are sampled where the eye is sensitive.
    static Features allSpectral() { return everything().without(Feature::SPECTRAL_FILM); }
    /// Every feature there is: allSpectral() with wavelengths that are sampled evenly.
    static Features everything() { Features f; f.bits_.set(); return f; }

private:
    std::bitset<featureCount> bits_;
};

/// Its name, as in HAS_<name>.
const std::string& featureName(Feature f);
/// What in a scene asks for it, in words.
const std::string& featureReason(Feature f);
/// Whether it is one of GENERAL_FEATURES, not that of a kind of shape, BSDF, light ...
bool isGeneral(Feature f);
/// The feature of that name, or Feature::count.
Feature featureNamed(const std::string& name);

}  // namespace eikonal
