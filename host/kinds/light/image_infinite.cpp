// Infinite light with an image: square, in the equal-area octahedral mapping of Clarberg 2008 (kernels/light/image_infinite.clh).

#include "color/luminance.h"
#include "kinds/light_packing.h"
#include "pack/alias_table.h"

#include <cmath>

namespace eikonal {

/// Adds the texels' radiance to a light, and alias tables that choose a row and a texel in the row. Returns the mean luminance.
static double addTexels(const LightPacking& in, const ImageData& image, const Light& d, light& l) {
    const int n = image.width;
    double scale = d.scale, sum = 0;
    std::vector<glm::vec3> texels;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) texels.emplace_back(texelOf(image, x, y));
    if (d.illuminance) scale *= *d.illuminance / upwardIlluminance(image);
    std::vector<double> weights;
    for (glm::vec3& t : texels) {
        t = {static_cast<float>(t.r * scale), static_cast<float>(t.g * scale), static_cast<float>(t.b * scale)};
        weights.push_back((t.r + t.g + t.b) / 3);
        sum += luminance(t);
    }
    const Table<alias_entry> aliases = makeAliasSquare(weights, static_cast<size_t>(n));
    Table<alias_entry>& table = in.tables.environment_aliases;
    l.first_alias = static_cast<uint>(table.size());
    table.insert(table.end(), aliases.begin(), aliases.end());
    l.first_texel = packTexels(in, texels);
    return sum / (static_cast<double>(n) * n);
}

static PackedLight pack(const LightPacking& in, const Light& d) {
    const ImageData& image = sphereImage(in.context, d);
    light l = newLight(kind_image_infinite_light, in.colors.white());
    l.resolution = static_cast<uint>(image.width);
    const glm::dmat3 m = rotationOf(in.context, d);
    l.a = toVec3(m[0]); l.b = toVec3(m[1]); l.n = toVec3(m[2]);
    const double mean = addTexels(in, image, d, l);
    return {l, 4 * M_PI * M_PI * sceneRadius(in.context) * sceneRadius(in.context) * mean};
}

const LightTraits image_infinite_light{.pack = pack};

}  // namespace eikonal
