#pragma once
// Images and textures of a scene.

#include "error.h"
#include "scene/basics.h"
#include "color/spectrum.h"

#include <memory>
#include <string>
#include <variant>

namespace eikonal {

struct ImageData;   // read/formats/image.h

enum class ColorEncoding { automatic, srgb, linear };  ///< automatic: sRGB for integer files, linear for others
enum class WrapMode { repeat, black, clamp, octahedral };
enum class FilterMode { nearest, bilinear };

/// An image file of the scene. It is loaded when the scene is packed; the reader only checks that it exists.
struct ImageFile {
    std::string path;      ///< a path that can be opened from the working directory
    ColorEncoding encoding = ColorEncoding::automatic;
    double gamma = 0;      ///< > 0: decode with this power instead
    WrapMode wrap = WrapMode::repeat;
    FilterMode filter = FilterMode::bilinear;
    std::shared_ptr<const ImageData> pixels;  ///< made by the program; null: read `path`
    SourceLocation where;
    bool operator==(const ImageFile& other) const {
        return path == other.path && encoding == other.encoding && gamma == other.gamma && wrap == other.wrap && filter == other.filter &&
               pixels == other.pixels;
    }
};

/// A parameter: a value, or a texture. Numbers are spectra with equal channels.
struct Input {
    Spectrum value;        ///< if texture == none
    int texture = none;    ///< in Scene::textures
    SourceLocation where;  ///< where it was given; without a file: a default
};

enum class TextureMapping { uv, spherical, cylindrical, planar };

/// Maps surface points to texture coordinates.
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
/// Blends a, where the geometric normal is parallel to the direction (unit, world space), and b, where it is perpendicular.
struct DirectionMixTexture { Input a, b; glm::dvec3 direction{0, 1, 0}; };
enum class NoisePattern { fbm, wrinkled, windy, marble };
struct NoiseTexture {
    NoisePattern pattern = NoisePattern::fbm;
    int octaves = 8;                   ///< not for windy
    double roughness = 0.5;            ///< not for windy
    double scale = 1, variation = 0.2; ///< marble
    Transform worldFromTexture{1};
};

/// Absorption of hair from its colour and azimuthal roughness; made for the material "hair".
struct AbsorptionTexture { Input color, betaN; };
/// Diffuse albedo of a deep body from its coefficients per world unit. g: mean cosine of its phase function. albedos: in Scene::images, a
/// row of albedos for this g and eta (color/diffuse_albedo.h). Made for the material "subsurface", as FreePathTexture is.
struct DiffuseAlbedoTexture { Input sigmaA, sigmaS; double g = 0; int albedos = none; };
/// Mean free path of reduced scattering from coefficients: 1 / (sigma_a + (1 - g) sigma_s).
struct FreePathTexture { Input sigmaA, sigmaS; double g = 0; };

struct Texture {
    std::string name;
    bool isFloat = false;       ///< declared "float", not "spectrum"
    std::variant<ConstantTexture, ImagemapTexture, ScaleTexture, MixTexture, CheckerboardTexture, BilerpTexture, DotsTexture, DirectionMixTexture,
                 NoiseTexture, AbsorptionTexture, DiffuseAlbedoTexture, FreePathTexture> kind;
    SourceLocation where;
};

}  // namespace eikonal
