#include "targets.h"

#include "test_paths.h"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace eikonal::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr Target all[] = {
    {"pbrt", runPbrt}, {"scene", runScene}, {"obj", runObj}, {"ply", runPly}, {"lens", runLens}, {"spectrum", runSpectrum},
    {"measured", runMeasured}, {"nanovdb", runNanoVdb}, {"expression", runExpression}, {"image", runImage}, {"film", runFilm},
    {"merge", runMerge},
};

struct Folder {
    std::string path;
    Folder() {
        const fs::path memory = "/dev/shm", base = fs::is_directory(memory) ? memory : fs::temp_directory_path();
        std::string name = (base / "eikonal_fuzz_XXXXXX").string();
        if (!::mkdtemp(name.data())) throw std::runtime_error("cannot make a folder in " + base.string());
        path = name;
        fs::copy(fs::path(EIKONAL_SOURCE_DIR) / "tests/fuzz/files", path, fs::copy_options::recursive);
        fs::current_path(path);
    }
    ~Folder() {
        std::error_code ignored;
        fs::current_path("/", ignored);
        fs::remove_all(path, ignored);
    }
};

}  // namespace

std::span<const Target> targets() { return all; }

const Target& targetNamed(const std::string& name) {
    const auto found = std::ranges::find(all, name, &Target::name);
    if (found != std::end(all)) return *found;
    std::string names;
    for (const Target& target : all) names += std::string(" ") + target.name;
    throw std::invalid_argument("there is no target \"" + name + "\"; the targets:" + names);
}

const std::string& inputFolder() {
    static const Folder folder;
    return folder.path;
}

std::string writeInput(const std::string& name, std::string_view content) {
    const std::string path = inputFolder() + "/" + name;
    std::ofstream file(path, std::ios::binary);
    file.write(content.data(), static_cast<std::streamsize>(content.size()));
    if (!file.flush()) throw std::runtime_error("cannot write " + path);
    return path;
}

bool staysInFolder(std::string_view text) {
    if (text.starts_with("\x1f\x8b") || text.find("..") != text.npos) return false;
    const auto isOfNumber = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) || c == '-' || c == ' ' || c == '\n'; };
    for (size_t at = text.find('/'); at != text.npos; at = text.find('/', at + 1)) {
        const size_t next = text.find_first_not_of('/', at);
        if (next != text.npos && !isOfNumber(text[next])) return false;
    }
    return true;
}

}  // namespace eikonal::fuzz
