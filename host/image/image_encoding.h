#pragma once
// How an image becomes a file: the formats, and what each of them can hold.

#include "image/tone_map.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace eikonal {

/// Compression of OpenEXR; the numbers are those of the file format. pxr24, b44, b44a, dwaa and dwab change values.
enum class ExrCompression { none, rle, zips, zip, piz, pxr24, b44, b44a, dwaa, dwab };
/// The names for --compression.
inline constexpr std::pair<const char*, ExrCompression> exrCompressionNames[] = {
    {"none", ExrCompression::none}, {"rle", ExrCompression::rle},     {"zips", ExrCompression::zips}, {"zip", ExrCompression::zip},
    {"piz", ExrCompression::piz},   {"pxr24", ExrCompression::pxr24}, {"b44", ExrCompression::b44},   {"b44a", ExrCompression::b44a},
    {"dwaa", ExrCompression::dwaa}, {"dwab", ExrCompression::dwab}};

/// Spelling of the channels of an EXR (image/channels.h): ours, or that of pbrt-v4's film "gbuffer".
enum class ChannelNames { eikonal, pbrt };
/// The names for --channel-names.
inline constexpr std::pair<const char*, ChannelNames> channelNamesNames[] = {{"eikonal", ChannelNames::eikonal},
                                                                             {"pbrt", ChannelNames::pbrt}};

/// How an image becomes a file. Unset: what the format has by default.
struct ImageEncoding {
    std::string format;                         ///< the extension that names it, "exr"; empty: that of the file's name
    std::optional<ToneCurve> curve;             ///< integer formats; unset: clamp
    std::optional<double> exposure;             ///< integer formats, in stops; unset: 0
    std::optional<bool> halfFloats;             ///< exr: floats of 16 bits; unset: FilmImage::halfFloats
    std::optional<ExrCompression> compression;  ///< exr; unset: zip
    std::optional<ChannelNames> channelNames;   ///< exr; unset: eikonal
    std::optional<int> bits;                    ///< integer formats: 8 or 16; unset: the format's own
    bool recordsTime = false;                   ///< store Metadata::renderSeconds, so that no two files of a render are equal
    bool isShown = false;                       ///< a page (--view) also shows the image, tone-mapped

    ToneMapping toneMapping() const { return {curve.value_or(ToneCurve::clamp), exposure.value_or(0)}; }
};

enum class ImageContent { layers, linear, screen };  ///< all channels; linear colour; tone-mapped integers

struct ImageFormat {
    const char *extension, *name;  ///< name: OpenImageIO's
    ImageContent content;
    int mostPixels = 1 << 30;    ///< columns, and rows
    bool holdsNegatives = true;  ///< of `linear`
    int bits = 8, mostBits = 8;  ///< of `screen`: unless asked otherwise, and at most
};

/// The extensions that name a format.
std::vector<const char*> imageFormatNames();

/// The format of a file of this name; null: none that is known.
const ImageFormat* findImageFormat(const std::string& path, const ImageEncoding& encoding);

/// Why the name of a file tells no format, and the encoding names none; empty: there is one.
std::string unknownFormat(const std::string& path, const ImageEncoding& encoding = {});

/// The extension of an image whose name is ours to choose.
std::string chosenExtension(const ImageEncoding& encoding);

/// Whether writeImage stores channels besides colour in a file of this name.
bool holdsChannels(const std::string& path, const ImageEncoding& encoding = {});

/// Throws a UsageError that says what would work if the encoding asks for something that these files do not have: 16 bits where an integer
/// format has 8; what only an EXR has, without any EXR; bits or tone mapping of integers without any file of integers. Without any file:
/// if it asks for anything.
void checkEncoding(const std::vector<std::string>& files, const ImageEncoding& encoding);

}  // namespace eikonal
