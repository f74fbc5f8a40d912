// The program: reads the command line, runs one command, and turns errors into messages and exit statuses.

#include "app/commands.h"
#include "app/interrupt.h"
#include "app/tell_error.h"
#include "render/kernel_workers.h"
#include "messages.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <malloc.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

using namespace eikonal;

static int run(const Options& options) {
    switch (options.command) {
        case Command::print: std::fputs(options.text.c_str(), stdout); return static_cast<int>(ExitCode::success);
        case Command::render: return renderCommand(options);
        case Command::info: return infoCommand(options);
        case Command::bench: return benchCommand(options);
        case Command::trade: return tradeCommand(options);
        case Command::cache: return cacheCommand(options);
        case Command::listDevices: return listDevicesCommand(options);
        case Command::compileKernels: compileKernels(options.device, options.compile); return static_cast<int>(ExitCode::success);
        case Command::merge: return mergeCommand(options);
        case Command::submit: return submitCommand(options);
        case Command::denoise: return denoiseCommand(options);
        case Command::compare: return compareCommand(options);
    }
    return static_cast<int>(ExitCode::usage);
}

/// Whether the reader of standard output has gone.
static bool hasReaderGone() {
    struct pollfd out { STDOUT_FILENO, 0, 0 };
    return ::poll(&out, 1, 0) == 1 && (out.revents & POLLERR) != 0;
}

/// Throws Error unless all that was printed has arrived: a full disk would lose it without a word. A reader that has gone, as `head` does,
/// is no error.
static void finishPrinting() {
    if (std::fflush(stdout) == 0 && !std::ferror(stdout)) return;
    const int error = errno;
    if (!hasReaderGone()) throw Error(ExitCode::scene, std::string("cannot write to standard output: ") + std::strerror(error));
}

/// A pipe without a reader, or a file that is too large, becomes an error of the write, which must not end a render. Streams that the
/// parent has closed are opened, so that no image is opened in their place; what should be printed on a closed standard output is an error
/// in the end.
static void keepStreams() {
    for (const int number : {SIGPIPE, SIGXFSZ}) std::signal(number, SIG_IGN);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(stream, F_GETFD) < 0) {
            [[maybe_unused]] const int lowest = ::open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY);
        }
}

/// Makes free() return blocks above 128 KiB to the system at once, because reading and packing a scene take much memory for a short time.
static void returnFreedMemory() { ::mallopt(M_MMAP_THRESHOLD, 128 << 10); }

int main(int argc, char** argv) {
    returnFreedMemory();
    keepStreams();
    keepIgnoredSignals();
    try {
        const Options options = parseOptions(std::vector<std::string>(argv, argv + argc));
        setMessages({options.progress, options.logFile}, options.commandLine);
        const int status = run(options);
        finishPrinting();
        logProgress(fmt::format("exit status {}", status));
        return status;
    } catch (...) { return tellError(); }
}
