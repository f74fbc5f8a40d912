#include "messages.h"

#include "error.h"
#include "json_text.h"
#include "printable.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <mutex>

namespace eikonal {
namespace {

constexpr const char* levelNames[] = {"silent", "error", "warning", "info", "debug"};
constexpr const char* clearLine = "\r\x1b[K";

/// Writes all of a text with as few system calls as the file allows. Returns false if some of it was lost.
bool writeAll(int file, std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(file, text.data(), text.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        text.remove_prefix(static_cast<size_t>(written));
    }
    return true;
}

/// Calls `take` for each line of a text; a line end at its end begins no further line.
template <class Take> void forLines(std::string_view text, Take take) {
    do {
        const size_t end = std::min(text.find('\n'), text.size());
        take(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    } while (!text.empty());
}

/// What every line of a log begins with: the time, UTC.
std::string timeStamp() { return fmt::format("{:%Y-%m-%dT%H:%M:%SZ} ", fmt::gmtime(std::time(nullptr))); }

bool beginsWithTimeStamp(std::string_view text) {
    constexpr std::string_view pattern = "dddd-dd-ddTdd:dd:ddZ ";
    return text.size() >= pattern.size() && std::ranges::equal(pattern, text.substr(0, pattern.size()), [](char p, char c) {
               return p == 'd' ? std::isdigit(static_cast<unsigned char>(c)) != 0 : p == c;
           });
}

/// Appending to any other file would damage it.
void checkIsLog(const std::string& path, int file) {
    struct stat status {};
    if (::fstat(file, &status) != 0 || !S_ISREG(status.st_mode) || status.st_size == 0) return;
    char begin[32];
    const ssize_t size = ::pread(file, begin, sizeof begin, 0);
    if (!beginsWithTimeStamp({begin, static_cast<size_t>(std::max<ssize_t>(size, 0))}))
        throw UsageError(fmt::format("--log-file: \"{}\" is there already and is no log of eikonal; name another file", path));
}

class Messages {
public:
    void set(const MessageOptions& options, const std::string& title) {
        const std::lock_guard lock(mutex_);
        form_ = options.progress;
        if (!options.logFile.empty()) openLog(options.logFile);
        log(title);
    }

    ProgressForm form() const {
        if (form_ != ProgressForm::automatic) return form_;
        return ::isatty(STDERR_FILENO) ? ProgressForm::bar : ProgressForm::plain;
    }

    bool isFormGiven() const { return form_ != ProgressForm::automatic; }

    void tell(LogLevel level, std::string_view text, bool isShown) {
        const std::string clean = printable(text);
        const std::lock_guard lock(mutex_);
        if (isShown || level <= LogLevel::info) log(clean);
        if (isShown) show(level, clean);
    }

    void printProgress(const std::string& line) {
        const std::lock_guard lock(mutex_);
        writeAll(STDERR_FILENO, line + "\n");
    }

    void logProgress(const std::string& text) {
        const std::lock_guard lock(mutex_);
        log(text);
    }

    void drawStatus(const std::string& text) {
        const std::lock_guard lock(mutex_);
        status_ = text.substr(0, static_cast<size_t>(statusWidth()));
        writeAll(STDERR_FILENO, "\r" + status_ + "\x1b[K");
    }

    void endStatus(bool stays) {
        const std::lock_guard lock(mutex_);
        if (!status_.empty()) writeAll(STDERR_FILENO, stays ? "\n" : clearLine);
        status_.clear();
    }

private:
    void openLog(const std::string& path) {
        int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
        if (file < 0) file = ::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);   // of devices and pipes
        if (file < 0) throw Error(ExitCode::scene, fmt::format("cannot write \"{}\": {}", path, std::strerror(errno)));
        checkIsLog(path, file);
        log_ = file;
        path_ = path;
    }

    void log(std::string_view text) {
        if (log_ < 0) return;
        std::string lines;
        forLines(text, [&](std::string_view line) { lines += timeStamp() + std::string(line) + "\n"; });
        if (writeAll(log_, lines)) return;
        log_ = -1;
        show(LogLevel::warning, fmt::format("warning: the log ends here: cannot write \"{}\": {}", path_, std::strerror(errno)));
    }

    void show(LogLevel level, const std::string& text) {
        if (form_ == ProgressForm::json) {
            const nlohmann::ordered_json json{{"event", "message"}, {"level", levelNames[static_cast<int>(level)]}, {"text", text}};
            writeAll(STDERR_FILENO, jsonText(json) + "\n");
        } else if (form_ == ProgressForm::openjd) {
            writeAll(STDERR_FILENO, forOpenJd(level, text));
        } else if (status_.empty()) {
            writeAll(STDERR_FILENO, text + "\n");
        } else {
            writeAll(STDERR_FILENO, clearLine + text + "\n" + status_);
        }
    }

    /// A file's name must not pass for a command of the session.
    static std::string forOpenJd(LogLevel level, const std::string& text) {
        std::string lines, joined;
        forLines(text, [&](std::string_view line) {
            lines += (line.starts_with("openjd_") ? " " : "") + std::string(line) + "\n";
            joined += (joined.empty() ? "" : "; ") + std::string(line);
        });
        return level == LogLevel::error ? lines + "openjd_fail: " + joined + "\n" : lines;
    }

    mutable std::mutex mutex_;
    ProgressForm form_ = ProgressForm::automatic;
    std::string status_;   ///< the line that is drawn over; empty: none
    std::string path_;
    int log_ = -1;
};

Messages& messages() {
    static Messages one;
    return one;
}

}  // namespace

void setMessages(const MessageOptions& options, const std::string& title) { messages().set(options, title); }
ProgressForm progressForm() { return messages().form(); }
bool showsProgress(LogLevel log) { return log >= LogLevel::warning || messages().isFormGiven(); }
void tell(LogLevel level, std::string_view text, LogLevel shown) { messages().tell(level, text, level <= shown); }
void tellResult(std::string_view text, LogLevel shown) { messages().tell(LogLevel::info, text, shown >= LogLevel::warning); }
void printProgress(const std::string& line) { messages().printProgress(line); }
void logProgress(const std::string& text) { messages().logProgress(text); }
void drawStatus(const std::string& text) { messages().drawStatus(text); }
void endStatus(bool stays) { messages().endStatus(stays); }

int statusWidth() {
    constexpr int usual = 80;
    struct winsize size {};
    int columns = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
    if (columns == 0)
        if (const char* given = std::getenv("COLUMNS")) columns = std::atoi(given);
    return std::max(columns > 0 ? columns - 1 : usual - 1, 1);   // a line as long as the terminal is wide would wrap
}

}  // namespace eikonal
