#pragma once
// Images and textures of a scene (scene.h says how it is described).

#include "error.h"
#include "scene/basics.h"
#include "color/spectrum.h"

#include <memory>
#include <string>
#include <variant>

namespace eikonal {

struct ImageData;   // scene/image.h

enum class ColorEncoding { automatic, srgb, linear };  ///< automatic: sRGB for files of integers, linear for others
enum class WrapMode { repeat, black, clamp, octahedral };
enum class FilterMode { nearest, bilinear };

/// An image file that the scene refers to. Loaded when the scene is packed; the reader only checks that it exists.
struct ImageFile {
    std::string path;      ///< as it can be opened from here
    ColorEncoding encoding = ColorEncoding::automatic;
    double gamma = 0;      ///< > 0: decode by this power instead
    WrapMode wrap = WrapMode::repeat;
    FilterMode filter = FilterMode::bilinear;
    std::shared_ptr<const ImageData> pixels;  ///< made by the program instead of read from a file; null: read `path`
    SourceLocation where;
    bool operator==(const ImageFile& other) const {
        return path == other.path && encoding == other.encoding && gamma == other.gamma && wrap == other.wrap && filter == other.filter &&
               pixels == other.pixels;
    }
};

/// A value, or the texture that provides it. A float is a spectrum that is the same in all channels.
struct Input {
    Spectrum value;        ///< used when texture == none
    int texture = none;    ///< in Scene::textures
    SourceLocation where;  ///< where it was given; no file: a default
};

enum class TextureMapping { uv, spherical, cylindrical, planar };

/// How a texture finds its coordinates on a surface.
struct Mapping {
    TextureMapping kind = TextureMapping::uv;
    double uScale = 1, vScale = 1, uOffset = 0, vOffset = 0;  ///< uv, planar: applied last
    glm::dvec3 planeU{1, 0, 0}, planeV{0, 1, 0};              ///< planar: "v1", "v2"
    Transform worldFromTexture{1};                            ///< spherical, cylindrical, planar
};

struct ConstantTexture { Input value; };
struct ImagemapTexture { int image = none; Mapping mapping; double scale = 1; bool invert = false; };
struct ScaleTexture { Input texture, scale; };
struct MixTexture { Input a, b, amount; };
struct CheckerboardTexture { Input a, b; Mapping mapping; int dimensions = 2; };
struct BilerpTexture { Input v00, v01, v10, v11; Mapping mapping; };
struct DotsTexture { Input inside, outside; Mapping mapping; };
/// a where the surface's geometric normal is along the direction (unit, world space), b where it is across.
struct DirectionMixTexture { Input a, b; glm::dvec3 direction{0, 1, 0}; };
enum class NoisePattern { fbm, wrinkled, windy, marble };
struct NoiseTexture {
    NoisePattern pattern = NoisePattern::fbm;
    int octaves = 8;                   ///< not windy
    double roughness = 0.5;            ///< not windy
    double scale = 1, variation = 0.2; ///< marble
    Transform worldFromTexture{1};
};

/// Hair's color to its absorption, by its azimuthal roughness: made by the material "hair".
struct AbsorptionTexture { Input color, betaN; };
/// Coefficients, per world unit, to the diffuse albedo of a deep body of them. g: mean cosine of its phase function. albedos: in Scene::images, for its g and eta
/// (diffuse_albedo.h), one row. Made by the material "subsurface", as are free paths.
struct DiffuseAlbedoTexture { Input sigmaA, sigmaS; double g = 0; int albedos = none; };
/// Coefficients to the mean free path of reduced scattering, 1 / (sigma_a + (1 - g) sigma_s).
struct FreePathTexture { Input sigmaA, sigmaS; double g = 0; };

struct Texture {
    std::string name;
    bool isFloat = false;       ///< declared "float", not "spectrum"
    std::variant<ConstantTexture, ImagemapTexture, ScaleTexture, MixTexture, CheckerboardTexture, BilerpTexture, DotsTexture, DirectionMixTexture,
                 NoiseTexture, AbsorptionTexture, DiffuseAlbedoTexture, FreePathTexture> kind;
    SourceLocation where;
};

}  // namespace eikonal
