#include "device/source.h"

#include "error.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace fs = std::filesystem;

namespace eikonal {

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
        if (!fs::exists(root / "kernels" / "queue.clh")) continue;
        /* Installed, the headers lie in the prefix's include folder; in the source tree, beside the kernels */
        for (const fs::path& include : {root / "include", root.parent_path().parent_path() / "include"})
            if (fs::exists(include / "eikonal" / "queues.h")) return {(root / "kernels").string(), include.string()};
    }
    throw DeviceError("cannot find the kernels. Looked for kernels/ and include/eikonal/ in:" + tried + "\nSet EIKONAL_KERNELS to the folder that holds them.");
}

std::uint64_t hashBytes(std::string_view bytes, std::uint64_t hash) {
    for (unsigned char c : bytes) hash = (hash ^ c) * 1099511628211u;
    return hash;
}

KernelSource::KernelSource(const KernelFolders& folders, std::string text) : folders_(folders), text_(std::move(text)), hash_(hashSeed) { scan(text_); }

void KernelSource::scan(const std::string& text) {
    hash_ = hashBytes(text, hash_);
    /* Words */
    for (size_t i = 0; i < text.size();) {
        if (!std::isalpha(static_cast<unsigned char>(text[i])) && text[i] != '_') { ++i; continue; }
        size_t end = i;
        while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) || text[end] == '_')) ++end;
        words_.insert(text.substr(i, end - i));
        i = end;
    }
    /* Includes */
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const size_t hash = line.find_first_not_of(" \t");
        if (hash == std::string::npos || line.compare(hash, 8, "#include") != 0) continue;
        const size_t open = line.find('"'), close = line.find('"', open + 1);
        if (close != std::string::npos) include(line.substr(open + 1, close - open - 1));
    }
}

void KernelSource::include(const std::string& name) {
    if (!files_.insert(name).second) return;
    for (const std::string& folder : {folders_.kernels, folders_.include}) {
        std::ifstream file(fs::path(folder) / name, std::ios::binary);
        if (!file) continue;
        std::stringstream content;
        content << file.rdbuf();
        scan(content.str());
        return;
    }
    throw DeviceError(fmt::format("a kernel includes \"{}\", which is in neither {} nor {}", name, folders_.kernels, folders_.include));
}

std::string KernelSource::options(const Features& features, const Constants& constants) const {
    std::string options = fmt::format("-I{} -I{}", folders_.kernels, folders_.include);
    for (size_t i = 0; i < featureCount; ++i) {
        const Feature feature = static_cast<Feature>(i);
        const std::string& name = featureName(feature);
        /* A field of a queue names its feature without HAS_ */
        if (words_.count("HAS_" + name) || (isGeneral(feature) && words_.count(name))) options += fmt::format(" -DHAS_{}={}", name, features.has(feature) ? 1 : 0);
    }
    for (const auto& [name, value] : constants)
        if (words_.count(name)) options += fmt::format(" -D{}={}", name, value);
    return options;
}

}  // namespace eikonal
