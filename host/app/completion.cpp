// Completion scripts for shells.

#include "app/command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

namespace eikonal {
namespace {

std::string joined(const std::vector<std::string>& words, const char* between = " ") {
    return fmt::format("{}", fmt::join(words, between));
}

std::vector<std::string> namesOf(const std::vector<CommandDescription>& commands) {
    std::vector<std::string> names;
    for (const CommandDescription& command : commands)
        if (!command.name.empty()) names.push_back(command.name);
    return names;
}

/// `text` with a backslash before each of `special`.
std::string escaped(const std::string& text, const std::string& special) {
    std::string result;
    for (const char c : text) {
        if (special.find(c) != std::string::npos) result += '\\';
        result += c;
    }
    return result;
}

/// `text` in single quotes, inside which zsh and bash read nothing but a quote.
std::string singleQuoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

// ---- bash ------------------------------------------------------------------------------------------------------------------------------
/// The case of a value: words, nothing, or, by default, files.
std::string bashValue(const OptionDescription& option) {
    if (option.value == ValueHint::file) return "return";
    if (option.value == ValueHint::folder) return "compopt -o dirnames +o default; return";
    return fmt::format("words='{}'; compopt +o default", joined(option.words));
}

std::string bash(const std::vector<CommandDescription>& commands) {
    std::string values, words, arguments;
    for (const CommandDescription& command : commands) {
        std::vector<std::string> all;
        for (const OptionDescription& option : command.options) {
            all.insert(all.end(), option.names.begin(), option.names.end());
            if (option.value == ValueHint::none) continue;
            const std::string names = joined(option.names, fmt::format("|{}:", command.name).c_str());
            values += fmt::format("        {0}:{1}) {2} ;;\n", command.name, names, bashValue(option));
        }
        words += fmt::format("        {}) words='{}' ;;\n", command.name.empty() ? "''" : command.name, joined(all));
        for (const OptionDescription& argument : command.arguments)
            if (!argument.words.empty()) arguments += fmt::format("        {}) words='{}' ;;\n", command.name, joined(argument.words));
    }
    const std::string names = joined(namesOf(commands));
    return fmt::format(R"(# Completion of eikonal for bash. Made by `eikonal completion bash`.
_eikonal() {{
    local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}} command= words= i
    # --name=value arrives as three words
    if [[ $current == = ]]; then current=
    elif [[ $previous == = ]]; then previous=${{COMP_WORDS[COMP_CWORD-2]}}; fi
    for ((i = 1; i < COMP_CWORD; ++i)); do
        case ${{COMP_WORDS[i]}} in {0}|help) command=${{COMP_WORDS[i]}}; break ;; esac
    done
    COMPREPLY=()
    case $command:$previous in
{1}        *) if [[ $current == -* ]]; then
        case $command in
{2}        esac
    else
        case $command in
        ''|help) words='{3}'; [[ $command ]] || words+=' help' ;;
{4}        esac
    fi ;;
    esac
    COMPREPLY=($(compgen -W "$words" -- "$current"))
}}
complete -o default -F _eikonal eikonal
)",
                       joined(namesOf(commands), "|"), values, words, names, arguments);
}

// ---- zsh -------------------------------------------------------------------------------------------------------------------------------
std::string zshAction(const OptionDescription& option) {
    if (!option.words.empty()) return fmt::format("({})", joined(option.words));
    return option.value == ValueHint::file ? "_files" : option.value == ValueHint::folder ? "_files -/" : " ";
}

std::string zshOption(const OptionDescription& option) {
    std::string lines;
    for (const std::string& name : option.names) {
        const bool takesValue = option.value != ValueHint::none, isLong = name.starts_with("--");
        std::string spec = "*" + name + (takesValue && isLong ? "=" : "") + "[" + escaped(option.help, "[]\\") + "]";
        if (takesValue) spec += ":" + escaped(option.type, ":\\") + ":" + zshAction(option);
        lines += " \\\n            " + singleQuoted(spec);
    }
    return lines;
}

std::string zsh(const std::vector<CommandDescription>& commands) {
    std::string list, cases, general;
    for (const CommandDescription& command : commands) {
        std::string specs;
        for (const OptionDescription& option : command.options) specs += zshOption(option);
        if (command.name.empty()) { general = specs; continue; }
        for (const OptionDescription& argument : command.arguments)
            specs += " \\\n            " + singleQuoted("*:" + argument.names.front() + ":" + zshAction(argument));
        list += "    " + singleQuoted(escaped(command.name, ":") + ":" + command.help) + "\n";
        cases += fmt::format("        ({}) _arguments{} ;;\n", command.name, specs);
    }
    return fmt::format(R"(#compdef eikonal
# Completion of eikonal for zsh. Made by `eikonal completion zsh`.
_eikonal() {{
    local context state line curcontext=$curcontext
    local -a commands
    commands=(
{}    'help:Print the options of a command'
    )
    _arguments -C{} \
            '1:command:->command' '*::argument:->arguments'
    case $state in
    (command) _describe command commands ;;
    (arguments)
        case $words[1] in
        (help) _describe command commands ;;
{}        esac ;;
    esac
}}
_eikonal "$@"
)",
                       list, general, cases);
}

// ---- fish ------------------------------------------------------------------------------------------------------------------------------
/// Single quotes of fish take \' and \\.
std::string fishQuoted(const std::string& text) { return "'" + escaped(text, "'\\") + "'"; }

std::string fishOption(const std::string& condition, const OptionDescription& option) {
    std::string line = fmt::format("complete -c eikonal -n {}", fishQuoted(condition));
    for (const std::string& name : option.names)
        line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    if (option.value == ValueHint::file) line += " -r -F";
    if (option.value == ValueHint::folder) line += " -x -a '(__fish_complete_directories)'";
    if (option.value == ValueHint::text) line += " -x" + (option.words.empty() ? "" : " -a " + fishQuoted(joined(option.words)));
    return line + " -d " + fishQuoted(option.help) + "\n";
}

std::string fish(const std::vector<CommandDescription>& commands) {
    const std::string none = "__fish_use_subcommand", names = joined(namesOf(commands));
    std::string script = "# Completion of eikonal for fish. Made by `eikonal completion fish`.\n";
    script += fmt::format("complete -c eikonal -n {} -f -a help -d 'Print the options of a command'\n", none);
    script += fmt::format("complete -c eikonal -n '__fish_seen_subcommand_from help' -f -a '{}'\n", names);
    for (const CommandDescription& command : commands) {
        const std::string condition = command.name.empty() ? none : "__fish_seen_subcommand_from " + command.name;
        if (!command.name.empty())
            script += fmt::format("complete -c eikonal -n {} -f -a {} -d {}\n", none, command.name, fishQuoted(command.help));
        for (const OptionDescription& option : command.options) script += fishOption(condition, option);
        for (const OptionDescription& argument : command.arguments)
            if (!argument.words.empty())
                script += fmt::format("complete -c eikonal -n {} -f -a {}\n", fishQuoted(condition), fishQuoted(joined(argument.words)));
    }
    return script;
}

}  // namespace

std::string completionScript(const std::string& shell, const std::vector<CommandDescription>& commands) {
    if (shell == "bash") return bash(commands);
    if (shell == "zsh") return zsh(commands);
    if (shell == "fish") return fish(commands);
    throw std::logic_error("no completion for " + shell);
}

}  // namespace eikonal
