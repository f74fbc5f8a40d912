#pragma once
// What the program tells while it runs: messages and progress, on standard error and in a log file. Everything here is thread-safe, and a
// reader that has gone or a closed stream is no error: it must not end a render.

#include "diagnostics.h"

#include <string>
#include <string_view>

namespace eikonal {

/// How progress is shown.
enum class ProgressForm {
    automatic,  ///< a bar on a terminal, otherwise plain
    bar,        ///< one line that is drawn over
    plain,      ///< a line every ten seconds
    json,       ///< every line of standard error, also a message, is one JSON object with a member "event"
    openjd,     ///< beside messages, lines of Open Job Description: openjd_progress, openjd_status and openjd_fail
};

struct MessageOptions {
    ProgressForm progress = ProgressForm::automatic;
    std::string logFile;   ///< empty: none
};

/// From now on messages have this form, and the log file begins with `title`. It is appended to. Throws Error if it cannot be written, or
/// is there and no log.
void setMessages(const MessageOptions& options, const std::string& title);
/// The form in use: never automatic.
ProgressForm progressForm();
/// Whether to show progress: --quiet is silent about it, unless a form is asked for.
bool showsProgress(LogLevel log);

/// Tells one or more lines, whose control characters are escaped, on standard error if messages up to `shown` are. The log gets what is
/// shown, and all up to LogLevel::info.
void tell(LogLevel level, std::string_view text, LogLevel shown = LogLevel::debug);
/// Tells what a command has done: shown where warnings are, but as LogLevel::info.
void tellResult(std::string_view text, LogLevel shown);
/// Prints a line of progress as it is.
void printProgress(const std::string& line);
/// Adds a line of progress to the log.
void logProgress(const std::string& text);

/// Form bar: draws a line that the next one is drawn over, cut to the width of the terminal. Messages come before it.
void drawStatus(const std::string& text);
/// Ends that line: it stays, or is cleared.
void endStatus(bool stays);
/// The characters that such a line may have.
int statusWidth();

}  // namespace eikonal
