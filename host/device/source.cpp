#include "device/source.h"

#include "device/kind_files.h"
#include "error.h"

#include <fmt/format.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <unordered_set>

namespace fs = std::filesystem;

namespace eikonal {

struct ContractHeader { const char *name, *text; };

/// The contract headers that this program was built with.
constexpr ContractHeader contractHeaders[] = {
#include "contract_headers.inc"
};

/// The content of a file; nothing if it cannot be read.
static std::optional<std::string> contentOf(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) return std::nullopt;
    std::stringstream content;
    content << file.rdbuf();
    return content.str();
}

static void checkContract(const fs::path& include) {
    for (const ContractHeader& header : contractHeaders)
        if (contentOf(include / header.name) != header.text)
            throw DeviceError(
                fmt::format("{} is not the one that this program was built with, so the kernels next to it do not fit. "
                            "Build the program again, or set EIKONAL_KERNELS to the folder of the kernels that it was built with.",
                            (include / header.name).string()));
}

KernelFolders findKernelFolders() {
    std::vector<fs::path> roots;
    if (const char* set = std::getenv("EIKONAL_KERNELS")) roots.push_back(set);
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    if (!program.empty()) roots.push_back(program.parent_path().parent_path() / EIKONAL_INSTALL_DATADIR);
    roots.push_back(EIKONAL_SOURCE_DIR);
    std::string tried;
    for (const fs::path& root : roots) {
        tried += "\n  " + root.string();
        if (!fs::exists(root / "kernels" / "stages/queue.clh")) continue;
        /* An installation has the headers in the prefix's include folder, the source tree next to the kernels */
        for (const fs::path& include : {root / "include", root.parent_path().parent_path() / "include"})
            if (fs::exists(include / "eikonal" / "queues.h")) {
                checkContract(include);
                return {(root / "kernels").string(), include.string()};
            }
    }
    throw DeviceError("cannot find the kernels. Looked for kernels/ and include/eikonal/ in:" + tried +
                      "\nSet EIKONAL_KERNELS to the folder that holds them.");
}

std::uint64_t hashBytes(std::string_view bytes, std::uint64_t hash) {
    /* The shift mixes high bits of the product back into low ones */
    const auto add = [&](std::uint64_t value) {
        hash = (hash ^ value) * 1099511628211u;
        hash ^= hash >> 32;
    };
    for (; bytes.size() >= sizeof(std::uint64_t); bytes.remove_prefix(sizeof(std::uint64_t))) {
        std::uint64_t word;
        std::memcpy(&word, bytes.data(), sizeof word);
        add(word);
    }
    for (const unsigned char c : bytes) add(c);
    return hash;
}

KernelSource::KernelSource(const KernelFolders& folders, const std::string& text) : folders_(folders) {
    append(text, "program");
    noteWords();
}

/// The file that a line includes; empty if it includes none.
static std::string includedBy(const std::string& line) {
    const size_t hash = line.find_first_not_of(" \t");
    if (hash == std::string::npos || line.compare(hash, 8, "#include") != 0) return {};
    const size_t open = line.find('"'), close = open == std::string::npos ? open : line.find('"', open + 1);
    return close == std::string::npos ? std::string() : line.substr(open + 1, close - open - 1);
}

void KernelSource::append(const std::string& text, const std::string& name) {
    text_ += fmt::format("#line 1 \"{}\"\n", name);
    std::istringstream lines(text);
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        const std::string included = includedBy(line);
        if (included.empty()) text_ += line + "\n";
        else if (files_.contains(included)) text_ += "\n";
        else {
            include(included);
            text_ += fmt::format("#line {} \"{}\"\n", number + 1, name);
        }
    }
}

void KernelSource::include(const std::string& name) {
    if (const std::optional<std::string> kinds = kindFiles(name)) {
        files_.insert(name);
        return append(*kinds, name);
    }
    for (const std::string& folder : {folders_.kernels, folders_.include}) {
        const auto content = contentOf(fs::path(folder) / name);
        if (!content) continue;
        /* A file without an include guard comes each time that it is included, such as once for each BSDF */
        if (content->find("\n#ifndef ") != std::string::npos) files_.insert(name);
        return append(*content, name);
    }
    throw DeviceError(fmt::format("a kernel includes \"{}\", which is in neither {} nor {}", name, folders_.kernels, folders_.include));
}

void KernelSource::noteWords() {
    std::unordered_set<std::string_view> words;
    for (size_t i = 0; i < text_.size();) {
        if (!std::isalpha(static_cast<unsigned char>(text_[i])) && text_[i] != '_') { ++i; continue; }
        size_t end = i;
        while (end < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[end])) || text_[end] == '_')) ++end;
        words.insert(std::string_view(text_).substr(i, end - i));
        i = end;
    }
    words_.insert(words.begin(), words.end());
}

std::string KernelSource::options(const Features& features, const Constants& constants) const {
    std::string options;
    for (size_t i = 0; i < featureCount(); ++i) {
        const Feature feature = static_cast<Feature>(i);
        const std::string& name = featureName(feature);
        /* Queue fields name their feature without HAS_ */
        if (words_.count("HAS_" + name) || (isGeneral(feature) && words_.count(name)))
            options += fmt::format(" -DHAS_{}={}", name, features.has(feature) ? 1 : 0);
    }
    for (const auto& [name, value] : constants)
        if (words_.count(name)) options += fmt::format(" -D{}={}", name, value);
    return options;
}

}  // namespace eikonal
