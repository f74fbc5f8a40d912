#pragma once
// The table of directives.

#include "read/pbrt/tokens.h"

#include <string>
#include <vector>

namespace eikonal::pbrt {

class Parser;
struct Builder;

/// Where a directive is allowed: before WorldBegin, after it, or both.
enum class Place { options, world, anywhere };

struct Directive {
    const char* name;
    Place place;
    void (*run)(Parser&, Builder&, const SourceLocation& where);
};

/// The directive named by a token. Throws SceneError, or Version3Error if only pbrt-v3 has it.
const Directive& findDirective(const Token& token, const SourceLocation& where);

/// The names of all directives.
std::vector<std::string> directiveNames();

}  // namespace eikonal::pbrt
