// The program: reads the command line, runs one command, and turns errors into messages and exit statuses.

#include "app/commands.h"
#include "app/interrupt.h"
#include "render/kernel_workers.h"
#include "printable.h"

#include <malloc.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <new>

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
        case Command::compare: return compareCommand(options);
    }
    return static_cast<int>(ExitCode::usage);
}

/// Prints an error. Errors in scenes and files already begin with file:line:column, so they get no prefix.
static int fail(ExitCode code, const std::string& message) {
    std::fprintf(stderr, "%s\n", printable(message).c_str());
    return static_cast<int>(code);
}

/// Throws Error unless all that was printed has arrived: a full disk would lose it without a word. A reader that has gone, as `head` does,
/// is no error.
static void finishPrinting() {
    if (std::fflush(stdout) == 0 && !std::ferror(stdout)) return;
    if (errno != EPIPE) throw Error(ExitCode::scene, std::string("cannot write to standard output: ") + std::strerror(errno));
}

/// Makes free() return blocks above 128 KiB to the system at once, because reading and packing a scene take much memory for a short time.
static void returnFreedMemory() { ::mallopt(M_MMAP_THRESHOLD, 128 << 10); }

int main(int argc, char** argv) {
    returnFreedMemory();
    keepIgnoredSignals();
    try {
        const int status = run(parseOptions(std::vector<std::string>(argv, argv + argc)));
        finishPrinting();
        return status;
    } catch (const Error& error) {
        return fail(error.code(), (error.code() == ExitCode::scene ? "" : "error: ") + std::string(error.what()));
    } catch (const std::bad_alloc&) {
        return fail(ExitCode::scene, "error: not enough memory; --log-level info prints the planned use");
    } catch (const std::exception& error) {
        return fail(ExitCode::scene, std::string("error: ") + error.what());
    }
}
