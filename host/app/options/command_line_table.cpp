#include "app/command_line.h"
#include "app/options/parser.h"

#include <algorithm>
#include <iterator>
#include <sstream>

namespace eikonal {
namespace {

/// The words that `offer` keeps.
std::vector<std::string> offered(CLI::Option* option) {
    try {
        std::istringstream words(option->get_validator()->get_name());
        return {std::istream_iterator<std::string>(words), {}};
    } catch (const CLI::OptionNotFound&) { return {}; }
}

OptionDescription described(CLI::Option* option) {
    OptionDescription d;
    for (const std::string& name : option->get_snames()) d.names.push_back("-" + name);
    for (const std::string& name : option->get_lnames()) d.names.push_back("--" + name);
    if (option->get_positional()) d.names = {option->get_name(true) + (option->get_items_expected_max() > 1 ? " ..." : "")};
    d.help = option->get_description();
    d.group = option->get_group();
    if (option->get_items_expected_max() == 0) return d;
    d.type = option->get_type_name();
    d.words = offered(option);
    const bool isFile = (option->get_positional() || d.type.starts_with("FILE") || d.type == "IMAGE") && d.words.empty();
    d.value = isFile ? ValueHint::file : d.type == "DIR" ? ValueHint::folder : ValueHint::text;
    return d;
}

/// A command with its options in the order of their groups, as --help prints them.
CommandDescription described(CLI::App* app, const std::string& name) {
    CommandDescription command{name, app->get_description(), {}, {}};
    for (const std::string& group : app->get_groups())
        for (CLI::Option* option : app->get_options())
            if (option->get_group() == group) (option->get_positional() ? command.arguments : command.options).push_back(described(option));
    return command;
}

}  // namespace

std::vector<CommandDescription> commandLineTable() {
    Parser parser;
    std::vector<CommandDescription> table{described(&parser.app, "")};
    for (const auto& [command, id] : parser.commands)
        if (!command->get_group().empty()) table.push_back(described(command, command->get_name()));
    return table;
}

std::vector<std::string> allOptionNames() {
    const Parser parser;
    std::vector<std::string> names = optionsOf(&parser.app);
    for (const auto& [command, id] : parser.commands)
        for (const std::string& name : optionsOf(command)) names.push_back(name);
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

}  // namespace eikonal
