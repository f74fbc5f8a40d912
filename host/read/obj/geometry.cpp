// Our own reader, because tinyobjloader silently accepts words that are not numbers or indices, and reports no line: docs/obj.md,
// tests/unit/tinyobjloader_test.cpp.

#include "read/obj/geometry.h"

#include "printable.h"
#include "read/mesh/polygon.h"
#include "read/obj/lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

namespace eikonal {
namespace {

class Parser {
public:
    Parser(std::string_view text, const std::shared_ptr<const std::string>& file, Diagnostics& diagnostics)
        : lines_(text, file), diagnostics_(diagnostics), hasObjects_(text.starts_with("o ") || text.find("\no ") != text.npos) {}

    ObjGeometry parse() {
        while (lines_.next()) parseLine(lines_.words()[0]);
        checkIndices();
        return std::move(geometry_);
    }

private:
    void parseLine(std::string_view keyword) {
        if (keyword == "v") parsePosition();
        else if (keyword == "vn") geometry_.normals.emplace_back(lines_.number(1), lines_.number(2), lines_.number(3));
        else if (keyword == "vt") geometry_.uvs.emplace_back(lines_.number(1), lines_.words().size() > 2 ? lines_.number(2) : 0);
        else if (keyword == "f" || keyword == "fo") parseFace();
        else if (keyword == "usemtl") parseMaterialName();
        else if (keyword == "o" || keyword == "g") { if ((keyword == "o") == hasObjects_) setGroup(lines_.rest(1), material_); }
        else if (keyword == "s") parseSmoothing();
        else if (keyword == "mtllib") parseLibraryName();
        else reportUnsupported(keyword);
    }

    void parsePosition() {
        geometry_.positions.emplace_back(lines_.number(1), lines_.number(2), lines_.number(3));
        if (lines_.words().size() >= 7)
            diagnostics_.unsupported("obj vertex colors", lines_.where(), "the colors of vertices are not rendered");
    }

    void parseFace() {
        const std::size_t count = lines_.words().size() - 1;
        if (!hasGroup_) setGroup(object_, material_);
        geometry_.faces.push_back({.firstCorner = static_cast<std::uint32_t>(geometry_.corners.size()),
                                   .cornerCount = static_cast<std::uint32_t>(count),
                                   .group = group_,
                                   .smoothing = smoothing_,
                                   .line = lines_.line()});
        for (std::size_t i = 1; i <= count; ++i) geometry_.corners.push_back(parseCorner(i));
    }

    /// Parses "p", "p/t", "p//n" or "p/t/n"; negative numbers count back from the last one defined.
    ObjCorner parseCorner(std::size_t i) const {
        const std::string_view word = lines_.words()[i];
        const std::array<std::size_t, 3> defined{geometry_.positions.size(), geometry_.uvs.size(), geometry_.normals.size()};
        std::array<int, 3> indices{-1, -1, -1};
        const char *at = word.data(), *end = at + word.size();
        for (std::size_t part = 0; part < 3 && at <= end; ++part, ++at) {
            int index = 0;
            if (part > 0 && (at == end || *at == '/')) continue;
            const auto [stop, error] = std::from_chars(at, end, index);
            if (error != std::errc{} || (stop != end && *stop != '/') || index == 0)
                throw SceneError(lines_.where(i),
                                 fmt::format("\"{}\" is not a corner of a face: position/texture/normal, numbered from 1", word));
            indices[part] = index > 0 ? index - 1 : static_cast<int>(defined[part]) + index;
            if (indices[part] < 0)
                throw SceneError(lines_.where(i), fmt::format("\"{}\" counts back beyond the first of {}", word, defined[part]));
            at = stop;
        }
        if (at <= end) throw SceneError(lines_.where(i), fmt::format("\"{}\" has more than three parts", word));
        return {indices[0], indices[1], indices[2]};
    }

    void parseMaterialName() {
        if (lines_.words().size() < 2)
            diagnostics_.unsupported("obj usemtl", lines_.where(0),
                                     "\"usemtl\" needs the name of a material; the faces after it have none");
        setGroup(object_, lines_.rest(1));
    }

    void parseLibraryName() {
        if (lines_.words().size() > 1) geometry_.libraries.push_back({lines_.rest(1), lines_.where(1)});
        else diagnostics_.unsupported("obj mtllib", lines_.where(0), "\"mtllib\" needs the name of a material library; it is skipped");
    }

    void parseSmoothing() {
        double value = 0;
        const bool isNumber = lines_.words().size() > 1 && parseNumber(lines_.words()[1], value);
        constexpr double most = std::numeric_limits<std::uint32_t>::max();
        smoothing_ = isNumber && value > 0                                    ? static_cast<std::uint32_t>(std::min(value, most))
                     : lines_.words().size() > 1 && lines_.words()[1] == "on" ? 1
                                                                              : 0;
    }

    void setGroup(const std::string& object, const std::string& material) {
        object_ = object;
        material_ = material;
        const auto [entry, isNew] = groups_.try_emplace({object, material}, static_cast<std::uint32_t>(geometry_.groups.size()));
        if (isNew) geometry_.groups.push_back({object, material, lines_.where()});
        group_ = entry->second;
        hasGroup_ = true;
    }

    void reportUnsupported(std::string_view keyword) {
        static const std::set<std::string_view> freeForm{"vp",    "cstype", "deg",  "bmat", "step", "curv", "curv2", "surf",
                                                         "parm",  "trim",   "hole", "scrv", "sp",   "end",  "con",   "mg",
                                                         "stech", "ctech",  "bsp",  "bzp",  "cdc",  "cdp",  "res"};
        static const std::set<std::string_view> harmless{"bevel",      "c_interp",  "d_interp", "lod",
                                                         "shadow_obj", "trace_obj", "maplib",   "usemap"};
        const auto report = [&](const std::string& kind, const std::string& message) {
            diagnostics_.unsupported("obj " + kind, lines_.where(), message);
        };
        if (keyword == "l") report("lines", "lines (\"l\") are not rendered");
        else if (keyword == "p") report("points", "points (\"p\") are not rendered");
        else if (freeForm.contains(keyword))
            report("free-form", fmt::format("free-form curves and surfaces (\"{}\") are not rendered", keyword));
        else if (!harmless.contains(keyword))
            report(std::string(keyword), quoteWord(keyword) + " is not a statement of an OBJ file");
    }

    /// Of a file without any `what`, which some programs number all the same: a warning at the first number.
    void leaveOut(int ObjCorner::*index, const char* what) {
        bool isFirst = true;
        for (const ObjFace& face : geometry_.faces)
            for (std::uint32_t i = 0; i < face.cornerCount; ++i) {
                const int number = std::exchange(geometry_.corners[face.firstCorner + i].*index, -1);
                if (number < 0 || !std::exchange(isFirst, false)) continue;
                diagnostics_.unsupported(std::string("obj without ") + what, lines_.whereBefore(face.line, i + 1),
                                         fmt::format("faces number their {0}, but there are no {0} in this file", what));
            }
    }

    /// Positive numbers may refer to later lines, so they are checked at the end. Throws SceneError.
    void checkIndices() {
        if (geometry_.uvs.empty()) leaveOut(&ObjCorner::uv, "texture coordinates");
        if (geometry_.normals.empty()) leaveOut(&ObjCorner::normal, "normals");
        for (const ObjFace& face : geometry_.faces)
            for (std::uint32_t i = 0; i < face.cornerCount; ++i) {
                const auto check = [&](int index, std::size_t count, const char* what) {
                    if (index >= static_cast<int>(count))
                        throw SceneError(lines_.whereBefore(face.line, i + 1),
                                         fmt::format("a face has {} {}, but there are {}", what, index + 1, count));
                };
                const ObjCorner& corner = geometry_.cornersOf(face)[i];
                check(corner.position, geometry_.positions.size(), "position");
                check(corner.uv, geometry_.uvs.size(), "texture coordinate");
                check(corner.normal, geometry_.normals.size(), "normal");
            }
    }

    ObjLines lines_;
    Diagnostics& diagnostics_;
    ObjGeometry geometry_;
    bool hasObjects_, hasGroup_ = false;
    std::string object_, material_;
    std::map<std::pair<std::string, std::string>, std::uint32_t> groups_;
    std::uint32_t group_ = 0, smoothing_ = 0;
};

/// The angle of a face at its corner i.
double angleAt(const ObjGeometry& geometry, const ObjFace& face, std::uint32_t i) {
    const auto position = [&](std::uint32_t k) {
        return geometry.positions[static_cast<std::size_t>(geometry.cornersOf(face)[k % face.cornerCount].position)];
    };
    const glm::dvec3 a = position(i + 1) - position(i), b = position(i + face.cornerCount - 1) - position(i);
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

glm::dvec3 unitNormal(const ObjGeometry& geometry, const ObjFace& face) {
    std::vector<glm::dvec3> polygon;
    for (std::uint32_t i = 0; i < face.cornerCount; ++i)
        polygon.push_back(geometry.positions[static_cast<std::size_t>(geometry.cornersOf(face)[i].position)]);
    const glm::dvec3 normal = polygonNormal(polygon);
    const double length = glm::length(normal);
    return length > 0 ? normal / length : glm::dvec3(0);
}

}  // namespace

ObjGeometry parseObj(std::string_view text, const std::shared_ptr<const std::string>& file, Diagnostics& diagnostics) {
    return Parser(text, file, diagnostics).parse();
}

void completeNormals(ObjGeometry& geometry) {
    // Smoothing groups: one new normal per position and group.
    std::unordered_map<std::uint64_t, int> smooth;
    for (const ObjFace& face : geometry.faces) {
        if (face.smoothing == 0) continue;
        const glm::dvec3 normal = unitNormal(geometry, face);
        for (std::uint32_t i = 0; i < face.cornerCount; ++i) {
            ObjCorner& corner = geometry.corners[face.firstCorner + i];
            if (corner.normal >= 0) continue;
            const std::uint64_t key = (static_cast<std::uint64_t>(face.smoothing) << 32) | static_cast<std::uint32_t>(corner.position);
            const auto [entry, isNew] = smooth.try_emplace(key, static_cast<int>(geometry.normals.size()));
            if (isNew) geometry.normals.emplace_back(0);
            corner.normal = entry->second;
            geometry.normals[static_cast<std::size_t>(corner.normal)] += angleAt(geometry, face, i) * normal;
        }
    }

    // Flat faces in groups where other corners have normals.
    std::vector<char> hasNormals(geometry.groups.size(), 0);
    for (const ObjFace& face : geometry.faces)
        for (std::uint32_t i = 0; i < face.cornerCount; ++i) hasNormals[face.group] |= geometry.cornersOf(face)[i].normal >= 0;
    for (const ObjFace& face : geometry.faces) {
        int flat = -1;
        for (std::uint32_t i = 0; hasNormals[face.group] && i < face.cornerCount; ++i) {
            ObjCorner& corner = geometry.corners[face.firstCorner + i];
            if (corner.normal >= 0) continue;
            if (flat < 0) {
                flat = static_cast<int>(geometry.normals.size());
                geometry.normals.push_back(unitNormal(geometry, face));
            }
            corner.normal = flat;
        }
    }
}

}  // namespace eikonal
