#pragma once
// Meshes that are written out in the scene file, and those in PLY files.

#include "read/pbrt/arguments.h"
#include "read/mesh/ply.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace eikonal::pbrt {

/// The mesh of a shape "trianglemesh" (corners: 3) or "bilinearmesh" (4). Throws SceneError.
std::shared_ptr<Mesh> readMesh(Reading& reading, const Arguments& arguments, int corners);

/// The limit surface of a shape "loopsubdiv". Throws SceneError as readMesh, and where it had too many triangles.
std::shared_ptr<Mesh> readSubdividedMesh(Reading& reading, const Arguments& arguments);

/// The PLY files of a scene, each read once, all of them in parallel.
class PlyFiles {
public:
    explicit PlyFiles(Reading& reading) : reading_(reading) {}

    /// The number of a file, which will be read by load().
    int add(const std::string& path, const SourceLocation& where);
    /// Reads them all; what is wrong with them is noted.
    void load();
    /// After load(): what a file holds; nothing if it could not be read.
    const PlyMesh& mesh(int number) const { return files_[number].mesh; }

private:
    struct File { std::string path; SourceLocation where; PlyMesh mesh; };

    Reading& reading_;
    std::vector<File> files_;
    std::map<std::string, int> numbers_;
};

}  // namespace eikonal::pbrt
