#pragma once
// Cryptomatte 1.2.0 (Friedman and Jones 2015; specification by Psyop): mattes of everything that has a name, as channels of an EXR.

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace eikonal {

/// What each pixel shows, by ID. `values` has for each pixel an ID and its coverage, the share of the pixel's samples by weight, for each
/// of `ranks` ranks, of falling coverage. The ID of what has no surface is 0; ranks that are left over have ID and coverage 0.
struct CryptomatteLayer {
    static constexpr std::size_t ranks = 6;          ///< what the specification suggests
    static constexpr std::size_t perPixel = 2 * ranks;
    std::string name;                                ///< "CryptoObject"
    std::string manifest;                            ///< JSON: the IDs of all names; empty: not known
    std::vector<float> values;
};

/// Names and the bits of their IDs.
using CryptomatteIds = std::map<std::string, std::uint32_t>;

/// The names of the layers.
inline constexpr const char* cryptomatteLayerNames[] = {"CryptoObject", "CryptoMaterial"};

/// MurmurHash3_x86_32 (Appleby) with seed 0.
std::uint32_t murmurHash3(const std::string& bytes);
/// The bits of the float that stands for a name: its hash, with one bit of the exponent flipped where that would be no normal number.
std::uint32_t cryptomatteId(const std::string& name);
/// A name as UTF-8: bytes that are none become U+FFFD.
std::string cryptomatteName(const std::string& name);
std::string cryptomatteManifest(const CryptomatteIds& ids);

/// The channel of a layer that holds number i of a pixel's values: "CryptoObject00.r".
std::string cryptomatteChannel(const std::string& layer, std::size_t i);
/// The name of a layer's attribute in a file: `what` is name, hash, conversion or manifest.
std::string cryptomatteAttribute(const std::string& layer, const char* what);
/// The attributes of a layer, and their texts.
std::vector<std::pair<std::string, std::string>> cryptomatteAttributes(const CryptomatteLayer& layer);

}  // namespace eikonal
