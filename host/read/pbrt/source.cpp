#include "read/pbrt/source.h"

#include "error.h"
#include "read/formats/read_bytes.h"

#include <string_view>

namespace eikonal::pbrt {

/// `read` returns the bytes, or throws a ReadProblem.
template <class Read>
static std::string readText(const std::string& name, Read read) {
    const SourceLocation where{std::make_shared<const std::string>(name)};
    std::string text;
    try {
        const std::vector<char> bytes = read();
        text.assign(bytes.begin(), bytes.end());
    } catch (const ReadProblem& problem) { throw SceneError(where, std::string("the file ") + problem.what()); }

    const std::string_view start(text);
    if (start.starts_with("\xfe\xff") || start.starts_with("\xff\xfe"))
        throw SceneError(where, "the file is UTF-16; save it as UTF-8 or ASCII");
    if (start.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
    return text;
}

std::string readTextFile(const std::string& path) {
    return readText(path, [&] { return readBytes(path); });
}

std::string readStandardInput(const std::string& nameForMessages) { return readText(nameForMessages, readInputBytes); }

}  // namespace eikonal::pbrt
