// The manual page.

#include "app/command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace eikonal {
namespace {

/// `text` for man(7): what it would read as a request, an escape or a hyphen is written out.
std::string roff(const std::string& text) {
    std::string result = !text.empty() && (text.front() == '.' || text.front() == '\'') ? "\\&" : "";
    for (const char c : text) result += c == '\\' ? "\\e" : c == '-' ? "\\-" : c == '\'' ? "\\(aq" : c == '`' ? "\\(ga" : std::string(1, c);
    return result;
}

std::string bold(const std::string& text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + roff(text) + "\\fR"; }

std::string optionEntry(const OptionDescription& option) {
    std::string names;
    for (const std::string& name : option.names) names += (names.empty() ? "" : ", ") + bold(name);
    if (option.value != ValueHint::none) names += " " + italic(option.type);
    return fmt::format(".TP\n{}\n{}.\n", names, roff(option.help));
}

std::string optionEntries(const CommandDescription& command) {
    std::string text, group = "Options";
    for (const OptionDescription& option : command.options) {
        if (option.group != group) text += fmt::format(".PP\n{}:\n", roff(option.group));
        group = option.group;
        text += optionEntry(option);
    }
    return text;
}

std::string argumentsOf(const CommandDescription& command) {
    std::string text;
    for (const OptionDescription& argument : command.arguments) text += " " + italic(argument.names.front());
    return text;
}

}  // namespace

std::string manualPage(const std::vector<CommandDescription>& commands) {
    std::string page = fmt::format(".\\\" Made by `eikonal man`.\n"
                                   ".TH EIKONAL 1 \"\" \"Eikonal {}\" \"User Commands\"\n", roff(EIKONAL_VERSION));
    page += ".SH NAME\neikonal \\- render scenes by path tracing on OpenCL devices\n.SH SYNOPSIS\n";
    for (const CommandDescription& command : commands)
        if (!command.name.empty())
            page += fmt::format("{} {}{} [\\fIoption\\fR ...]\n.br\n", bold("eikonal"), bold(command.name), argumentsOf(command));
    page += fmt::format("{} {} [\\fIcommand\\fR]\n", bold("eikonal"), bold("help"));
    page += ".SH DESCRIPTION\nA scene is written in the language of pbrt\\-v4, or it is a Wavefront OBJ. "
            "Options override what the scene says. "
            "Capitals, dashes and underscores in the name of an option do not matter, and its value may follow an equals sign.\n";
    for (const CommandDescription& command : commands) {
        if (command.name.empty()) page += ".SH OPTIONS\n";
        else page += fmt::format(".SH \"EIKONAL {}\"\n{}.\n", roff(command.name), roff(command.help));
        for (const OptionDescription& argument : command.arguments)
            page += fmt::format(".TP\n{}\n{}.\n", italic(argument.names.front()), roff(argument.help));
        page += optionEntries(command);
    }
    constexpr std::pair<const char*, const char*> statuses[] = {
        {"0", "success"}, {"1", "an error in the scene or a file"}, {"2", "an error in the command line"},
        {"3", "an error of the OpenCL device"},
        {"4", "a valid image is on disk, but not all of its samples"}, {"128+N", "ended early by signal N; the image so far is on disk"}};
    page += ".SH \"EXIT STATUS\"\n";
    for (const auto& [status, meaning] : statuses) page += fmt::format(".TP\n{}\n{}.\n", bold(status), roff(meaning));
    page += ".SH EXAMPLES\n.nf\n";
    for (const char* example : {"eikonal render scene.pbrt -o image.exr --spp 256",
                                "eikonal render model.obj --camera 4,2,6 --look-at 0,1,0",
                                "eikonal trade scene.pbrt --for 30s --for 2%", "eikonal compare image.exr reference.exr"})
        page += roff(example) + "\n";
    return page + ".fi\n";
}

}  // namespace eikonal
