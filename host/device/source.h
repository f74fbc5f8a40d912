#pragma once
// The text of kernels: files of OpenCL C, what they include, and which features and constants they mention.

#include "feature_set.h"

#include <cstdint>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace eikonal {

/// Where the kernels and the contract headers lie: $EIKONAL_KERNELS, or beside the installed program, or the source tree.
/// Throws an Error that lists the places that were tried.
struct KernelFolders {
    std::string kernels;   ///< holds the .cl and .clh files
    std::string include;   ///< holds eikonal/*.h
};
KernelFolders findKernelFolders();

/// Numbers that are fixed when a program is built, by macro name: LOCAL_SIZE, RUN, ENVIRONMENTS ...
using Constants = std::map<std::string, int>;

/// A few lines that include files, and all that they reach.
class KernelSource {
public:
    /// `text` may define macros before its #include lines. Throws a DeviceError if an included file is missing.
    KernelSource(const KernelFolders& folders, std::string text);

    const std::string& text() const { return text_; }
    /// A hash of the text and of every file that it includes.
    std::uint64_t hash() const { return hash_; }
    /// The features that it mentions, by HAS_X or as the feature of a field.
    const std::set<std::string>& words() const { return words_; }
    /// -I and -D options: every feature and every constant that the source mentions, with its value.
    std::string options(const Features& features, const Constants& constants) const;

private:
    void scan(const std::string& text);
    void include(const std::string& name);
    KernelFolders folders_;
    std::string text_;
    std::set<std::string> files_, words_;
    std::uint64_t hash_;
};

/// FNV-1a, 64 bits, continued from `hash`.
constexpr std::uint64_t hashSeed = 14695981039346656037u;
std::uint64_t hashBytes(std::string_view bytes, std::uint64_t hash = hashSeed);

}  // namespace eikonal
