#pragma once
// The program from outside, with a small scene to run it on.

#include "run_program.h"

#include "image/image_file.h"

#include <filesystem>

namespace eikonal {

class Cli : public ProgramTest {
protected:
    Cli() { write("tiny.pbrt", tinyScene()); }
    bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }
    FilmImage image(const std::string& name) const { return readImage(path(name)).image; }
};

}  // namespace eikonal
