#pragma once
// What a directive accepts. Every kind of material, light, shape ... is one row of a table: its name, what it becomes, its
// parameters with their types and defaults, and what stands in for it as long as it is not rendered.

#include "read/pbrt/parameters.h"

#include <optional>
#include <string>
#include <vector>

namespace eikonal::pbrt {

/// What a parameter is read as. The words for them in a row, and the types that each accepts, are listed in kinds.cpp.
enum class Wanted {
    flag, number, numbers, integer, integers, text, texts, file, point2s, point3, point3s, vector3, vector3s, normals,
    floatMap,     ///< a float or a float texture
    colorMap,     ///< a reflectance or a spectrum texture: rgb in [0, 1]
    spectrumMap,  ///< a coefficient or a spectrum texture: rgb not negative
    spectrum,     ///< a spectrum; no texture
    colors,       ///< any number of rgb colours
    index,        ///< a float or a spectrum; no texture
    floatTexture, ///< the name of a float texture
};

/// Which numbers mean something.
struct Range {
    double low, high;
    bool holdsLow, holdsHigh;   ///< whether the ends belong to it
    bool clamps;                ///< a number outside counts as the nearest end, which pbrt-v4 takes it for as well; otherwise it is an error
    std::string text;           ///< as written in the row: "(0, 180)"

    bool holds(double x) const { return (holdsLow ? x >= low : x > low) && (holdsHigh ? x <= high : x < high); }
};

/// One parameter of a kind.
struct Rule {
    Wanted wanted;
    std::string name;
    std::string orElse;         ///< the parameter that gives the value if this one is not given; empty: none
    std::string fallback;       ///< the default as written in the row: a number, a word, a spectrum's name; empty: none
    std::string as;             ///< what the scene calls it
    std::optional<Range> range; ///< of its numbers; those of textures and of spectra are not looked at
};

/// One row of a table, its parameters taken apart.
struct Kind {
    std::string noun, name;     ///< "material", "diffuse"
    int value;                  ///< an enumerator of the table's owner
    std::vector<Rule> rules;
    const char* standIn;        ///< null: it is rendered; otherwise what happens instead, for a message

    std::string title() const { return noun + " \"" + name + "\""; }
    const Rule* rule(const std::string& parameter) const;
    /// The names of all parameters that it reads, in the order of the row.
    std::vector<std::string> parameters() const;
};

struct Row {
    const char* name;        ///< null: this table does not have the row
    int value;
    /// "float radius = 1; floatmap uroughness | roughness = 0; floatmap conductor.roughness = 0 -> uroughness":
    /// a word, a name, then if wanted "| the parameter that it falls back to", "= default", "in (0, 180]" or "clamped to [0, inf)" (a
    /// number outside is an error, or counts as the nearest end, with a warning), "-> the scene's name for it".
    const char* parameters;
    const char* standIn = nullptr;
};

class KindTable {
public:
    /// common: parameters that all rows have.
    KindTable(const char* noun, const char* common, const std::vector<Row>& rows);

    /// The kind of that name. Throws SceneError, or Version3Error for a name that pbrt-v3 used.
    const Kind& find(const std::string& name, const SourceLocation& where) const;
    const std::vector<Kind>& kinds() const { return kinds_; }

private:
    std::string noun_;
    std::vector<Kind> kinds_;
};

/// What a rule accepts for one of its names, for messages: "rgb L", "spectrum L" or "blackbody L".
std::string acceptedDeclarations(const Rule& rule, const std::string& name);
bool accepts(const Rule& rule, ParameterType type);

}  // namespace eikonal::pbrt
