#pragma once
// The command line as a table, for texts that are made of it: the manual page and completion.

#include <string>
#include <vector>

namespace eikonal {

/// What a value is, for completion.
enum class ValueHint { none, text, file, folder };

/// An option, or an argument, whose only name is in capitals: "SCENE", "PART ...".
struct OptionDescription {
    std::vector<std::string> names;     ///< with dashes: "-o", "--outfile"
    std::string type;                   ///< "N", "FILE"; empty: a flag, or an argument
    std::string help, group;
    ValueHint value = ValueHint::none;
    std::vector<std::string> words;     ///< the values that it takes, if they are few
};

struct CommandDescription {
    std::string name, help;
    std::vector<OptionDescription> arguments, options;
};

/// The program, whose name is empty, then its commands. Made of the declarations in options/.
std::vector<CommandDescription> commandLineTable();

/// A script that completes the command line; `shell` is one of completionShells.
std::string completionScript(const std::string& shell, const std::vector<CommandDescription>& commands);
constexpr const char* completionShells[] = {"bash", "zsh", "fish"};

/// The manual page, in the macros of man(7).
std::string manualPage(const std::vector<CommandDescription>& commands);

}  // namespace eikonal
