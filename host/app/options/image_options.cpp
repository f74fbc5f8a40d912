// The options of the commands that take images or parts of images: compare, denoise, merge.

#include "app/options/declare.h"
#include "app/options/parser.h"
#include "app/options/shared_options.h"

namespace eikonal {

/// Names of compressions, separated by commas.
static std::string listOf(size_t first, size_t end) {
    std::string list;
    for (size_t i = first; i < end; ++i) list += (list.empty() ? "" : ", ") + std::string(exrCompressionNames[i].first);
    return list;
}

void addEncoding(CLI::App* app, OutputOptions& out) {
    const std::string group = imageGroup;
    std::vector<std::pair<const char*, std::string>> formats;
    for (const char* name : imageFormatNames()) formats.emplace_back(name, name);
    value(app, "--format", out.encoding.format, "NAME", "Format of the image, whatever its name ends with; `-o -` needs it",
          oneOf<std::string>(std::move(formats)))
        ->group(group);
    static const std::vector<std::string> curveNames = toneCurveNames();
    std::vector<std::pair<const char*, ToneCurve>> curves;
    for (const std::string& name : curveNames) curves.emplace_back(name.c_str(), toneCurve(name));
    value(app, "--tonemap", out.encoding.curve, "NAME", "For integer formats: clamp (default), reinhard, filmic",
          oneOf<ToneCurve>(std::move(curves)))
        ->group(group);
    value(app, "--bit-depth", out.encoding.bits, "N", "For integer formats: bits of a channel, 8 or 16 (default: 16 for tif, else 8)",
          oneOf<int>({{"8", 8}, {"16", 16}}))
        ->group(group);
    value(app, "--pixel-type", out.encoding.halfFloats, "NAME",
          "For EXR: float, 32 bits (default); half, 16 bits for colours and normals, with --channel-names pbrt for all channels",
          oneOf<bool>({{"float", false}, {"half", true}}))
        ->group(group);
    value(app, "--compression", out.encoding.compression, "NAME",
          fmt::format("For EXR: {}, zip (default), {}; the last five change values", listOf(0, 3), listOf(4, 10)),
          oneOf<ExrCompression>({std::begin(exrCompressionNames), std::end(exrCompressionNames)}))
        ->group(group);
    value(app, "--channel-names", out.encoding.channelNames, "NAME",
          "For EXR: eikonal (default), or pbrt: those of pbrt-v4's film gbuffer, for programs that read its files",
          oneOf<ChannelNames>({std::begin(channelNamesNames), std::end(channelNamesNames)}))
        ->group(group);
    app->add_flag("--record-time", out.encoding.recordsTime,
                  "Store the seconds of rendering in the file, so that two runs write different ones")
        ->group(group);
    value(app, "--exposure", out.encoding.exposure, "STOPS", "For integer formats: 1 is twice as bright", number(-infinity))
        ->group(group);
}

void addImageFiles(CLI::App* app, OutputOptions& out) {
    const std::string group = imageGroup;
    app->add_option("-o,--outfile", out.files,
                    "An image file: exr, hdr, pfm, png, jpg, tif, tga, bmp, webp; may be repeated. A single EXR is accompanied by a PNG; "
                    "film: a part for merge; FOLDER/: a file in it, named like the scene; -: standard output "
                    "(default: the scene's name with .exr)")
        ->type_name("FILE")
        ->type_size(1)
        ->allow_extra_args(false)
        ->group(group);
    addEncoding(app, out);
}

CLI::Option* addAov(CLI::App* app, OutputOptions& out) {
    std::vector<std::string> channels;
    for (const AovName& each : aovNames) channels.emplace_back(each.name);
    auto* aov = value(app, "--aov", out.aovs, "NAMES",
                      fmt::format("Additional channels of an EXR: {}, separated by commas; passes: emission, direct, indirect, volume; "
                                  "cryptomatte: both layers of Cryptomatte; all: all but lightgroups and cryptomatte",
                                  fmt::join(channels, ", ")),
                      parseAovs);
    channels.emplace_back("passes");
    channels.emplace_back("cryptomatte");
    channels.emplace_back("all");
    return offer(aov, channels);
}

void addTilesBy(CLI::App* app, OutputOptions& out) {
    value(app, "--tiles-by", out.tilesBy, "NAME",
          "What parts of the image have alike: rows (default), or cost, estimated by rays, so that they take about the same time",
          oneOf<TilesBy>({std::begin(tilesByNames), std::end(tilesByNames)}))
        ->group(partsGroup);
}

CLI::Option* addCheckpointInterval(CLI::App* app, OutputOptions& out) {
    return value(app, "--checkpoint-every", out.checkpointEvery, "TIME", "How often to write the checkpoint and the image (default: 5m)",
                 parseDuration)
        ->group(partsGroup);
}

void declareImageCommands(Parser& parser) {
    Options& options = parser.options;
    auto* compare = parser.add("compare", Command::compare, "Print the difference of two images");
    compare->add_option("IMAGE", options.image, "An image file")->type_name("");
    compare->add_option("REFERENCE", options.reference, "The image to compare with")->type_name("");
    compare->add_flag("--json", options.json, "Print JSON");
    compare->add_flag("--scatter", options.scatter,
                      "Estimate standard errors from the spread of the differences in each block, not from the image's variance");
    compare->add_option("--heat-map", options.heatMap, "Write the FLIP of each pixel as an image: black is equal, light yellow is 1")
        ->type_name("FILE");
    value(compare, "--fail-above", options.failAbove, "X", "Exit with status 1 if the mean FLIP is above X", numberFrom(0, 1));

    auto* denoise = parser.add("denoise", Command::denoise, "Remove noise from an image, with Intel Open Image Denoise");
    denoise->add_option("IMAGE", options.image, "An image file; layers albedo and N of an EXR help")->type_name("");
    denoise->add_option("-o,--outfile", options.output.files, "An image file; may be repeated (default: IMAGE-denoised.exr)")
        ->type_name("FILE")
        ->type_size(1)
        ->allow_extra_args(false);
    addEncoding(denoise, options.output);
    value(denoise, "--nthreads", options.device.threads, "N", "Threads (default: one per core)", integer(1, 4096));

    auto* merge = parser.add("merge", Command::merge, "Make one image of parts that were rendered apart");
    merge->add_option("PART", options.parts, "Film files of render: --samples, --tile, -o PART.film")->type_name("");
    addImageFiles(merge, options.output);
    merge->add_flag("--partial", options.isPartial, "Samples and pixels may be missing");
    addLogging(merge, options);
}

}  // namespace eikonal
