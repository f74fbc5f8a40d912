// Texts that are made of the declarations of options: they name every option, and shells complete as they say.

#include "app/command_line.h"
#include "unit/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <memory>
#include <regex>

namespace eikonal {
namespace {

using testing::HasSubstr;

class Completion : public TemporaryFolder {
protected:
    const std::vector<CommandDescription> table = commandLineTable();

    /// What a command of a POSIX shell prints, errors too.
    std::string printedBy(const std::string& command) const {
        std::string text;
        const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(::popen((command + " 2>&1").c_str(), "r"), ::pclose);
        for (int c; (c = std::fgetc(pipe.get())) != EOF;) text += static_cast<char>(c);
        return text;
    }
    static bool has(const std::string& shell) { return std::system(("command -v " + shell + " >/dev/null").c_str()) == 0; }
    std::string script(const std::string& shell) const { return write(shell, completionScript(shell, table)); }

    /// The words that bash offers after `line`, the last of which is being written.
    std::string bash(const std::string& line) const {
        return printedBy("bash -c 'compopt() { :; }; source " + script("bash") + "; COMP_WORDS=(" + line +
                         "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _eikonal; echo -n \"${COMPREPLY[*]}\"'");
    }
};

TEST_F(Completion, EveryOptionIsInEachText) {
    const std::string bash = completionScript("bash", table), zsh = completionScript("zsh", table), fish = completionScript("fish", table);
    const std::string page = manualPage(table);
    int options = 0;
    for (const CommandDescription& command : table)
        for (const OptionDescription& option : command.options)
            for (const std::string& name : option.names) {
                ++options;
                EXPECT_THAT(bash, HasSubstr(name));
                EXPECT_THAT(zsh, HasSubstr("*" + name));
                EXPECT_THAT(fish, HasSubstr(name.starts_with("--") ? " -l " + name.substr(2) + " " : " -s " + name.substr(1)));
                EXPECT_THAT(page, HasSubstr("\\fB" + std::regex_replace(name, std::regex("-"), "\\-") + "\\fR"));
            }
    EXPECT_GT(options, 100);
}

TEST_F(Completion, BashOffersCommandsOptionsAndValues) {
    EXPECT_EQ(bash("eikonal ren"), "render");
    EXPECT_EQ(bash("eikonal help comp"), "compare completion");
    EXPECT_EQ(bash("eikonal render --check"), "--checkpoint --checkpoint-every");
    EXPECT_EQ(bash("eikonal render a.pbrt --quality \"\""), "draft preview final reference");
    EXPECT_EQ(bash("eikonal render a.pbrt --quality = d"), "draft");
    EXPECT_EQ(bash("eikonal render a.pbrt -o \"\""), "") << "files";
    EXPECT_EQ(bash("eikonal render a.pbrt \"\""), "") << "files";
    EXPECT_EQ(bash("eikonal completion z"), "zsh");
}

TEST_F(Completion, ZshAndFishReadTheirScripts) {
    if (has("zsh")) { EXPECT_EQ(printedBy("zsh -n " + script("zsh")), ""); }
    if (!has("fish")) return;
    const auto fish = [&](const std::string& line) {
        return printedBy("fish --no-config -c 'source " + script("fish") + "; complete -C \"eikonal " + line + "\"'");
    };
    EXPECT_THAT(fish("ren"), testing::StartsWith("render\tRender a scene"));
    EXPECT_THAT(fish("render --qual"), testing::StartsWith("--quality\t"));
    EXPECT_THAT(fish("render --quality pre"), testing::StartsWith("preview"));
}

TEST_F(Completion, ManReadsThePageWithoutComplaint) {
    if (!has("man")) GTEST_SKIP();
    EXPECT_EQ(printedBy("LC_ALL=C.UTF-8 MANROFFSEQ= MANWIDTH=80 man --warnings -E UTF-8 -l " + write("eikonal.1", manualPage(table)) +
                        " >/dev/null"), "");
}

}  // namespace
}  // namespace eikonal
