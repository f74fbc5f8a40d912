#pragma once
// The features that a scene requires, as a bit set; the host's side of include/eikonal/features.h. A change of a list of kinds does
// not change this file.

#include "eikonal/features.h"

#include <bitset>
#include <string>
#include <vector>

namespace eikonal {

/// One of GENERAL_FEATURES, or the feature of a kind, whose names are in kind_features.h. Numbered through.
enum class Feature : unsigned char {
#define GENERAL(NAME, why) NAME,
    GENERAL_FEATURES(GENERAL)
#undef GENERAL
    none = 255
};

/// How many there are; those of kinds come last.
size_t featureCount();
constexpr size_t mostFeatures = 192;

/// A set of features. Kernels see each as HAS_<name>, 0 or 1.
class Features {
public:
    bool has(Feature f) const { return bits_[static_cast<size_t>(f)]; }
    Features& require(Feature f) { bits_.set(static_cast<size_t>(f)); return *this; }
    Features operator|(const Features& other) const { Features both; both.bits_ = bits_ | other.bits_; return both; }
    bool operator==(const Features&) const = default;
    Features without(Feature f) const { Features fewer = *this; fewer.bits_.reset(static_cast<size_t>(f)); return fewer; }
    /// All features of RGB rendering.
    static Features all() { return allSpectral().without(Feature::SPECTRAL).without(Feature::DISPERSION); }
    /// All features of spectral rendering whose wavelengths are sampled where the eye is sensitive.
    static Features allSpectral() { return everything().without(Feature::SPECTRAL_FILM); }
    /// All features: allSpectral() with evenly sampled wavelengths.
    static Features everything();

private:
    std::bitset<mostFeatures> bits_;
};

/// The name X in HAS_X.
const std::string& featureName(Feature f);
/// What in a scene requires it, in words.
const std::string& featureReason(Feature f);
/// Whether it is one of GENERAL_FEATURES, rather than for a kind of shape, BSDF, light ...
bool isGeneral(Feature f);
/// The feature called `name`, or Feature::none.
Feature featureNamed(const std::string& name);

}  // namespace eikonal
