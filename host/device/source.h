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
/// Throws a DeviceError that lists the places that were tried, and one if the headers are not those that this program was built with:
/// host and kernels would not agree on what lies where.
struct KernelFolders {
    std::string kernels;   ///< holds the .cl and .clh files
    std::string include;   ///< holds eikonal/*.h
};
KernelFolders findKernelFolders();

/// Numbers that are fixed when a program is built, by macro name: LOCAL_SIZE, ITEMS_PER_WORK_ITEM, ENVIRONMENTS ...
using Constants = std::map<std::string, int>;

/// A few lines that include files, and all that they reach, as one text: a compiler needs no folder to look in, whose name would have to
/// survive the options of every OpenCL implementation.
class KernelSource {
public:
    /// `text` may define macros before its #include lines. A file is taken in where it is first included. Throws a DeviceError if one is missing.
    KernelSource(const KernelFolders& folders, const std::string& text);

    /// All of it; errors in it name our files, relative to their folder, and our lines.
    const std::string& text() const { return text_; }
    /// -D options: every feature and every constant that the source mentions, with its value.
    std::string options(const Features& features, const Constants& constants) const;

private:
    void append(const std::string& text, const std::string& name);
    void include(const std::string& name);
    void noteWords();
    KernelFolders folders_;
    std::string text_;
    std::set<std::string> files_, words_;
};

/// As FNV-1a, 64 bits, but of eight bytes at a time: of tables as large as a scene's. Continued from `hash`.
constexpr std::uint64_t hashSeed = 14695981039346656037u;
std::uint64_t hashBytes(std::string_view bytes, std::uint64_t hash = hashSeed);

}  // namespace eikonal
