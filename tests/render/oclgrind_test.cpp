// Every stage on Oclgrind, an OpenCL device that watches each access to memory.

#include "measured_file.h"
#include "run_program.h"
#include "test_paths.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <regex>

namespace eikonal {
namespace {

class Oclgrind : public ProgramTest {
protected:
    /// What it reports, entry by entry. Left out: that resolve_film reads uninitialised memory. The film reaches it as a rectangle, and
    /// Oclgrind 21.10 remembers the last row of such a copy only; kernel tests look for poison there instead.
    std::vector<std::string> reports(const std::string& log) const {
        std::vector<std::string> list;
        const std::string text = read(log);
        const std::regex gap("\n\\s*\n");
        for (std::sregex_token_iterator at(text.begin(), text.end(), gap, -1), end; at != end; ++at) {
            const std::string entry = *at;
            const bool isKnown =
                entry.find("Kernel: resolve_film") != std::string::npos && std::regex_search(entry, std::regex("[Uu]ninitialized"));
            if (!isKnown && entry.find_first_not_of(" \t\n") != std::string::npos) list.push_back(entry);
        }
        return list;
    }

    void expectNothingIn(const char* scene, const std::string& more = "") {
        if (std::system("oclgrind --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "oclgrind is not installed (Debian package oclgrind)";
        write("scene.pbrt", scene);
        /* Functions are called, not inlined: inlining leaves an intrinsic behind that Oclgrind 21.10 does not know */
        const std::string command =
            "cd '" + path("") +
            "' && oclgrind --build-options -disable-llvm-passes --data-races --uninitialized --check-api --max-errors 100000 --log log.txt "
            "'" EIKONAL_BINARY
            "' render scene.pbrt -o image.exr --device Oclgrind --no-cache --wave-paths 64 --local-size 16 " + more + " > out.txt 2>&1";
        ASSERT_EQ(std::system(command.c_str()), 0) << read(path("out.txt"));
        ASSERT_TRUE(std::filesystem::exists(path("log.txt")));
        const std::vector<std::string> found = reports(path("log.txt"));
        EXPECT_TRUE(found.empty()) << found.size() << " reports; the first is\n" << found.front();
    }
};

/// All stages and most of what they do: a medium behind an interface, a sky, a lamp, every family of BSDFs, an instance, a cut-out, a
/// texture, tangents, a displaced mesh. (Not Sobol': Oclgrind 21.10 cannot reverse bits.)
constexpr const char* everything = R"(LookAt 0 0 -4  0 0 0  0 1 0
Camera "perspective" "float fov" 40 "float lensradius" .01 "float focaldistance" 4
Sampler "independent" "integer pixelsamples" 1
Film "rgb" "integer xresolution" 8 "integer yresolution" 8
Integrator "volpath" "integer maxdepth" 3
WorldBegin
LightSource "infinite" "rgb L" [.3 .3 .3]
LightSource "point" "rgb I" [5 5 5] "point3 from" [1 2 -3]
AttributeBegin
    AreaLightSource "diffuse" "rgb L" [4 4 4] Translate 0 1.2 0 Rotate 90 1 0 0 Shape "disk" "float radius" .5
AttributeEnd
MakeNamedMedium "smoke" "string type" "homogeneous" "rgb sigma_a" [.1 .2 .3] "rgb sigma_s" [3 2 1]
MakeNamedMedium "cloud" "string type" "uniformgrid" "integer nx" 2 "integer ny" 1 "integer nz" 1 "float density" [1 3]
    "point3 p0" [-1 -1 -1] "point3 p1" [1 1 1]
AttributeBegin
    Material "interface" MediumInterface "smoke" "" Translate .8 .6 -.5 Shape "sphere" "float radius" .5
    MediumInterface "cloud" "" Translate -1 -.8 -.5 Shape "sphere" "float radius" .4
AttributeEnd
ObjectBegin "ball"
    Material "conductor" "float roughness" .2 Shape "sphere" "float radius" .4
ObjectEnd
AttributeBegin Translate -.8 .5 0 ObjectInstance "ball" AttributeEnd
AttributeBegin Translate -.8 -.6 0 Material "dielectric" Shape "sphere" "float radius" .4 AttributeEnd
AttributeBegin Translate 0 .5 0 Material "dielectric" "float roughness" .3 Shape "sphere" "float radius" .3 AttributeEnd
AttributeBegin Translate .5 -.6 0 Material "coateddiffuse" Shape "sphere" "float radius" .4 AttributeEnd
AttributeBegin Translate .6 .5 .3 Material "measured" "string filename" "brushed.bsdf" Shape "sphere" "float radius" .4 AttributeEnd
Texture "check" "spectrum" "checkerboard" "float uscale" 4 "float vscale" 4
Texture "holes" "float" "checkerboard" "float uscale" 8 "float vscale" 8 "float tex1" 0
MakeNamedMaterial "paint" "string type" "diffuse" "texture reflectance" "check"
MakeNamedMaterial "foil" "string type" "diffusetransmission"
Material "mix" "string materials" ["paint" "foil"]
Shape "trianglemesh" "point3 P" [-2 -2 1  2 -2 1  2 2 1  -2 2 1] "integer indices" [0 1 2 0 2 3] "point2 uv" [0 0 1 0 1 1 0 1]
    "texture alpha" "holes"
    "vector3 S" [1 0 0  1 1 0  0 1 0  -1 1 0]
Texture "waves" "float" "fbm"
Translate 0 -1 0 Shape "plymesh" "string filename" "ground.ply" "texture displacement" "waves" "float edgelength" .7
)";

TEST_F(Oclgrind, FindsNothing) {
    MeasuredFile{.isotropic = false}.write(path("brushed.bsdf"));
    write(
        "ground.ply",
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nproperty float u\nproperty float "
        "v\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n-1 0 -1 0 0\n1 0 -1 1 0\n1 0 1 1 1\n-1 0 1 0 1\n4 0 1 2 3\n");
    expectNothingIn(everything);
}

/// A film that keeps a spectrum, of a range that some wavelengths are beside of. (Not a body that light is diffused in: rays that are no
/// probes leave a probe's fields as they are, and Oclgrind reports that they are copied.)
TEST_F(Oclgrind, FindsNothingInSpectra) {
    expectNothingIn(R"(LookAt 0 0 -4  0 0 0  0 1 0
Camera "perspective" "float fov" 40
Sampler "independent" "integer pixelsamples" 2
Film "spectral" "integer xresolution" 6 "integer yresolution" 5 "integer nbuckets" 9 "float lambdamin" 400 "float lambdamax" 700
Integrator "volpath" "integer maxdepth" 2
WorldBegin
LightSource "infinite" "blackbody L" 4000
Material "dielectric" "spectrum eta" "glass-F11" Shape "sphere" "float radius" .7
Material "diffuse" "rgb reflectance" [.8 .3 .1] Shape "bilinearmesh" "point3 P" [-2 -2 1  2 -2 1  -2 2 1  2 2 1]
)");
}

/// Paths from lights of each place: a point, one direction, lamps (one of them cut out), a sky; through a filter and a lens.
constexpr const char* bothEnds = R"(LookAt 0 0 -4  0 0 0  0 1 0
Camera "perspective" "float fov" 40 "float lensradius" .01 "float focaldistance" 4
Sampler "independent" "integer pixelsamples" 1
PixelFilter "gaussian"
Film "rgb" "integer xresolution" 6 "integer yresolution" 6
Integrator "bdpt" "integer maxdepth" 4
WorldBegin
LightSource "infinite" "rgb L" [.3 .3 .3]
LightSource "point" "rgb I" [5 5 5] "point3 from" [1 2 -3]
LightSource "distant" "point3 from" [1 2 -3]
AttributeBegin AreaLightSource "diffuse" "rgb L" [4 4 4] "bool twosided" true Translate 0 1.2 0
    Rotate 90 1 0 0 Shape "disk" "float radius" .5
    "float alpha" .5 AttributeEnd
AttributeBegin AreaLightSource "diffuse" "rgb L" [4 4 4] Translate -1 1 0 Shape "sphere" "float radius" .2 AttributeEnd
AttributeBegin Material "interface" Translate 0 0 -1 Shape "sphere" "float radius" .6 AttributeEnd
AttributeBegin Material "dielectric" Translate .6 0 0 Shape "sphere" "float radius" .4 AttributeEnd
AttributeBegin Material "coateddiffuse" Translate -.6 0 0 Shape "sphere" "float radius" .4 AttributeEnd
Material "hair" Shape "curve" "string type" "cylinder" "float width" .1 "point3 P" [-1 .5 0  -.5 .6 0  .5 .5 0  1 .6 0]
Material "diffuse" Shape "bilinearmesh" "point3 P" [-2 -.5 -2  2 -.5 -2  -2 -.5 2  2 -.5 2]
)";
TEST_F(Oclgrind, FindsNothingInLightPaths) { expectNothingIn(bothEnds, "--color rgb"); }

}  // namespace
}  // namespace eikonal
