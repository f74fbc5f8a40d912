#pragma once
// A scene as it was described, before it is packed for a device: what the pbrt and OBJ readers produce and
// host/scene/pack turns into tables. Plain data; indices instead of pointers; -1 means "none".
// Positions and lengths are in world units, angles in degrees as the file gives them, matrices column-major (glm).

#include "error.h"
#include "scene/integrator.h"
#include "spectra/spectrum.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace eikonal {

constexpr int none = -1;

/// Maps points of a local space to world space. Double precision: the scene is moved to a space of its own when it is packed.
using Transform = glm::dmat4;

// ---- images and textures ------------------------------------------------------------------------------------------

struct ImageData;   // scene/image.h
struct Expression;  // scene/expression.h

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

struct Texture {
    std::string name;
    bool isFloat = false;       ///< declared "float", not "spectrum"
    std::variant<ConstantTexture, ImagemapTexture, ScaleTexture, MixTexture, CheckerboardTexture, BilerpTexture, DotsTexture, DirectionMixTexture,
                 NoiseTexture, AbsorptionTexture> kind;
    SourceLocation where;
};

// ---- materials ----------------------------------------------------------------------------------------------------

enum class MaterialKind {
    diffuse, coatedDiffuse, coatedConductor, conductor, dielectric, thinDielectric, diffuseTransmission, hair, measured, principled, subsurface, interface, mix
};

struct Medium;

/// How light leaves a body that it has entered: in the medium's own steps, or by a profile.
enum class SubsurfaceMethod { randomWalk, diffusion };
constexpr std::pair<const char*, SubsurfaceMethod> subsurfaceMethodNames[] = {{"randomwalk", SubsurfaceMethod::randomWalk}, {"diffusion", SubsurfaceMethod::diffusion}};

/// How much light leaves a body how far from where it has entered, by normalised diffusion (kernels/diffusion.clh).
struct DiffusionProfile {
    Spectrum albedo;    ///< share of the light that enters, in [0, 1]
    Spectrum length;    ///< d, world units
};

/// A material. `inputs` has every parameter of its kind under pbrt-v4's name, defaults filled in by the reader:
///   diffuse              reflectance
///   coatedDiffuse        reflectance uroughness vroughness thickness eta g albedo maxdepth nsamples
///   coatedConductor      uroughness vroughness thickness eta g albedo maxdepth nsamples (the coat's), metal_uroughness metal_vroughness,
///                        and either reflectance or both metal_eta and metal_k
///   conductor            uroughness vroughness, and either reflectance or both eta and k
///   dielectric           uroughness vroughness eta
///   thinDielectric       eta
///   diffuseTransmission  reflectance transmittance     ("scale" multiplied in)
///   hair                 sigma_a eta beta_m beta_n alpha h (-1 to 1 across the fiber)
///   measured             (`file`)
///   principled           base metallic eta uroughness vroughness coat coatroughness sheen  (no pbrt material: OBJ's)
///   subsurface           uroughness vroughness eta     (and `interior`, `diffusion`, `method`)
///   mix                  amount                        (the weight of mixed[1])
struct Material {
    MaterialKind kind = MaterialKind::diffuse;
    std::string name;                       ///< empty for an unnamed one
    std::map<std::string, Input> inputs;
    bool remapRoughness = true;             ///< roughness r gives microfacet width sqrt(r); otherwise r itself
    std::array<int, 2> mixed{none, none};   ///< mix: in Scene::materials
    std::shared_ptr<const Medium> interior; ///< subsurface: what light wanders in, homogeneous
    std::shared_ptr<const DiffusionProfile> diffusion;   ///< subsurface: what comes of that
    SubsurfaceMethod method = SubsurfaceMethod::diffusion;
    std::string file;                       ///< measured: as it can be opened from here
    int displacement = none;                ///< in Scene::textures: bump map
    int normalMap = none;                   ///< in Scene::images
    SourceLocation where;
};

// ---- media --------------------------------------------------------------------------------------------------------

/// Values on a regular grid, x fastest.
struct Grid {
    int nx = 1, ny = 1, nz = 1;
    std::vector<float> values;
};

/// Numbers on a sparse grid, in blocks of 8 x 8 x 8 voxels: what a VDB tree holds.
struct SparseGrid {
    glm::ivec3 low{0}, high{0};            ///< bounds, inclusive, of the voxels that may differ from 0
    glm::ivec3 firstBlock{0}, blocks{0};   ///< the blocks that hold them: block b is the voxels 8 b ... 8 b + 7
    std::vector<std::uint32_t> blockOf;    ///< x fastest: which 512 of `values`; empty: 0 everywhere
    std::vector<float> values;             ///< 512 for each stored block, x fastest; not negative
    Transform voxelFromMedium{1};          ///< to where voxel (i, j, k) has its value at the point (i, j, k)
    static constexpr std::uint32_t empty = 0xffffffffu;
};

/// Colours on a regular grid, x fastest; those that are not given are empty.
struct ColorGrid {
    int nx = 1, ny = 1, nz = 1;
    std::vector<glm::vec3> sigmaA, sigmaS, Le;
    ColorSpace space = ColorSpace::srgb;
};

enum class MediumKind { homogeneous, uniformGrid, rgbGrid, cloud, nanovdb };

struct Medium {
    MediumKind kind = MediumKind::homogeneous;
    std::string name;
    Spectrum sigmaA, sigmaS;       ///< per world unit, "scale" multiplied in; rgbGrid: that alone, for its colours to multiply
    Spectrum Le;                   ///< "Lescale" multiplied in, if it is one number
    double g = 0;
    glm::dvec3 p0{0}, p1{1};       ///< grids and clouds: their box in the medium's own space
    Transform worldFromMedium{1};

    Grid density;                  ///< uniformGrid
    Grid temperature, LeScale;     ///< uniformGrid: empty if not given
    std::shared_ptr<const SparseGrid> sparseDensity, sparseTemperature;  ///< nanovdb; the temperature may be null
    double temperatureOffset = 0, temperatureScale = 1;                  ///< kelvin = (temperature - offset) * scale
    double emissionScale = 1;      ///< of what shines by its temperature, or by the colours of a grid
    ColorGrid colors;              ///< rgbGrid
    double cloudDensity = 1, wispiness = 1, frequency = 5;               ///< cloud

    SourceLocation where;
};

// ---- shapes -------------------------------------------------------------------------------------------------------

/// A mesh of triangles (3 indices a face) or bilinear patches (4: corners (0,0) (1,0) (0,1) (1,1) in (u, v)).
struct Mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;      ///< one a position, or empty
    std::vector<glm::vec2> uvs;          ///< one a position, or empty
    std::vector<std::uint32_t> indices;
};

struct TriangleMesh { std::shared_ptr<const Mesh> mesh; };
struct BilinearMesh { std::shared_ptr<const Mesh> mesh; };
struct Sphere { double radius = 1, zMin = -1, zMax = 1, phiMax = 360; };
struct Disk { double radius = 1, innerRadius = 0, height = 0, phiMax = 360; };
struct Cylinder { double radius = 1, zMin = -1, zMax = 1, phiMax = 360; };  ///< without caps

enum class CurveKind { flat, cylinder, ribbon };
/// A cubic Bezier curve. Its width and, on ribbons, its normal go from one end's to the other's.
struct CurveSegment {
    std::array<glm::vec3, 4> points;
    std::array<double, 2> width;
    std::array<glm::vec3, 2> normals;   ///< ribbons: of any length but zero
};
struct Curve {
    CurveKind kind = CurveKind::flat;
    std::vector<CurveSegment> segments;
    int splitDepth = 3;                 ///< each segment is 2^splitDepth elements, or more if it bends
};
struct CurveShape { std::shared_ptr<const Curve> curve; };

/// Where F is 0, within a box in object space. Inside is where F < 0.
struct ImplicitSurface { std::shared_ptr<const Expression> F; glm::dvec3 low, high; };

struct MediumInterface { int inside = none, outside = none; };  ///< in Scene::media; none: vacuum

struct Shape {
    std::variant<TriangleMesh, BilinearMesh, Sphere, Disk, Cylinder, CurveShape, ImplicitSurface> kind;
    Transform worldFromObject{1};
    std::optional<Transform> worldFromObjectAtEnd;  ///< set: it moves, and is there at Scene::motionEnd
    bool reverseOrientation = false;
    int material = none;                          ///< in Scene::materials; none: pbrt's default, diffuse 0.5
    Input alpha{Spectrum::constant(1)};           ///< probability that a ray meets the shape at all
    int areaLight = none;                         ///< in Scene::areaLights
    std::optional<MediumInterface> interface;     ///< given explicitly; otherwise a ray keeps its medium
    SourceLocation where;
};

/// A named group of shapes that is only seen where it is instanced. Its shapes' transforms are relative to the instance.
struct Object { std::string name; std::vector<Shape> shapes; SourceLocation where; };
struct Instance {
    int object = none;
    Transform worldFromObject{1};
    std::optional<Transform> worldFromObjectAtEnd;  ///< set: it moves, and is there at Scene::motionEnd
    SourceLocation where;
};

// ---- lights -------------------------------------------------------------------------------------------------------

/// Intensity and radiance: spectrum * scale.
struct PointLight { Spectrum I; glm::dvec3 from{0}; };
struct SpotLight { Spectrum I; glm::dvec3 from{0}, to{0, 0, 1}; double coneAngle = 30, coneDeltaAngle = 5; };
/// A point whose intensity is I times an image over the sphere of directions (square, equal-area), whose +z is +y of light space.
struct GoniometricLight { Spectrum I; int image = none; };
/// A slide in front of a point, projected along +z of light space, its top at +y; fov: degrees that its shorter side spans.
struct ProjectionLight { int image = none; double fov = 90; };
struct DistantLight { Spectrum L; glm::dvec3 from{0}, to{0, 0, 1}; };
struct ConstantInfiniteLight { Spectrum L; };
/// An image over the sphere of directions, square, in the equal-area octahedral mapping of Clarberg 2008.
struct ImageInfiniteLight { int image = none; };
/// An infinite light as far as it comes in through a rectangle: world space, not moved by worldFromLight. From corner 0, x runs to
/// corner 3 and y to corner 1; x cross y points out of the room. L everywhere, or an image as above.
struct PortalInfiniteLight { Spectrum L; int image = none; std::array<glm::dvec3, 4> portal; };

struct Light {
    std::variant<PointLight, SpotLight, GoniometricLight, ProjectionLight, DistantLight, ConstantInfiniteLight, ImageInfiniteLight, PortalInfiniteLight> kind;
    double scale = 1;
    std::optional<double> power;          ///< goniometric, projection: what is emitted in all, where the image is taken as it is
    std::optional<double> illuminance;    ///< infinite with an image: lux on a surface that faces the image's +z
    Transform worldFromLight{1};
    SourceLocation where;
};

/// What makes a shape emit.
struct AreaLight {
    Spectrum L;
    int image = none;                     ///< in Scene::images: L is multiplied by it
    Mapping imageMapping;                 ///< of the image: from the shape's (u, v)
    double scale = 1;
    std::optional<double> power;
    bool twoSided = false;
    SourceLocation where;
};

// ---- camera, film, sampling -----------------------------------------------------------------------------------------

enum class CameraKind { perspective, orthographic, spherical, realistic };

/// One interface of a lens, from the scene to the film; millimetres.
struct LensElement {
    double curvatureRadius = 0;   ///< > 0: convex towards the scene; 0: the aperture stop
    double thickness = 0;         ///< to the next element; the last one: to the film, until it is focused
    double eta = 1;               ///< index of refraction behind it; 0 as 1
    double apertureDiameter = 0;
};

enum class ApertureShape { round, gaussian, square, pentagon, star, image };

struct CameraDescription {
    CameraKind kind = CameraKind::perspective;
    Transform worldFromCamera{1};                        ///< camera space: x right, y up, looking along +z
    double fov = 90;                                     ///< degrees, along the shorter side of the image
    std::optional<double> frameAspectRatio;
    std::optional<std::array<double, 4>> screenWindow;   ///< x0 x1 y0 y1
    std::optional<Transform> worldFromCameraAtEnd;       ///< set: it moves, and is there at Scene::motionEnd
    double lensRadius = 0, focalDistance = 1e6;
    bool equalArea = true;                               ///< spherical: its mapping; otherwise longitude and latitude
    std::vector<LensElement> lens;                       ///< realistic
    double apertureDiameter = 1;                         ///< realistic: of the stop, millimetres
    double focusDistance = 10;                           ///< realistic: in camera space, metres
    ApertureShape aperture = ApertureShape::round;       ///< realistic
    int apertureImage = none;                            ///< realistic: in Scene::images
    double shutterOpen = 0, shutterClose = 1;
    int medium = none;                                   ///< around the camera, in Scene::media
    SourceLocation where;
};

struct PixelBounds { int x0 = 0, x1 = 0, y0 = 0, y1 = 0; };  ///< x0 <= x < x1

struct FilmDescription {
    int width = 1280, height = 720;
    std::optional<std::array<double, 4>> cropWindow;     ///< x0 x1 y0 y1 in [0, 1]
    std::optional<PixelBounds> pixelBounds;
    std::string filename;                                ///< empty: from the scene's name
    double diagonal = 35;                                ///< of a realistic camera's film, millimetres
    double iso = 100, exposureTime = 1, whiteBalance = 0;
    std::string sensor = "cie1931";                      ///< with iso, exposureTime and whiteBalance: spectra/sensor.h
    ColorSpace colorSpace = ColorSpace::srgb;            ///< of the image
    double maxComponentValue = 0;                        ///< > 0: samples are scaled down to it
    SourceLocation where;
};

enum class FilterKind { box, triangle, gaussian, mitchell, sinc };

struct FilterDescription {
    FilterKind kind = FilterKind::gaussian;
    double xRadius = 1.5, yRadius = 1.5;
    double sigma = 0.5;                  ///< gaussian
    double B = 1. / 3, C = 1. / 3;       ///< mitchell
    double tau = 3;                      ///< sinc
    SourceLocation where;
};

enum class SamplerKind { independent, sobol };

struct SamplerDescription { SamplerKind kind = SamplerKind::sobol; int pixelSamples = 16; int seed = 0; SourceLocation where; };

/// How colours are carried: as linear sRGB, or at wavelengths. automatic: at wavelengths where the scene needs them (pack/color_mode.h).
enum class ColorMode { automatic, rgb, spectral };

// ---- the scene ----------------------------------------------------------------------------------------------------

struct Scene {
    std::string name;                    ///< the file's name without folder and extension
    CameraDescription camera;
    FilmDescription film;
    FilterDescription filter;
    SamplerDescription sampler;
    IntegratorDescription integrator;
    ColorMode colorMode = ColorMode::automatic;
    std::vector<Shape> shapes;
    std::vector<Object> objects;
    std::vector<Instance> instances;
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::vector<ImageFile> images;
    std::vector<Medium> media;
    std::vector<Light> lights;
    std::vector<AreaLight> areaLights;
    double motionStart = 0, motionEnd = 1;   ///< between these times everything moves that does; start < end
};

}  // namespace eikonal
