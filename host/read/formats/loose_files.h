#pragma once
// Files of scenes that come from another machine.

#include "scene/textures.h"

#include <filesystem>
#include <optional>
#include <string>

namespace eikonal {

/// What a scene does about files that are not there.
enum class MissingFiles {
    error,    ///< all of them are listed
    magenta,  ///< textures become magenta, shapes are left out, each with a warning
};

/// The file that `name` probably means, if there is none of exactly that name: letter case does not matter, backslashes are slashes, and
/// of a longer path ("C:\Users\me\tex\Wood.PNG") the last names count, as many as lead to a file. Looked for in `folder`, then in
/// "textures" below it. Where several differ by case alone, the first in the order of characters.
std::optional<std::string> findLoosely(const std::string& name, const std::filesystem::path& folder);

/// A pixel in magenta, in place of an image that is missing. name: tells it from others.
ImageFile magentaImage(const std::string& name);

/// What a warning says about a loose match.
std::string looseMatchMessage(const std::string& name, const std::string& found);

}  // namespace eikonal
