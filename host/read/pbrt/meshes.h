#pragma once
// Reads meshes in scene files and PLY files.

#include "read/pbrt/arguments.h"
#include "read/mesh/ply.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace eikonal::pbrt {

/// The mesh of a shape "trianglemesh" (corners: 3) or "bilinearmesh" (4). Throws SceneError.
std::shared_ptr<Mesh> readMesh(Reading& reading, const Arguments& arguments, int corners);

/// The limit surface of a shape "loopsubdiv". Throws SceneError as readMesh does, and if it would have too many triangles.
std::shared_ptr<Mesh> readSubdividedMesh(Reading& reading, const Arguments& arguments);

/// The PLY files of a scene. Each is read once, all in parallel.
class PlyFiles {
public:
    explicit PlyFiles(Reading& reading) : reading_(reading) {}

    /// The number of a file, which load() will read.
    int add(const std::string& path, const SourceLocation& where);
    /// Reads all files, and notes their problems.
    void load();
    const std::string& path(int number) const { return files_[number].path; }
    /// After load(): the contents of a file; empty if it could not be read.
    const PlyMesh& mesh(int number) const { return files_[number].mesh; }

private:
    struct File { std::string path; SourceLocation where; PlyMesh mesh; };

    Reading& reading_;
    std::vector<File> files_;
    std::map<std::string, int> numbers_;
};

}  // namespace eikonal::pbrt
