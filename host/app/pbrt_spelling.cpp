#include "app/pbrt_spelling.h"

#include <algorithm>
#include <cctype>

namespace eikonal {

/// The letters and digits of an option's name, in lower case.
static std::string lettersOf(const std::string& name) {
    std::string letters;
    for (const char c : name)
        if (std::isalnum(static_cast<unsigned char>(c))) letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return letters;
}

std::vector<std::string> withOurSpelling(std::vector<std::string> arguments, const std::vector<std::string>& options) {
    for (std::string& argument : arguments) {
        const size_t first = argument.find_first_not_of('-'), end = std::min(argument.find('='), argument.size());
        const bool isLong = (first == 1 || first == 2) && first + 1 < end && std::isalpha(static_cast<unsigned char>(argument[first]));
        if (!isLong) continue;
        const std::string name = argument.substr(0, end), letters = lettersOf(name);
        for (const std::string& option : options)
            if (lettersOf(option) == letters) argument.replace(0, end, option);
    }
    return arguments;
}

std::string insteadOf(const std::string& name) {
    struct Row { const char *letters, *advice; };
    static constexpr Row rows[] = {
        {"quick", "try --quality draft, or fewer --spp and a smaller --resolution"},
        {"pixel", "try --pixelbounds x,x+1,y,y+1"},
        {"format", "pbrt itself prints a scene in its own format: pbrt --format scene.pbrt"},
        {"toply", "pbrt itself writes meshes as PLY files: pbrt --toply scene.pbrt"},
        {"upgrade", "pbrt itself brings scenes of pbrt-v3 up to date: pbrt --upgrade old.pbrt > scene.pbrt"},
        {"gpu", "try --device with a number or name of `eikonal list-devices`"},
        {"gpudevice", "try --device with a number or name of `eikonal list-devices`"},
        {"interactive", "try --view, which shows the image while it is rendered"},
        {"fullscreen", "try --view, which shows the image while it is rendered"},
        {"wavefront", "leave it away: every scene is rendered in waves"},
        {"renderspace", "leave it away: the space is chosen so that it loses no precision"},
        {"rendercoordsys", "leave it away: the space is chosen so that it loses no precision"},
        {"recordpixelstatistics", "try --aov sampleCount,variance"},
        {"pixelstats", "try --aov sampleCount,variance"},
        {"disablepixeljitter", "write Option \"disablepixeljitter\" true into the scene"},
        {"forcediffuse", "write Option \"forcediffuse\" true into the scene"},
        {"msereferenceimage", "write Option \"msereferenceimage\" \"image.exr\" into the scene"},
        {"msereferenceout", "write Option \"msereferenceout\" \"errors.txt\" into the scene"},
        {"logutilization", "try `eikonal bench`, which measures each stage"},
    };
    for (const Row& row : rows)
        if (lettersOf(name) == row.letters) return row.advice;
    return {};
}

}  // namespace eikonal
