#pragma once
// Parameters as they are written: "rgb reflectance" [ .5 .5 .5 ].

#include "read/pbrt/tokens.h"
#include "color/observer.h"

#include <string>
#include <variant>
#include <vector>

namespace eikonal::pbrt {

/// The types that a parameter may be declared with.
enum class ParameterType { boolean, number, integer, point2, vector2, point3, vector3, normal, rgb, blackbody, spectrum, text, texture };

/// Values in the order of the file; those of points and vectors one component after the other.
using Values = std::variant<std::vector<bool>, std::vector<double>, std::vector<int>, std::vector<float>, std::vector<std::string>>;

struct Parameter {
    ParameterType type;
    std::string name;
    Values values;          ///< bool; float, rgb, blackbody, spectrum: double; integer; points, vectors, normals: float; others: string
    ColorSpace space = ColorSpace::srgb;  ///< in which its colours are given
    SourceLocation where;
    SourceLocation whereText;  ///< strings: of the first character of the first one

    /// Whether it has no value: Parser::parameters gives none such.
    bool isEmpty() const;
    /// "type name", as it was written.
    std::string declaration() const;
};

using ParameterList = std::vector<Parameter>;

/// The word for a type in a file.
const char* nameOf(ParameterType type);

/// Reads a declaration's value or values: a bare one, or a list in brackets, which may be empty. Throws SceneError.
Parameter readParameter(TokenStream& tokens, const Token& declaration);

}  // namespace eikonal::pbrt
