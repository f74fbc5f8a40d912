// docs/pbrt.md tells what is read and rendered: its table is that of the reader.

#include "read/pbrt/directives.h"
#include "read/pbrt/lights.h"
#include "read/pbrt/materials.h"
#include "read/pbrt/media.h"
#include "read/pbrt/setting_kinds.h"
#include "read/pbrt/shapes.h"
#include "read/pbrt/textures.h"
#include "read/pbrt/without_effect.h"
#include "test_paths.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace eikonal::pbrt {
namespace {

std::string document() {
    std::stringstream text;
    text << std::ifstream(EIKONAL_SOURCE_DIR "/docs/pbrt.md").rdbuf();
    return text.str();
}

/// A row: what a directive renders, and what happens instead of what it only reads.
std::string row(const std::string& title, const KindTable& table, bool areTextures = false) {
    std::string rendered;
    std::vector<std::pair<std::string, std::string>> groups;  // kinds with the same stand-in
    for (const Kind& kind : table.kinds()) {
        const std::string name = kind.name.empty() ? "`\"\"`" : "`" + kind.name + "`";
        if (!kind.standIn) {
            rendered += ' ' + name;
            continue;
        }
        const std::string instead = areTextures ? textureStandIn(kind) : kind.standIn;
        const auto group = std::ranges::find(groups, instead, &std::pair<std::string, std::string>::second);
        if (group == groups.end()) groups.emplace_back(name, instead);
        else group->first += ' ' + name;
    }
    std::string read;
    for (const auto& [names, instead] : groups) read += (read.empty() ? " " : "<br>") + names + ": " + instead;
    return "| `" + title + "` |" + rendered + " |" + read + " |\n";
}

TEST(PbrtDocs, theTableOfKindsIsThatOfTheReader) {
    std::string table = "| Directive | Rendered | Read; what happens instead |\n|---|---|---|\n";
    const char* const settings[] = {"Camera", "Film", "PixelFilter", "Sampler", "Integrator", "Accelerator"};
    const std::vector<const KindTable*> tables = settingKinds();
    ASSERT_EQ(tables.size(), std::size(settings));
    for (size_t i = 0; i < tables.size(); ++i) table += row(settings[i], *tables[i]);
    table += row("LightSource", lightKinds()) + row("AreaLightSource", areaLightKinds()) + row("Shape", shapeKinds()) +
             row("Material", materialKinds()) + row("Texture float", textureKinds(true), true) +
             row("Texture spectrum", textureKinds(false), true) + row("MakeNamedMedium", mediumKinds());

    const std::string text = document();
    EXPECT_NE(text.find(table), text.npos) << "docs/pbrt.md must hold this table:\n" << table;
}

/// A table of what has no effect; what is there for the same reason shares a row.
std::string tableOf(Answer answer, const std::string& heading) {
    std::vector<std::pair<std::string, std::string>> rows;   // what, why
    for (const WithoutEffect& line : withoutEffect()) {
        if (line.answer != answer) continue;
        std::string what = line.noun;
        if (line.kind) what += fmt::format(" `{}`", line.kind);
        if (line.parameter) what += fmt::format(" `{}`", line.parameter);
        else if (!line.kind) what += ": all parameters";
        if (line.value) what += fmt::format(" `\"{}\"`", line.value);
        if (!rows.empty() && rows.back().second == line.why) rows.back().first += ", " + what;
        else rows.emplace_back(what, line.why);
    }
    std::string table = heading + "\n|---|---|\n";
    for (const auto& [what, why] : rows) table += fmt::format("| {} | {} |\n", what, why);
    return table;
}

TEST(PbrtDocs, theListOfWhatHasNoEffectIsThatOfTheReader) {
    const std::string text = document();
    for (const std::string& table : {tableOf(Answer::warning, "| Warned about | Why it has no effect |"),
                                     tableOf(Answer::silence, "| Read without a warning | Why it has no effect |")})
        EXPECT_NE(text.find(table), text.npos) << "docs/pbrt.md must hold this table:\n" << table;
}

TEST(PbrtDocs, everyDirectiveIsNamed) {
    const std::string text = document();
    for (const std::string& name : directiveNames())
        EXPECT_NE(text.find('`' + name + '`'), text.npos) << "docs/pbrt.md does not name " << name;
}

}  // namespace
}  // namespace eikonal::pbrt
