#pragma once
// The directives of the language.

#include "read/pbrt/tokens.h"

#include <string>
#include <vector>

namespace eikonal::pbrt {

class Parser;
struct Builder;

/// Where a directive may stand: before WorldBegin, after it, or both.
enum class Place { options, world, anywhere };

struct Directive {
    const char* name;
    Place place;
    void (*run)(Parser&, Builder&, const SourceLocation& where);
};

/// The directive that a token names. Throws SceneError, or Version3Error if only pbrt-v3 has it.
const Directive& findDirective(const Token& token, const SourceLocation& where);

/// The names of all directives.
std::vector<std::string> directiveNames();

}  // namespace eikonal::pbrt
