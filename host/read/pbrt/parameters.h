#pragma once
// Parameters as written in the file: "rgb reflectance" [ .5 .5 .5 ].

#include "read/pbrt/tokens.h"
#include "color/observer.h"

#include <string>
#include <variant>
#include <vector>

namespace eikonal::pbrt {

/// The declared types of parameters.
enum class ParameterType { boolean, number, integer, point2, vector2, point3, vector3, normal, rgb, blackbody, spectrum, text, texture };

/// Values in file order; points and vectors component by component.
using Values = std::variant<std::vector<bool>, std::vector<double>, std::vector<int>, std::vector<float>, std::vector<std::string>>;

struct Parameter {
    ParameterType type;
    std::string name;
    Values values;          ///< bool; numbers, colours, point3: double; integer; point2, vectors, normals: float; others: string
    ColorSpace space = ColorSpace::srgb;  ///< the colour space of its colours
    SourceLocation where;
    SourceLocation whereText;  ///< strings: place of the first character of the first string

    mutable bool isUsed = false;  ///< whether the reader has asked for it

    /// Whether it has no values. Parser::parameters never returns such a parameter.
    bool isEmpty() const;
    /// "type name", as it was written.
    std::string declaration() const;
};

using ParameterList = std::vector<Parameter>;

/// The name of a type in the file.
const char* nameOf(ParameterType type);

/// Reads the values after a declaration: a single one, or a list in brackets, which may be empty. Throws SceneError.
Parameter readParameter(TokenStream& tokens, const Token& declaration);

}  // namespace eikonal::pbrt
