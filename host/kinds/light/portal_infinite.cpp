// Infinite light seen through a rectangular portal: an image, or the same radiance from all directions (kernels/light/portal_infinite.clh).

#include "image/equal_area.h"
#include "kinds/light_packing.h"
#include "pack/portal.h"

#include <cmath>

namespace eikonal {

/// Bilinear interpolation. Beyond an edge it continues where the octahedral mapping does.
static glm::dvec3 lookUp(const ImageData& image, glm::dvec2 square) {
    const int n = image.width;
    const auto texel = [&](int x, int y) {
        const glm::ivec2 wrapped = wrapTexelOfSquare({x, y}, n);
        return texelOf(image, wrapped.x, wrapped.y);
    };
    const double s = square.x * n - 0.5, t = square.y * n - 0.5;
    const int x = static_cast<int>(std::floor(s)), y = static_cast<int>(std::floor(t));
    return glm::mix(glm::mix(texel(x, y), texel(x + 1, y), s - x), glm::mix(texel(x, y + 1), texel(x + 1, y + 1), s - x), t - y);
}

/// A portal lights what lies behind it, where its normal n does not point. Warns if the camera and the middle of the scene lie before it.
static void warnOfWrongSide(const PackContext& context, const Light& d, glm::dvec3 n) {
    const auto liesBefore = [&](glm::dvec3 p) { return glm::dot(n, p - d.portal[0]) > 0; };
    if (context.bounds.empty() || !liesBefore(context.bounds.center())) return;
    if (!liesBefore(transformPoint(context.scene.camera.worldFromCamera, glm::dvec3(0)))) return;
    context.diagnostics.warn(d.where,
                             "the portal lets light through to the side where the camera and the middle of the scene are not; with its "
                             "corners in the reverse order it would let it through to theirs");
}

static PackedLight pack(const LightPacking& in, const Light& d) {
    const ImageData* image = d.image == none ? nullptr : &sphereImage(in.context, d);
    const glm::dvec3 x = glm::normalize(d.portal[3] - d.portal[0]), y = glm::normalize(d.portal[1] - d.portal[0]), n = glm::cross(x, y);
    warnOfWrongSide(in.context, d, n);
    const glm::dmat3 lightFromPortal = glm::transpose(image ? rotationOf(in.context, d) : glm::dmat3(1)) * glm::dmat3(x, y, n);
    const auto radianceFrom = [&](glm::dvec3 w) {
        return image ? lookUp(*image, squareFromDirection(lightFromPortal * w)) : glm::dvec3(1);
    };
    const PortalImage portal = makePortalImage(image ? image->width : 1, radianceFrom);
    const double scale = d.scale * (image && d.illuminance ? *d.illuminance / upwardIlluminance(*image) : 1);
    light l = newLight(kind_portal_infinite_light, image ? in.colors.white(scale) : in.colors.emission(d.spectrum, scale));
    l.a = toVec3(x); l.b = toVec3(y); l.n = toVec3(n);
    l.p = toVec3(transformPoint(in.context.space.sceneFromWorld(), d.portal[0]));
    l.c = toVec3(transformPoint(in.context.space.sceneFromWorld(), d.portal[2]));
    l.resolution = static_cast<uint>(portal.resolution);
    l.first_texel = packTexels(in, {portal.texels.begin(), portal.texels.end()});
    l.first_sum = static_cast<uint>(in.tables.portal_sums.size());
    in.tables.portal_sums.insert(in.tables.portal_sums.end(), portal.sums.begin(), portal.sums.end());
    in.context.require(Feature::PORTALS, d.where.toString());
    const double area =
        glm::length(d.portal[3] - d.portal[0]) * glm::length(d.portal[1] - d.portal[0]) * in.context.space.scale * in.context.space.scale;
    return {l, area * portal.fluence * (image ? scale : luminanceOf(d.spectrum, scale))};
}

const LightTraits portal_infinite_light{.pack = pack, .startsPaths = false};

}  // namespace eikonal
