#include "app/options.h"

#include "app/command_line.h"
#include "app/options/declare.h"
#include "app/options/parser.h"
#include "app/pbrt_spelling.h"

#include <algorithm>
#include <iterator>
#include <regex>
#include <sstream>

namespace eikonal {
namespace {

/// Reports the first argument that a command did not recognise, with a hint.
[[noreturn]] void refuseExtra(const Parser& parser, const CLI::App* command, const std::string& argument) {
    if (argument.size() > 1 && argument[0] == '-') {
        const std::string name = argument.substr(0, argument.find('='));
        const std::string instead = insteadOf(name), near = instead.empty() ? nearestWord(name, optionsOf(command)) : "";
        std::string hint = !instead.empty() ? "; " + instead : near.empty() ? "" : fmt::format("; did you mean {}?", near);
        if (hint.empty())
            for (const auto& [other, id] : parser.commands)
                for (const std::string& option : optionsOf(other))
                    if (option == name && hint.empty()) hint = fmt::format("; {} has it", other->get_name());
        throw UsageError(
            fmt::format("{} has no option {}{}\n{}", command == &parser.app ? "eikonal" : command->get_name(), name, hint, getHelp));
    }
    if (command != &parser.app)
        throw UsageError(fmt::format("{} takes no further argument, but found \"{}\"\n{}", command->get_name(), argument, getHelp));
    std::vector<std::string> names;
    for (const auto& [other, id] : parser.commands)
        if (!other->get_group().empty()) names.push_back(other->get_name());
    const std::string near = nearestWord(argument, names);
    const bool isScene = argument.find(".pbrt") != std::string::npos || argument.find(".obj") != std::string::npos;
    throw UsageError(fmt::format("\"{}\" is not a command; {}\n{}", argument,
                                 isScene ? fmt::format("did you mean `eikonal render {}`?", argument)
                                 : near.empty() ? fmt::format("the commands are {}", fmt::join(names, ", "))
                                                : fmt::format("did you mean {}?", near), getHelp));
}

/// `arguments` with the options of the preset that the user has not given.
std::vector<std::string> withPreset(std::vector<std::string> arguments, const Preset& preset, const CLI::App* command) {
    std::istringstream words(preset.options);
    for (std::string word; words >> word;)
        if (command->get_option(word.substr(0, word.find('=')))->count() == 0) arguments.push_back(word);
    return arguments;
}

/// The options of these groups that the user gave, without -o, as another command takes them.
std::vector<std::string> optionsOfGroups(const CLI::App* command, const std::vector<std::string>& groups) {
    std::vector<std::string> words;
    for (const CLI::Option* option : command->get_options()) {
        const std::string name = option->get_name();   // a long name: --name
        if (option->count() == 0 || option->get_positional() || !std::ranges::count(groups, option->get_group()) || name == "--outfile")
            continue;
        const bool isFlag = option->get_items_expected_max() == 0;
        for (const std::string& value : option->results())
            if (!value.empty()) words.push_back(isFlag ? name : name + "=" + value);
    }
    return words;
}

std::vector<Wish> usualWishes() {
    using enum Wish::Kind;
    return {{seconds, 1}, {seconds, 10}, {seconds, 60}, {error, 0.1}, {error, 0.05}, {error, 0.02}};
}

/// What the user gave, without the program's name, in the spelling of the command: `help render` is `render --help`.
std::vector<std::string> inOurSpelling(const Parser& parser, std::vector<std::string> words) {
    const bool wantsHelp = !words.empty() && words[0] == "help";
    if (wantsHelp) words.erase(words.begin());
    const CLI::App* command = &parser.app;
    for (const auto& [sub, id] : parser.commands)
        if (!words.empty() && sub->get_name() == words[0]) command = sub;
    const bool isKnown = words.empty() || command != &parser.app;
    if (wantsHelp && isKnown) words = {"--help"};
    if (wantsHelp && command != &parser.app) words.insert(words.begin(), command->get_name());
    return withOurSpelling(std::move(words), optionsOf(command));
}

/// The long names of an option, or the one that it has.
std::vector<std::string> namesOf(const CLI::App* command, const std::string& name) {
    std::vector<std::string> names;
    if (const CLI::Option* option = command ? command->get_option_no_throw(name) : nullptr)
        for (const std::string& each : option->get_lnames()) names.push_back("--" + each);
    return names.empty() ? std::vector{name} : names;
}

/// What the parser says of a wrong command line, in the words of our other messages.
std::string inOurWords(const std::string& problem, const CLI::App* command) {
    static const std::regex repeated(R"((--?[a-z-]+): At Most 1 required but received (\d+))");
    static const std::regex valueless(R"((--?[a-z-]+): 1 required (.+) missing)");
    static const std::regex flagWithValue(R"(Could not convert: (--?[a-z-]+) = .*)");
    static const std::regex dependent(R"((--?[a-z-]+) requires (--?[a-z-]+))");
    std::smatch found;
    if (std::regex_match(problem, found, repeated)) {
        const std::vector<std::string> names = namesOf(command, found[1].str());
        return fmt::format("{} {} {} times; give it once", fmt::join(names, " and "),
                           names.size() > 1 ? "are the same option, given" : "is given", found[2].str());
    }
    if (std::regex_match(problem, found, valueless)) return fmt::format("{0} needs a value: {0} {1}", found[1].str(), found[2].str());
    if (std::regex_match(problem, found, flagWithValue)) return found[1].str() + " takes no value";
    if (std::regex_match(problem, found, dependent)) return fmt::format("{} needs {}; add it", found[1].str(), found[2].str());
    return problem;
}

/// Refuses an empty value, such as that of a variable of the shell that is not set, where it is the name of something.
void refuseEmpty(const CLI::App* command) {
    for (const CLI::Option* option : command->get_options())
        if (option->get_type_name() != freeText && std::ranges::count(option->results(), ""))
            throw UsageError(option->get_positional()
                                 ? fmt::format("{} {} is empty; give a name", command->get_name(), option->get_name(true))
                                 : fmt::format("{} takes {}, not \"\"", option->get_name(), option->get_type_name()));
}

}  // namespace

Options parseOptions(const std::vector<std::string>& arguments) {
    Parser parser;
    Options& options = parser.options;
    std::vector<std::string> words(arguments.empty() ? arguments.begin() : std::next(arguments.begin()), arguments.end());
    words = inOurSpelling(parser, std::move(words));
    std::vector<std::string> reversed(words.rbegin(), words.rend());
    for (const std::string& a : arguments) options.commandLine += (options.commandLine.empty() ? "" : " ") + a;
    try {
        parser.app.parse(reversed);
    } catch (const CLI::CallForHelp&) {
        const auto chosen = parser.app.get_subcommands();
        options.text = chosen.empty() ? parser.app.help() : chosen.front()->help("eikonal");
        return options;
    } catch (const CLI::CallForAllHelp&) {
        options.text = parser.app.help("", CLI::AppFormatMode::All);
        return options;
    } catch (const CLI::CallForVersion& version) {
        options.text = std::string(version.what()) + "\n";
        return options;
    } catch (const CLI::ParseError& error) {
        const auto chosen = parser.app.get_subcommands();
        throw UsageError(fmt::format("{}\n{}", inOurWords(error.what(), chosen.empty() ? nullptr : chosen.front()), getHelp));
    }

    const CLI::App* command = &parser.app;
    for (const auto& [sub, id] : parser.commands)
        if (sub->parsed()) { command = sub; options.command = id; }
    if (const auto extra = command->remaining(); !extra.empty()) refuseExtra(parser, command, extra.front());
    if (const auto extra = parser.app.remaining(); !extra.empty()) refuseExtra(parser, &parser.app, extra.front());
    if (options.preset) {
        words.insert(words.begin(), arguments.front());
        const std::vector<std::string> all = withPreset(words, *options.preset, command);
        if (all.size() > words.size()) {
            Options whole = parseOptions(all);
            whole.commandLine = options.commandLine;
            whole.scene.isSubsurfaceOfPreset = !isGiven(command, "--subsurface");
            return whole;
        }
    }
    if (options.device.list) options.command = Command::listDevices;
    else if (command == &parser.app)
        throw UsageError(fmt::format("nothing to do; try `eikonal render scene.pbrt -o image.exr`\n{}", getHelp));
    if (options.command == Command::render && !options.scenes.empty()) options.scene.path = options.scenes.front();
    refuseEmpty(command);
    options.output.encoding.isShown = options.watch.page;
    if (options.quiet) options.log = std::min(options.log, LogLevel::error);
    chooseFilm(options);
    chooseFrames(options);
    checkTogether(parser, command);
    if (command->get_name() == "man") options.text = manualPage(commandLineTable());
    if (command->get_name() == "completion") options.text = completionScript(parser.shell, commandLineTable());
    options.passedOn = optionsOfGroups(command, {sceneGroup, objGroup, deviceGroup, partsGroup});
    options.passedToMerge = optionsOfGroups(command, {imageGroup});
    options.passedToFrames = optionsOfGroups(command, {framesGroup});
    std::erase_if(options.passedToFrames, [](const std::string& word) { return word.starts_with("--frames="); });
    if (options.command == Command::trade && options.wishes.empty()) options.wishes = usualWishes();
    return options;
}

}  // namespace eikonal
