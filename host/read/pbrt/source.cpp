#include "read/pbrt/source.h"

#include "error.h"
#include "read/formats/read_bytes.h"

#include <string_view>

namespace eikonal::pbrt {

std::string readTextFile(const std::string& path) {
    const SourceLocation where{std::make_shared<const std::string>(path)};
    std::string text;
    try {
        const std::vector<char> bytes = readBytes(path);
        text.assign(bytes.begin(), bytes.end());
    } catch (const ReadProblem& problem) { throw SceneError(where, std::string("the file ") + problem.what()); }

    const std::string_view start(text);
    if (start.starts_with("\xfe\xff") || start.starts_with("\xff\xfe"))
        throw SceneError(where, "the file is UTF-16; save it as UTF-8 or ASCII");
    if (start.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
    return text;
}

}  // namespace eikonal::pbrt
