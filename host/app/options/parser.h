#pragma once
// The commands of the program, with their options.

#include "app/options.h"

#include <CLI/CLI.hpp>

#include <string>
#include <utility>
#include <vector>

namespace eikonal {

/// The commands, bound to the options that they fill in.
struct Parser {
    Options options;
    CLI::App app{"Eikonal renders scenes by path tracing on OpenCL devices.", "eikonal"};
    std::vector<std::pair<CLI::App*, Command>> commands;
    std::string shell;  ///< completion

    Parser();
    CLI::App* add(const std::string& name, Command command, const std::string& help);
};

void declareRender(Parser& parser);
void declareMeasurements(Parser& parser);
void declareImageCommands(Parser& parser);
void declareSubmit(Parser& parser);

/// The long names of a command's options.
std::vector<std::string> optionsOf(const CLI::App* app);

/// Whether the command has the option, and the user gave it.
bool isGiven(const CLI::App* command, const std::string& name);

/// Throws a UsageError for options that do not go together. Warns of those without effect.
void checkTogether(const Parser& parser, const CLI::App* command);
/// Among the files of -o, one may be a film, which is then the checkpoint. A part of an image makes no image unless one is named.
void chooseFilm(Options& o);

/// The frames of a turntable are all, unless --frames selects some.
void chooseFrames(Options& o);

/// The last line of errors.
inline constexpr const char* getHelp = "Run `eikonal --help` for the commands, `eikonal COMMAND --help` for their options.";

}  // namespace eikonal
