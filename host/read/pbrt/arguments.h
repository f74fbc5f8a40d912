#pragma once
// Parameters as a kind wants them: checked, typed, defaults filled in.

#include "read/pbrt/kinds.h"
#include "read/pbrt/reading.h"

#include <memory>
#include <vector>

namespace eikonal::pbrt {

/// The parameters of one directive, read by the rules of its kind. A parameter that is given twice counts as given last;
/// those of an enclosing Attribute directive count where the directive has none. The names asked for must be in the rules;
/// a value that is neither given nor has a default is zero or empty. Reading a wrong number of values throws SceneError.
class Arguments {
public:
    /// Notes parameters of `own` that the kind does not have (a warning, under --strict a problem), and throws SceneError for one
    /// of a wrong type, and for numbers out of their range, unless they are clamped to it. `inherited` may be null, and may have parameters that the kind does not have.
    Arguments(Reading& reading, const Kind& kind, SourceLocation where, ParameterList own,
              std::shared_ptr<const ParameterList> inherited, ColorSpace space);

    const Kind& kind() const { return *kind_; }
    const SourceLocation& where() const { return where_; }
    ColorSpace space() const { return space_; }

    /// The parameter that gives a value; null if none does.
    const Parameter* given(const std::string& name) const;
    bool has(const std::string& name) const { return given(name); }
    /// Where a parameter is given, or else the directive.
    const SourceLocation& whereOf(const std::string& name) const;

    bool flag(const std::string& name) const;
    double number(const std::string& name) const;
    double number(const std::string& name, double fallback) const;
    int integer(const std::string& name) const;
    std::string text(const std::string& name) const;
    glm::dvec3 vector(const std::string& name) const;              ///< points and vectors
    glm::dvec3 vector(const std::string& name, glm::dvec3 fallback) const;
    std::vector<double> numbers(const std::string& name) const;
    std::vector<int> integers(const std::string& name) const;
    std::vector<std::string> texts(const std::string& name) const;
    std::vector<glm::vec2> vectors2(const std::string& name) const;
    std::vector<glm::vec3> vectors3(const std::string& name) const;
    /// Colours, none of whose components is negative, in space().
    std::vector<glm::vec3> colors(const std::string& name) const;

    /// A spectrum or a float as one; `fallback` if it is not given and the row has no default.
    Spectrum spectrum(const std::string& name, const Spectrum& fallback = Spectrum()) const;

    /// The path of a file that exists; nothing if none is given, or if it is missing (which is noted).
    std::optional<std::string> file(const std::string& name) const;

private:
    const Rule& rule(const std::string& name) const;
    void checkRanges();
    template <class T> const std::vector<T>* values(const std::string& name) const;
    template <class T> std::optional<T> single(const std::string& name) const;
    template <class V> std::vector<V> vectors(const std::string& name) const;

    Reading* reading_;
    const Kind* kind_;
    SourceLocation where_;
    ParameterList own_;
    std::shared_ptr<const ParameterList> inherited_;
    ColorSpace space_;
};

/// Throws SceneError unless there are `count` values.
template <class T> void expectCount(const Arguments& arguments, const std::string& name, const std::vector<T>& values, size_t count) {
    if (values.size() != count)
        throw SceneError(arguments.whereOf(name), "\"" + arguments.given(name)->declaration() + "\" has " + std::to_string(values.size()) +
                                                      " values; " + std::to_string(count) + " are expected");
}

/// The "string type" that MakeNamedMaterial and MakeNamedMedium have. Throws SceneError if it is not given.
std::string typeOf(const ParameterList& parameters, const char* directive, const SourceLocation& where);

}  // namespace eikonal::pbrt
