#pragma once
// What the tests of the OBJ reader share: files written on the spot, and scenes read from them.

#include "read/obj/obj.h"
#include "unit/temporary_folder.h"

#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace eikonal {

class ObjTest : public TemporaryFolder {
protected:
    /// Four corners of the unit square in z = 0, for faces to use.
    static inline const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

    Scene load(const std::string& content, const ObjOptions& options = {}) {
        Diagnostics diagnostics(LogLevel::silent);
        Scene scene = readObj(write("model.obj", content), options, diagnostics);
        warnings_ = diagnostics.warnings();
        return scene;
    }

    /// The square with one material, whose statements these are.
    Scene loadMaterial(const std::string& statements) {
        write("model.mtl", "newmtl m\n" + statements);
        return load("mtllib model.mtl\n" + square + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl m\nf 1/1 2/2 3/3 4/4\n");
    }

    /// The error without the folder's name, or "no error".
    template <class Read> std::string errorOf(const Read& read) {
        try {
            read();
            return "no error";
        } catch (const Error& error) {
            std::string text = error.what();
            for (std::size_t at; (at = text.find(folder_.string() + "/")) != text.npos;) text.erase(at, folder_.string().size() + 1);
            return text;
        }
    }
    std::string errorIn(const std::string& content) { return errorOf([&] { load(content); }); }
    std::string strictErrorIn(const std::string& content) {
        return errorOf([&] {
            Diagnostics diagnostics(LogLevel::silent, true);
            readObj(write("model.obj", content), {}, diagnostics);
        });
    }

    /// The warnings, but for the one about faces without a material, which files have that are about geometry.
    std::vector<std::string> geometryWarnings() const {
        std::vector<std::string> others = warnings_;
        std::erase_if(others, [](const std::string& text) { return text.find("faces have no material") != text.npos; });
        return others;
    }

    static const Mesh& meshOf(const Scene& scene, std::size_t shape = 0) { return *scene.shapes.at(shape).mesh; }

    std::vector<std::string> warnings_;
};

}  // namespace eikonal
