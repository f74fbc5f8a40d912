#pragma once
// Parses material libraries (.mtl).

#include "diagnostics.h"

#include <glm/glm.hpp>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace eikonal {

/// The image of a map_... statement, with its options.
struct MtlTexture {
    std::string file;                        ///< without quotes; folders as written
    SourceLocation where;                    ///< the file's name
    glm::dvec2 scale{1}, offset{0};          ///< -s -o: texture coordinates are multiplied by scale, then moved by offset
    bool clamp = false;                      ///< -clamp on
    double bumpMultiplier = 1;               ///< -bm
    double base = 0, gain = 1;               ///< -mm: a value v becomes base + gain v
    std::vector<std::pair<std::string, SourceLocation>> ignored;  ///< unsupported options: "-t 1 1 1"
};

/// A material: its statements by lower-case keyword ("kd", "map_kd"); of repeated keywords, the last.
class MtlMaterial {
public:
    std::string name;
    SourceLocation where;

    struct Statement {
        std::string keyword;                   ///< as written
        std::vector<std::string> words;        ///< after the keyword
        std::string rest;                      ///< all of them
        SourceLocation where;                  ///< the keyword
        std::vector<SourceLocation> places{};  ///< of the words
    };
    std::map<std::string, Statement> statements;

    bool has(const std::string& keyword) const { return statements.contains(keyword); }
    SourceLocation whereIs(const std::string& keyword) const;
    /// A keyword as the file writes it ("Kd").
    const std::string& asWritten(const std::string& keyword) const { return statements.at(keyword).keyword; }

    /// The number or colour (one number: grey) after a keyword; nothing if it is absent. Throws SceneError if it is something else.
    std::optional<double> number(const std::string& keyword) const;
    std::optional<glm::dvec3> color(const std::string& keyword) const;
    std::optional<MtlTexture> texture(const std::string& keyword) const;
};

/// Parses a library. Skips, with a warning, statements before the first newmtl and materials without a name.
std::vector<MtlMaterial> parseMtl(std::string_view text, const std::shared_ptr<const std::string>& file, Diagnostics& diagnostics);

}  // namespace eikonal
