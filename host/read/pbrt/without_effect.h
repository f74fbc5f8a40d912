#pragma once
// Everything in pbrt-v4's language that is read and changes no image of Eikonal: the only list. docs/pbrt.md holds it, too.

#include "read/pbrt/kinds.h"

#include <span>

namespace eikonal::pbrt {

/// Whether the image is nevertheless what the scene asks for, or not: then the reader warns, or with --strict refuses the scene.
enum class Answer { silence, warning };

/// A parameter that has no effect, of one kind or of all kinds of a directive.
struct WithoutEffect {
    const char* noun;        ///< of the directive's table: "sampler"
    const char* kind;        ///< a name in that table; null: all
    const char* parameter;   ///< null: all
    const char* value;       ///< for one value only; null: for all
    Answer answer;
    const char* why;         ///< a clause, as it follows a colon
};

std::span<const WithoutEffect> withoutEffect();

/// Whether a parameter has the value that its rule gives it anyway.
bool isDefault(const Rule& rule, const Parameter& parameter);

/// The line of the list that a parameter of a kind falls under; null if there is none, or if it has its default value.
const WithoutEffect* withoutEffect(const Kind& kind, const Parameter& parameter);

}  // namespace eikonal::pbrt
