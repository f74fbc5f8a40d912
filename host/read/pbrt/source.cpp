#include "read/pbrt/source.h"

#include "error.h"
#include "read/formats/read_bytes.h"
#include "read/formats/text_encoding.h"

#include <string_view>

namespace eikonal::pbrt {

/// `read` returns the bytes, or throws a ReadProblem.
template <class Read>
static std::string readText(const std::string& name, Read read) {
    const SourceLocation where{std::make_shared<const std::string>(name)};
    try {
        const std::vector<char> bytes = read();
        return std::string(withoutByteOrderMark({bytes.data(), bytes.size()}, where));
    } catch (const ReadProblem& problem) { throw SceneError(where, std::string("the file ") + problem.what()); }
}

std::string readTextFile(const std::string& path) {
    return readText(path, [&] { return readBytes(path); });
}

std::string readStandardInput(const std::string& nameForMessages) { return readText(nameForMessages, readInputBytes); }

}  // namespace eikonal::pbrt
