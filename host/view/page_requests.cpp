#include "view/page_requests.h"

#include "image/channels.h"
#include "json_text.h"
#include "split.h"
#include "view/token.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>

#include <arpa/inet.h>
#include <strings.h>

namespace eikonal {
namespace {

constexpr const char* json = "application/json";

struct PageFile {
    std::string_view name, text;
};
constexpr PageFile pageFiles[] = {
#include "page_files.inc"
};

constexpr std::pair<const char*, LiveRender::Wish> wishes[] = {{"pause", LiveRender::Wish::pause},
                                                               {"goOn", LiveRender::Wish::goOn},
                                                               {"stop", LiveRender::Wish::stop},
                                                               {"save", LiveRender::Wish::save},
                                                               {"end", LiveRender::Wish::end}};

std::string typeOf(std::string_view name) {
    if (name.ends_with(".html")) return "text/html; charset=utf-8";
    return name.ends_with(".css") ? "text/css; charset=utf-8" : "text/javascript; charset=utf-8";
}

HttpAnswer refusal(int status, const std::string& why) { return {.status = status, .body = why + "\n"}; }

std::optional<std::uint64_t> wholeNumber(const HttpRequest& request, const std::string& name) {
    const auto found = request.parameters.find(name);
    if (found == request.parameters.end()) return {};
    const std::string& text = found->second;
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || text.empty()) return {};
    return number;
}

bool isAddress(const std::string& name) {
    in6_addr address;
    return ::inet_pton(AF_INET, name.c_str(), &address) == 1 || ::inet_pton(AF_INET6, name.c_str(), &address) == 1;
}

/// "name:80" and "[::1]:80" without port and brackets.
std::string hostName(std::string host) {
    if (host.starts_with('[')) return host.substr(1, host.find(']') - 1);
    return host.substr(0, host.find(':'));
}

nlohmann::ordered_json namedSeconds(const NamedSeconds& all) {
    auto list = nlohmann::ordered_json::array();
    for (const auto& [name, seconds] : all) list.push_back({name, seconds});
    return list;
}

}  // namespace

bool isOwnHost(const std::string& host, const std::string& servedAddress) {
    const std::string name = hostName(host);
    if (::strcasecmp(name.c_str(), "localhost") == 0 || ::strcasecmp(name.c_str(), servedAddress.c_str()) == 0) return true;
    return isAddress(name);  // a page elsewhere has a name
}

HttpAnswer PageRequests::answer(const HttpRequest& request) const {
    if (!isOwnHost(request.host, servedAddress_)) return refusal(403, "this server has another name");
    const auto end = request.path.find('/', 1);
    if (end == std::string::npos || !request.path.starts_with('/') || !isSameToken(request.path.substr(1, end - 1), token_))
        return refusal(404, "there is nothing here: the address that the program has printed is longer");
    std::string name = request.path.substr(end + 1);
    if (name.empty()) name = "page.html";
    if (name == "wish") return request.method == "POST" ? wish(request) : refusal(405, "POST this");
    if (request.method != "GET" && request.method != "HEAD") return refusal(405, "GET this");
    for (const PageFile& file : pageFiles)
        if (file.name == name) return {200, typeOf(file.name), std::string(file.text)};
    if (name == "state") return state(request);
    if (name == "values") return values(request);
    if (name == "pixel") return pixel(request);
    return refusal(404, "there is no such thing");
}

HttpAnswer PageRequests::state(const HttpRequest& request) const {
    const auto known = wholeNumber(request, "after");
    if (request.parameters.contains("after") && !known) return refusal(400, "after: a whole number");
    const LiveState s = known ? render_.stateAfter(*known) : render_.state();
    nlohmann::ordered_json answer{{"number", s.number},
                                  {"image", s.imageNumber},
                                  {"scene", s.scene},
                                  {"phase", s.phase},
                                  {"hasEnded", s.hasEnded},
                                  {"fraction", s.fraction},
                                  {"seconds", s.seconds},
                                  {"secondsLeft", nullptr},
                                  {"samples", s.samples},
                                  {"samplesInAll", s.samplesInAll},
                                  {"metric", s.metric},
                                  {"doubt", s.doubt},
                                  {"targetError", nullptr},
                                  {"files", s.files},
                                  {"saves", s.saves},
                                  {"problem", s.problem},
                                  {"exposure", mapping_.exposure},
                                  {"steps", namedSeconds(s.steps)},
                                  {"stages", namedSeconds(s.stages)}};
    answer["curve"] = toneCurveNames()[static_cast<std::size_t>(mapping_.curve)];
    if (s.secondsLeft) answer["secondsLeft"] = *s.secondsLeft;
    if (s.targetError) answer["targetError"] = *s.targetError;
    auto& errors = answer["errors"] = nlohmann::ordered_json::array();
    for (const auto& e : s.errors) errors.push_back({e.seconds, e.error, e.low, e.high});
    auto& channels = answer["channels"] = nlohmann::ordered_json::array();
    if (s.image) {
        answer["size"] = {s.image->width, s.image->height};
        answer["bounds"] = {s.image->bounds.x0, s.image->bounds.x1, s.image->bounds.y0, s.image->bounds.y1};
        for (const auto& channel : channelsOf<const float>(*s.image)) channels.push_back(channel.name);
    }
    return {.type = json, .body = jsonText(answer)};
}

HttpAnswer PageRequests::values(const HttpRequest& request) const {
    const LiveState s = render_.state();
    if (!s.image) return refusal(409, "there is no image yet");
    const auto all = channelsOf<const float>(*s.image);
    const auto asked = request.parameters.find("channels");
    if (asked == request.parameters.end()) return refusal(400, "channels: names, separated by commas");
    const std::vector<std::string> names = split(asked->second, ',');
    if (names.size() > 4) return refusal(400, "at most four channels at a time");
    std::string bytes;
    bytes.reserve(names.size() * s.image->pixelCount() * sizeof(float));
    for (const std::string& name : names) {
        const auto channel = std::ranges::find(all, name, [](const auto& c) { return c.name; });
        if (channel == all.end()) return refusal(404, "there is no such channel");
        for (std::size_t i = 0; i < s.image->pixelCount(); ++i) {
            const float value = (*channel)[i];
            bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
        }
    }
    render_.noteLook(s.imageNumber);
    return {.type = "application/octet-stream", .body = std::move(bytes)};
}

HttpAnswer PageRequests::pixel(const HttpRequest& request) const {
    const LiveState s = render_.state();
    if (!s.image) return refusal(409, "there is no image yet");
    const auto x = wholeNumber(request, "x"), y = wholeNumber(request, "y");
    const PixelBounds& b = s.image->bounds;
    const auto isWithin = [](std::uint64_t v, int low, int high) {
        return v < std::uint64_t(high) && v >= std::uint64_t(std::max(low, 0));
    };
    if (!x || !y || !isWithin(*x, b.x0, b.x1) || !isWithin(*y, b.y0, b.y1)) return refusal(400, "x, y: a pixel of the image");
    nlohmann::ordered_json answer = nlohmann::ordered_json::object();
    const std::size_t i = s.image->index(static_cast<int>(*x), static_cast<int>(*y));
    for (const auto& channel : channelsOf<const float>(*s.image)) answer[channel.name] = channel[i];
    return {.type = json, .body = jsonText(answer)};
}

HttpAnswer PageRequests::wish(const HttpRequest& request) const {
    if (!request.origin.empty()) {
        const auto scheme = request.origin.find("://");
        if (scheme == std::string::npos || request.origin.substr(scheme + 3) != request.host) return refusal(403, "of another page");
    }
    const auto body = nlohmann::json::parse(request.body, nullptr, false);
    const auto member = body.is_object() ? body.find("wish") : body.end();
    if (!body.is_object() || body.size() != 1 || member == body.end() || !member->is_string())
        return refusal(400, R"(a wish is {"wish": "pause"}, or goOn, stop, save, end)");
    for (const auto& [name, wish] : wishes)
        if (*member == name) return render_.wish(wish) ? HttpAnswer{.type = json, .body = "{}"} : refusal(409, "not now");
    return refusal(400, "a wish is pause, goOn, stop, save or end");
}

}  // namespace eikonal
