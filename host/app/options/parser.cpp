#include "app/options/parser.h"

#include "app/command_line.h"
#include "app/options/declare.h"
#include "app/options/shared_options.h"

#include <iterator>

namespace eikonal {

CLI::App* Parser::add(const std::string& name, Command command, const std::string& help) {
    CLI::App* sub = app.add_subcommand(name, help);
    sub->allow_extras();
    commands.emplace_back(sub, command);
    return sub;
}

Parser::Parser() {
    app.allow_extras();
    app.set_help_all_flag("--help-all", "Print the options of all commands");
    app.set_version_flag("--version", "eikonal " EIKONAL_VERSION);
    addListDevices(&app, options);
    app.require_subcommand(0, 1);

    declareRender(*this);
    declareMeasurements(*this);
    declareImageCommands(*this);
    declareSubmit(*this);

    auto* completion = add("completion", Command::print, "Print a script that completes command lines");
    offer(completion->add_option("SHELL", shell, "bash, zsh or fish")->type_name(""),
          {std::begin(completionShells), std::end(completionShells)});
    add("man", Command::print, "Print the manual page");
}

std::vector<std::string> optionsOf(const CLI::App* app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app->get_options())
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

}  // namespace eikonal
