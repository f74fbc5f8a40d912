#pragma once
// Tables of what directives accept. Each kind of material, light, shape ... is a row: its name, its value in the scene, its parameters with
// types and defaults, and the replacement if it is not rendered.

#include "read/pbrt/parameters.h"

#include <optional>
#include <string>
#include <vector>

namespace eikonal::pbrt {

/// The type that a parameter is read as. kinds.cpp lists the word for each, and the declared types that it accepts.
enum class Wanted {
    flag, number, numbers, integer, integers, text, texts, file, point2s, point3, point3s, vector3, vector3s, normals,
    floatMap,     ///< a float or a float texture
    colorMap,     ///< a reflectance or a spectrum texture: rgb in [0, 1]
    spectrumMap,  ///< a coefficient or a spectrum texture: rgb not negative
    spectrum,     ///< a spectrum, not a texture
    colors,       ///< any number of rgb colours
    index,        ///< a float or a spectrum, not a texture
    floatTexture, ///< the name of a float texture
};

/// The range of a number.
struct Range {
    double low, high;
    bool holdsLow, holdsHigh;   ///< whether the ends are included
    bool clamps;                ///< numbers outside are clamped with a warning, as pbrt-v4 does; otherwise they are an error
    std::string text;           ///< as written in the row: "(0, 180)"

    bool holds(double x) const { return (holdsLow ? x >= low : x > low) && (holdsHigh ? x <= high : x < high); }
};

/// One parameter of a kind.
struct Rule {
    Wanted wanted;
    std::string name;
    std::string orElse;         ///< the parameter to read instead if this one is not given; empty: none
    std::string fallback;       ///< the default as written in the row: a number, a word, a name of a spectrum; empty: none
    std::string as;             ///< its name in the scene
    std::optional<Range> range; ///< range of its numbers; textures and spectra are not checked
    std::vector<std::string> choices;  ///< the words that a string can be; empty: any

    bool hasName(const std::string& parameter) const { return name == parameter || orElse == parameter; }
};

/// A parsed row of a table.
struct Kind {
    std::string noun, name;     ///< "material", "diffuse"
    int value;                  ///< an enumerator of the table's user
    std::vector<Rule> rules;
    const char* standIn;        ///< null: it is rendered; otherwise what replaces it, for a message

    std::string title() const { return noun + " \"" + name + "\""; }
    const Rule* rule(const std::string& parameter) const;
    /// The rule that a parameter is read by; null if there is none.
    const Rule* ruleFor(const Parameter& parameter) const;
    /// The names of all parameters, in the order of the row.
    std::vector<std::string> parameters() const;
};

struct Row {
    const char* name;        ///< null: the row is not in this table
    int value;
    /// Such as "float radius = 1; floatmap uroughness
    /// roughness = 0; floatmap conductor.roughness = 0 -> uroughness": a type, a name, and optionally "| the parameter to read instead", "=
    /// default", "in (0, 180]" (numbers outside are an error), "clamped to [0, inf)" (numbers outside become the nearest end, with a
    /// warning) or "in {flat, ribbon}" (other words are an error), and "-> the name in the scene".
    const char* parameters;
    const char* standIn = nullptr;
};

class KindTable {
public:
    /// common: parameters of all rows.
    KindTable(const char* noun, const char* common, const std::vector<Row>& rows);

    /// The kind called `name`. Throws SceneError, or Version3Error for a name from pbrt-v3.
    const Kind& find(const std::string& name, const SourceLocation& where) const;
    const std::vector<Kind>& kinds() const { return kinds_; }

private:
    std::string noun_;
    std::vector<Kind> kinds_;
};

/// "a", "b" or "c"
std::string alternatives(const std::vector<std::string>& items);
/// The declarations that a rule accepts for one of its names, for messages: "rgb L", "spectrum L" or "blackbody L".
std::string acceptedDeclarations(const Rule& rule, const std::string& name);
bool accepts(const Rule& rule, ParameterType type);

}  // namespace eikonal::pbrt
