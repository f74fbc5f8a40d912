#pragma once
// Images and textures of a scene.

#include "eikonal/texture.h"
#include "error.h"
#include "scene/basics.h"
#include "color/spectrum.h"

#include <memory>
#include <string>
#include <vector>

namespace eikonal {

struct ImageData;     // image/image_data.h
struct TextureKind;   // kinds/texture_kind.h

enum class ColorEncoding { automatic, srgb, linear };  ///< automatic: sRGB for integer files, linear for others

/// An image file of the scene. It is loaded when the scene is packed; the reader only checks that it exists.
struct ImageFile {
    std::string path;      ///< a path that can be opened from the working directory
    ColorEncoding encoding = ColorEncoding::automatic;
    double gamma = 0;      ///< > 0: decode with this power instead
    image_wrap wrap = wrap_repeat;
    image_filter filter = filter_bilinear;
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

/// Maps surface points to texture coordinates.
struct Mapping {
    texture_mapping kind = mapping_uv;
    double uScale = 1, vScale = 1, uOffset = 0, vOffset = 0;  ///< uv, planar: applied last
    glm::dvec3 planeU{1, 0, 0}, planeV{0, 1, 0};              ///< planar: "v1", "v2"
    Transform worldFromTexture{1};                            ///< spherical, cylindrical, planar
};

/// A texture of one of the kinds of TEXTURES (include/eikonal/textures.h). Each kind uses a part of the fields (host/kinds/texture/).
struct Texture {
    const TextureKind* kind = nullptr;
    std::string name;
    bool isFloat = false;              ///< declared "float", not "spectrum"
    SourceLocation where;

    std::vector<Input> operands;       ///< in the order of the kind's line in TEXTURES; constant: its value
    Mapping mapping;                   ///< solid textures use its worldFromTexture alone
    double scale = 1;                  ///< imagemap: of its values; marble: of space

    int image = none;                  ///< imagemap, diffusealbedo: in Scene::images
    bool invert = false;               ///< imagemap
    int dimensions = 2;                ///< checkerboard
    glm::dvec3 direction{0, 1, 0};     ///< directionmix: unit vector, world space
    int octaves = 8;                   ///< fbm, wrinkled, marble
    double roughness = 0.5;            ///< fbm, wrinkled, marble
    double variation = 0.2;            ///< marble
    double g = 0;                      ///< diffusealbedo, freepath: mean cosine of the body's phase function
};

}  // namespace eikonal
