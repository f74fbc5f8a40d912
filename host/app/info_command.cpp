#include "app/commands.h"
#include "app/output.h"
#include "available_memory.h"
#include "json_text.h"
#include "printable.h"
#include "pack/missed_light.h"
#include "render/session.h"
#include "app/statistics.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>

namespace eikonal {
namespace {

struct Count { const char *key, *name; size_t value; };

std::vector<Count> countsOf(const SceneCounts& c) {
    return {{"triangles", "triangles", c.triangles},
            {"patches", "bilinear patches", c.patches},
            {"quadrics", "spheres, disks and cylinders", c.quadrics},
            {"curves", "segments of curves", c.curves},
            {"implicits", "implicit surfaces", c.implicits},
            {"objects", "objects", c.objects},
            {"instances", "instances", c.instances},
            {"lights", "lights", c.lights},
            {"materials", "materials", c.materials},
            {"textures", "textures", c.textures},
            {"images", "images", c.images},
            {"media", "media", c.media}};
}

std::string asText(const Options& o, const PackedScene& packed, const MemoryPlan& plan) {
    const PixelRect& r = packed.pixels;
    const settings& frame = packed.frame();
    std::string text = fmt::format("{}\n  image      {} x {}", o.scene.path, frame.width, frame.height);
    if (r.width() != static_cast<int>(frame.width) || r.height() != static_cast<int>(frame.height))
        text += fmt::format(", only {} <= x < {}, {} <= y < {}", r.x0, r.x1, r.y0, r.y1);
    text += fmt::format("\n  sampling   {} samples per pixel, at most {} bounces\n  contents   ", packed.samples, frame.max_depth);
    bool first = true;
    for (const Count& c : countsOf(packed.counts)) {
        if (c.value == 0) continue;
        text += fmt::format("{}{} {}", first ? "" : ", ", c.value, c.name);
        first = false;
    }
    if (first) text += "nothing";
    text += fmt::format("\n  color      {}: {}", nameOf(packed.color), packed.color.why);
    for (const std::string& missed : missedLight(packed)) text += "\n  hard light " + missed;
    text += fmt::format("\n  hierarchy  {} levels, built in {:.2f} s\n  memory     {}; at most {} in all\n  requires\n",
                        packed.counts.bvhDepth,
                        packed.counts.buildSeconds, describe(plan),
                        readableBytes(static_cast<double>(mostMemory(plan, occupiedMemory()))));
    for (const auto& [feature, why] : packed.reasons)
        text += fmt::format("    {:<22} {}{}\n", featureName(feature), featureReason(feature), why.empty() ? "" : "  (" + why + ")");
    return text;
}

nlohmann::ordered_json asJson(const Options& o, const PackedScene& packed, const MemoryPlan& plan) {
    nlohmann::ordered_json json;
    json["scene"] = o.scene.path;
    json["sceneHash"] = sceneHash(packed);
    json["width"] = packed.frame().width;
    json["height"] = packed.frame().height;
    json["pixelBounds"] = {packed.pixels.x0, packed.pixels.x1, packed.pixels.y0, packed.pixels.y1};
    json["samples"] = packed.samples;
    json["maxDepth"] = packed.frame().max_depth;
    for (const Count& c : countsOf(packed.counts)) json["counts"][c.key] = c.value;
    json["color"] = {{"mode", nameOf(packed.color)}, {"why", packed.color.why}};
    json["hardLight"] = missedLight(packed);
    json["memory"] = {{"tables", plan.tables}, {"queues", plan.queues}, {"vertices", plan.vertices}, {"film", plan.film},
                      {"most", mostMemory(plan, occupiedMemory())}};
    json["features"] = nlohmann::ordered_json::array();
    for (const auto& [feature, why] : packed.reasons)
        json["features"].push_back({{"name", featureName(feature)}, {"meaning", featureReason(feature)}, {"firstUse", why}});
    return json;
}

}  // namespace

int infoCommand(const Options& o) {
    Diagnostics diagnostics(o.log, o.scene.strict);
    Session session(o, diagnostics);
    session.load(false);
    session.pack(aovsOf(o.output, session.scene().film, {}, diagnostics));
    const std::string text =
        o.json ? jsonText(asJson(o, session.packed(), session.plan()), 2) + "\n" : asText(o, session.packed(), session.plan());
    std::fputs(printable(text).c_str(), stdout);
    return static_cast<int>(ExitCode::success);
}

}  // namespace eikonal
