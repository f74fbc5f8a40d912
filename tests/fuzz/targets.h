#pragma once
// What is fuzzed: the readers of files that people get from others. libFuzzer calls the targets (fuzzer.cpp), and a test calls them with
// every file that is kept (replay_test.cpp).

#include <span>
#include <string>
#include <string_view>

namespace eikonal::fuzz {

/// A reader, and all that is made of what it reads before a device is needed.
struct Target {
    const char* name;   ///< also of its folders in corpus and findings
    /// Reads one input. Returns false for an input that it does not try, because it might name files outside the folder of the inputs.
    /// An Error is a correct answer to any input; every other exception passes through, and is a bug.
    bool (*run)(std::string_view input);
};

std::span<const Target> targets();
/// Throws std::invalid_argument, which lists the names, if there is none.
const Target& targetNamed(const std::string& name);

/* The targets */
bool runPbrt(std::string_view input);         ///< the text of a scene: only read
bool runScene(std::string_view input);        ///< the text of a scene: read and packed
bool runObj(std::string_view input);          ///< the text of an OBJ file and, after a line "#mtl", that of a.mtl
bool runPly(std::string_view input);
bool runLens(std::string_view input);
bool runSpectrum(std::string_view input);
bool runMeasured(std::string_view input);
bool runNanoVdb(std::string_view input);      ///< a file; or "patch" and changes of a good one, 12 bytes each: where, and what is there
bool runExpression(std::string_view input);   ///< F of an implicit surface
bool runImage(std::string_view input);
bool runFilm(std::string_view input);         ///< a checkpoint or part, as it is
bool runMerge(std::string_view input);        ///< parts one after the other, whose checksums are made right; the last byte chooses options

/// The folder of the inputs, which is also the working directory: of this process, removed at its end. It has a copy of tests/fuzz/files.
const std::string& inputFolder();
/// Writes a file into it. Returns its path.
std::string writeInput(const std::string& name, std::string_view content);
/// Whether a text that names files cannot name any outside the folder: it has no "..", and a slash only between numbers. Also false for
/// texts that are compressed, because they hide what they name.
bool staysInFolder(std::string_view text);

}  // namespace eikonal::fuzz
