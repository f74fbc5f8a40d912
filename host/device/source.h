#pragma once
// The source of kernels: expands includes, and finds which features and constants the source mentions.

#include "feature_set.h"

#include <cstdint>

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

namespace eikonal {

/// The folders of the kernels and contract headers: $EIKONAL_KERNELS, or next to the installed program, or the source tree. Throws a
/// DeviceError that lists the places searched; also throws one if the headers differ from those that this program was built with, since
/// host and kernels would then disagree about layouts.
struct KernelFolders {
    std::string kernels;   ///< holds the .cl and .clh files
    std::string include;   ///< holds eikonal/*.h
};
KernelFolders findKernelFolders();

/// The kernel files' texts, each of which is read once: all kernels of a scene include much the same files.
class KernelFiles {
public:
    explicit KernelFiles(KernelFolders folders) : folders_(std::move(folders)) {}

    const KernelFolders& folders() const { return folders_; }
    /// By its name in a line #include. Valid as long as this is. Throws a DeviceError if there is none.
    const std::string& text(const std::string& name);

private:
    KernelFolders folders_;
    std::map<std::string, std::string> texts_;
};

/// Compile-time constants of a program, by macro name: LOCAL_SIZE, ITEMS_PER_WORK_ITEM, ENVIRONMENTS ...
using Constants = std::map<std::string, int>;

/// A short text with #include lines, expanded into a single source. The OpenCL compiler then needs no include path, whose spelling would
/// have to survive the option parser of each implementation.
class KernelSource {
public:
    /// `text` may define macros before its #include lines. Each file is inserted where it is first included. Throws a DeviceError if one is
    /// missing.
    KernelSource(KernelFiles& files, const std::string& text);

    /// The expanded source; compile errors name the original files, relative to their folder, and lines.
    const std::string& text() const { return text_; }
    /// -D options for all features and constants that the source mentions.
    std::string options(const Features& features, const Constants& constants) const;

private:
    void append(KernelFiles& files, std::string_view text, const std::string& name);
    void include(KernelFiles& files, const std::string& name);
    void noteWords();
    std::string text_;
    std::set<std::string> files_;
    std::unordered_set<std::string> words_;   ///< those that begin with a capital, as features and constants do
};

/// A variant of 64-bit FNV-1a that takes eight bytes at a time, fast enough for scene tables. Continues from `hash`.
constexpr std::uint64_t hashSeed = 14695981039346656037u;
std::uint64_t hashBytes(std::string_view bytes, std::uint64_t hash = hashSeed);

}  // namespace eikonal
