#pragma once
// The file of a lens for tests of realistic cameras, which is removed at the end.

#include <atomic>
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

namespace eikonal {

class LensFile {
public:
    /// Elements from the scene to the film, one on each line: radius, thickness, index and diameter.
    explicit LensFile(const std::string& elements) { std::ofstream(file_) << elements; }
    LensFile(const LensFile&) = delete;
    LensFile& operator=(const LensFile&) = delete;
    ~LensFile() { std::filesystem::remove(file_); }
    /// What stands behind the directive Camera.
    std::string camera() const { return "\"realistic\" \"string lensfile\" \"" + file_.string() + "\""; }

private:
    static int number() {
        static std::atomic<int> last = 0;
        return ++last;
    }
    std::filesystem::path file_ =
        std::filesystem::temp_directory_path() / ("eikonal-lens-" + std::to_string(::getpid()) + "-" + std::to_string(number()) + ".dat");
};

}  // namespace eikonal
