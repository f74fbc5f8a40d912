#include "read/pbrt/version3.h"

#include "kinds/camera_kind.h"

namespace eikonal::pbrt {
namespace {

struct Change { const char *noun, *name, *successor; };

constexpr const char* nothing = "nothing in its place";

constexpr Change changes[] = {
    {"directive", "WorldEnd", nothing},
    {"directive", "SurfaceIntegrator", "\"Integrator\""},
    {"directive", "VolumeIntegrator", "\"Integrator\""},
    {"directive", "Renderer", "\"Integrator\""},
    {"directive", "Volume", "\"MakeNamedMedium\""},
    {"material", "matte", "\"diffuse\""},
    {"material", "plastic", "\"coateddiffuse\""},
    {"material", "substrate", "\"coateddiffuse\""},
    {"material", "glass", "\"dielectric\""},
    {"material", "mirror", "\"conductor\""},
    {"material", "metal", "\"conductor\""},
    {"material", "uber", "\"coateddiffuse\""},
    {"material", "translucent", "\"diffusetransmission\""},
    {"material", "kdsubsurface", "\"subsurface\""},
    {"material", "disney", nothing},
    {"material", "fourier", "\"measured\""},
    {"film", "image", "\"rgb\""},
    {"sampler", "random", "\"independent\""},
    {"sampler", "02sequence", "\"paddedsobol\""},
    {"sampler", "lowdiscrepancy", "\"paddedsobol\""},
    {"sampler", "maxmindist", "\"pmj02bn\""},
    {"integrator", "directlighting", "\"direct\""},
    {"shape", "cone", nothing},
    {"shape", "hyperboloid", nothing},
    {"shape", "paraboloid", nothing},
    {"shape", "heightfield", nothing},
    {"shape", "heightfield2", nothing},
    {"shape", "nurbs", nothing},
    {"light", "exinfinite", "\"infinite\""},
    {"area light", "area", "\"diffuse\""},
    {"medium", "heterogeneous", "\"uniformgrid\""},
    {"texture", "uv", nothing},
    {"parameter", "mapname", "\"string filename\""},
    {"parameter", "Kd", "\"reflectance\""},
    {"parameter", "Kr", "\"reflectance\""},
    {"parameter", "Kt", "\"transmittance\""},
    {"parameter", "Ks", nothing},
    {"parameter", "bumpmap", "\"displacement\""},
    {"parameter", "trilinear", "\"string filter\""},
};

}  // namespace

std::optional<std::string> successorOf(const std::string& noun, const std::string& name) {
    for (const Change& change : changes)
        if (noun == change.noun && name == change.name) return change.successor;
    if (noun == "camera")
        for (const CameraKind& kind : cameraKindList())
            if (kind.traits.version3Name && name == kind.traits.version3Name) return '"' + std::string(kind.name) + '"';
    return std::nullopt;
}

}  // namespace eikonal::pbrt
