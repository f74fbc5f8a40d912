#pragma once
// The parameters of a directive, checked and typed by the rules of its kind, with defaults filled in.

#include "read/pbrt/kinds.h"
#include "read/pbrt/reading.h"

#include <memory>
#include <vector>

namespace eikonal::pbrt {

/// The parameters of one directive, read by the rules of its kind. Of repeated parameters the last counts; parameters of enclosing
/// Attribute directives count if the directive has none of that name. Only names in the rules may be requested; a value that is not given
/// and has no default is zero or empty. Reading a wrong number of values throws SceneError.
class Arguments {
public:
    /// Reports parameters of `own` that the kind does not have (a warning, under --strict a problem). Throws SceneError for a wrong type,
    /// and for numbers out of range unless the rule clamps them. `inherited` may be null, and may have parameters that the kind does not
    /// have. Also reports parameters that have no effect (read/pbrt/without_effect.h).
    Arguments(Reading& reading, const Kind& kind, SourceLocation where, ParameterList own,
              std::shared_ptr<const ParameterList> inherited, ColorSpace space);

    const Kind& kind() const { return *kind_; }
    const SourceLocation& where() const { return where_; }
    ColorSpace space() const { return space_; }

    /// The parameter that gives a value; null if there is none.
    const Parameter* given(const std::string& name) const;
    bool has(const std::string& name) const { return given(name); }
    /// The place of a parameter if given, else of the directive.
    const SourceLocation& whereOf(const std::string& name) const;

    bool flag(const std::string& name) const;
    double number(const std::string& name) const;
    double number(const std::string& name, double fallback) const;
    int integer(const std::string& name) const;
    std::string text(const std::string& name) const;
    glm::dvec3 vector(const std::string& name) const;              ///< a point or vector
    glm::dvec3 vector(const std::string& name, glm::dvec3 fallback) const;
    std::vector<double> numbers(const std::string& name) const;
    std::vector<int> integers(const std::string& name) const;
    std::vector<std::string> texts(const std::string& name) const;
    std::vector<glm::vec2> vectors2(const std::string& name) const;
    std::vector<glm::vec3> vectors3(const std::string& name) const;
    /// As they are written, not rounded to single precision. Throws SceneError for coordinates that no float can hold.
    std::vector<glm::dvec3> points3(const std::string& name) const;
    /// RGB colours in space(), no component negative.
    std::vector<glm::vec3> colors(const std::string& name) const;

    /// A spectrum, or a float as a spectrum; `fallback` if the parameter is not given and has no default.
    Spectrum spectrum(const std::string& name, const Spectrum& fallback = Spectrum()) const;

    /// The path of an existing file; nothing if the parameter is not given or the file is missing (which is noted).
    std::optional<std::string> file(const std::string& name) const;
    /// The same for a file, or an image of textures, that a picture can do without (Reading::findFile, findImage).
    std::optional<std::string> file(const std::string& name, const char* instead) const;
    std::optional<ImageFile> image(const std::string& name) const;

    /// Reports parameters of this directive that nothing has asked for: others leave them without an effect. To be called when everything
    /// is read.
    void reportUnused() const;

private:
    const Rule& rule(const std::string& name) const;
    void checkValues();
    void warnOfImpossible(const Parameter& parameter, const Spectrum& reflectance) const;
    template <class T> const std::vector<T>* values(const std::string& name) const;
    template <class T> std::optional<T> single(const std::string& name) const;
    template <class V, class Stored> std::vector<V> vectors(const std::string& name) const;

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

/// The "string type" of MakeNamedMaterial and MakeNamedMedium. Throws SceneError if it is not given.
std::string typeOf(const ParameterList& parameters, const char* directive, const SourceLocation& where);

}  // namespace eikonal::pbrt
