// The options of the commands that look at a scene, a device or the cache: info, bench, trade, cache, list-devices.

#include "app/options/declare.h"
#include "app/options/parser.h"
#include "app/options/shared_options.h"

namespace eikonal {

void declareMeasurements(Parser& parser) {
    Options& options = parser.options;
    auto* info = parser.add("info", Command::info, "Print the contents of a scene, and which features it requires and why");
    addScene(info, options);
    info->add_flag("--json", options.json, "Print JSON");
    addLogging(info, options);

    auto* bench = parser.add("bench", Command::bench, "Measure a scene, stage by stage");
    addScene(bench, options);
    bench->add_flag("--loop", options.loop, "Also measure a single kernel that follows each path in a loop, interleaved with the stages");
    bench->add_flag("--efficiency", options.efficiency,
                    "Also measure efficiency: each repeat has its own seed, and the variance between repeats is the error");
    bench
        ->add_option("--reference", options.reference,
                     "With --efficiency: a converged image that errors are relative to (default: the mean of the repeats)")
        ->type_name("IMAGE");
    value(bench, "--repeats", options.repeats, "N", "Number of renders; the median counts (default: 5)", integer(1, 1000));
    bench->add_option("--json", options.jsonFile, "Also write the figures into this file")->type_name("FILE");
    addDevice(bench, options);
    addLogging(bench, options);

    auto* trade = parser.add("trade", Command::trade, "Measure error and time of a scene under many settings, and recommend some");
    addScene(trade, options);
    trade->add_option("-o,--outfile", options.output.files, "The page; a CSV and a JSON are written beside it (default: SCENE-trade.html)")
        ->type_name("FILE.html")
        ->type_size(1)
        ->allow_extra_args(false);
    value(trade, "--budget", options.budget, "TIME", "Time for all measurements, such as 90s, 10m or 1h (default: 5m)", parseDuration);
    trade
        ->add_option_function<std::vector<std::string>>(
            "--for",
            [&options](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) options.wishes.push_back(parseWish("--for", text));
            },
            "A wish to recommend a command for: a time (30s) or an error (2%); may be repeated (default: 1s, 10s, 60s, 10%, 5%, 2%)")
        ->type_name("WISH")
        ->type_size(1)
        ->allow_extra_args(false);
    trade->add_flag("--compiler-flags", options.compilerFlags,
                    "Also try flags of the OpenCL compiler that are not strict, in all kernels and in each alone; takes long");
    addDevice(trade, options);
    addLogging(trade, options);

    auto* cache = parser.add("cache", Command::cache, "Print, warm or clear the cache of compiled kernels");
    cache->add_flag("--clear", options.clearCache, "Remove all compiled kernels");
    cache->add_flag("--warm", options.warmCache,
                    "Compile and keep the kernels of these scenes (default: of the scenes that come with the program); after --clear "
                    "if both are given");
    cache->add_option("SCENE", options.scenes, "Scenes for --warm")->type_name("");
    addDevice(cache, options);
    addLogging(cache, options);

    parser.add("list-devices", Command::listDevices, "Print the OpenCL devices");

    /* Internal command: see render/kernel_workers.h */
    auto* compile = parser.add("compile-kernels", Command::compileKernels, "Compile a part of the kernels")->group("");
    compile->add_option("FEATURES", options.compile.features);
    compile->add_option("CONSTANTS", options.compile.constants);
    compile->add_option("PART", options.compile.part);
    compile->add_option("PARTS", options.compile.parts)->check(CLI::PositiveNumber);
    compile->add_option("PARENT", options.compile.parent);
    addDevice(compile, options);
}

}  // namespace eikonal
