#include "standard_stream.h"

#include "error.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace eikonal {

[[noreturn]] static void fail(const std::string& reason) { throw Error(ExitCode::scene, "cannot write to standard output: " + reason); }

void checkStandardOutput() {
    if (::isatty(STDOUT_FILENO)) fail("it is a terminal, and an image is no text; lead it to a file (> image.exr) or a program (|)");
}

void writeToStandardOutput(std::span<const unsigned char> content) {
    while (!content.empty()) {
        const ssize_t written = ::write(STDOUT_FILENO, content.data(), content.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail(std::strerror(errno));
        content = content.subspan(static_cast<std::size_t>(written));
    }
}

}  // namespace eikonal
