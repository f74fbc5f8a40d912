// A filtered lookup in an image file.

#include "kinds/texture_packing.h"
#include "kinds/texture_reading.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <optional>

namespace eikonal {

/// "gamma 2.2", "sRGB" or "linear", which pbrt-v4 reads for PNG files only. Says so where another file holds something else.
static void readEncoding(const pbrt::TextureReading& in, ImageFile& file) {
    const pbrt::Arguments& arguments = in.arguments;
    const std::string encoding = arguments.text("encoding");
    if (encoding.empty()) return;
    std::string ending = std::filesystem::path(file.path).extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
    const bool isPng = ending == ".png";
    if (encoding == "sRGB") {
        if (isPng) file.encoding = ColorEncoding::srgb;
    } else if (encoding == "linear") {
        if (isPng) file.encoding = ColorEncoding::linear;
    } else {
        const double gamma = encoding.starts_with("gamma ") ? std::atof(encoding.c_str() + 6) : 0;
        if (!(gamma > 0))
            throw SceneError(arguments.whereOf("encoding"),
                             "\"string encoding\" is \"" + encoding + "\"; it can be \"sRGB\", \"linear\" or \"gamma 2.2\"");
        if (isPng) file.gamma = gamma;
    }
    const bool isLinear = ending == ".exr" || ending == ".hdr" || ending == ".pfm";
    if (!isPng && encoding != (isLinear ? "linear" : "sRGB"))
        in.reading.unsupported("encoding of " + ending, arguments.whereOf("encoding"),
                               "\"string encoding\" \"" + encoding + "\" is ignored: only that of PNG files can be chosen, as in " +
                                   "pbrt-v4; this file is " + (isLinear ? "linear" : "sRGB"));
}

static bool read(const pbrt::TextureReading& in, Texture& texture) {
    const pbrt::Arguments& arguments = in.arguments;
    if (!arguments.has("filename")) throw SceneError(arguments.where(), "texture \"imagemap\" needs a \"string filename\"");
    std::optional<ImageFile> found = arguments.image("filename");
    if (!found) return false;
    ImageFile file = std::move(*found);
    constexpr image_wrap wraps[] = {wrap_repeat, wrap_black, wrap_clamp, wrap_octahedral};
    file.wrap = wraps[choose(arguments, "wrap")];
    file.filter = arguments.text("filter") == "point" ? filter_nearest : filter_bilinear;
    readEncoding(in, file);
    texture.image = in.textures.image(file);
    readMapping(in, texture);
    texture.scale = arguments.number("scale");
    texture.invert = arguments.flag("invert");
    return true;
}

static void pack(TexturePacking& into, const Texture& t, texture_instruction& i) {
    i.image = into.textures.image(t.image, t.isFloat);
    if (into.context.spectral && !t.isFloat) into.colors.addUplift();
    i.value = packNumber(t.scale);
    i.flags = (t.invert ? static_cast<uint>(texture_invert) : 0u) | (t.isFloat        ? static_cast<uint>(texture_number)
                                                                     : into.unbounded ? static_cast<uint>(texture_unbounded)
                                                                                      : 0u);
    packMapping(into, t.mapping, i);
    const image& image = into.textures.tables().images[i.image];
    if (t.mapping.kind == mapping_uv)
        into.addDetail({.uv = 1 / std::max(std::abs(t.mapping.uScale) * image.width, std::abs(t.mapping.vScale) * image.height)});
    if (t.scale < 0 || t.scale > 1 || image.format == format_float) into.leavesUnit = true;
}

const TextureTraits imagemap_texture{
    .parameters = {"file filename; string wrap = repeat in {repeat, black, clamp, octahedralsphere}; "
                   "string filter = bilinear in {point, bilinear, trilinear, ewa, EWA}; float maxanisotropy = 8; float scale = 1; "
                   "bool invert = false; string encoding",
                   pbrt::mappingParameters},
    .read = read, .pack = pack};

}  // namespace eikonal
