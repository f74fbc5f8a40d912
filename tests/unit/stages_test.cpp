// What stages.h and the head of each kernel file say a stage reads and writes is what its arguments let it read and write.

#include "device/source.h"
#include "eikonal/queues.h"
#include "eikonal/stages.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

namespace eikonal {
namespace {

using Names = std::set<std::string>;

struct StageCase { std::string name; Names reads, writes; };
void PrintTo(const StageCase& c, std::ostream* out) { *out << c.name; }

Names wordsOf(const std::string& text) {
    static const std::regex word("[a-z_]+");
    Names names;
    for (std::sregex_iterator i(text.begin(), text.end(), word), end; i != end; ++i) names.insert(i->str());
    return names;
}

/// What a stage can read or write: queues, the film, and the pixels of a tile, which are no buffer.
Names queuesAmong(const Names& words) {
    static const Names all = [] {
        Names names{"film", "pixels"};
#define NAME_QUEUE(q, FIELDS) names.insert(#q);
        QUEUES(NAME_QUEUE)
        return names;
    }();
    Names found;
    for (const std::string& w : words)
        if (all.count(w)) found.insert(w);
    return found;
}

std::vector<StageCase> stageCases() {
    std::vector<StageCase> cases;
#define ADD_CASE(name, reads, writes, FEATURE) cases.push_back({#name, wordsOf(reads), wordsOf(writes)});
    STAGES(ADD_CASE)
    return cases;
}

std::string textOf(const std::string& stage) {
    std::ifstream file(std::filesystem::path(findKernelFolders().kernels) / "stages" / (stage + ".cl"));
    return {std::istreambuf_iterator<char>(file), {}};
}

/// The names of a kernel's queues, those that it may write or those that it may only read. next_ray is the ray queue of the next bounce.
Names queueArguments(const std::string& arguments, bool written) {
    static const std::regex buffer(R"(__global (const )?uint \*, (?:next_)?([a-z_]+)\))");
    Names names;
    for (std::sregex_iterator i(arguments.begin(), arguments.end(), buffer), end; i != end; ++i)
        if ((*i)[1].matched != written) names.insert((*i)[2]);
    return queuesAmong(names);
}

class StageQueues : public testing::TestWithParam<StageCase> {};

TEST_P(StageQueues, AreTheArgumentsOfItsKernel) {
    const StageCase& stage = GetParam();
    const std::string text = textOf(stage.name);
    std::smatch kernel;
    ASSERT_TRUE(std::regex_search(text, kernel, std::regex(R"(#define ([A-Z_]+)\(TABLE, ARGUMENT\)((?:.*\\\n)*.*)\n(?:TRACING_)?STAGE\()" + stage.name + R"(, \1\) \{)")));
    EXPECT_EQ(queueArguments(kernel[2], true), stage.writes);
    /* What is not const may be read as well, where the list says so */
    Names readable = queueArguments(kernel[2], false);
    for (const std::string& q : stage.reads)
        if (stage.writes.count(q) || q == "pixels") readable.insert(q);
    EXPECT_EQ(readable, stage.reads);
}

TEST_P(StageQueues, AreSaidInTheHeadOfItsFile) {
    const StageCase& stage = GetParam();
    const std::string text = textOf(stage.name);
    std::smatch head;
    ASSERT_TRUE(std::regex_search(text, head, std::regex(R"(^/\* ([^>]*) -> ([^.]*)\.)"))) << "/* what it reads -> what it writes. ...";
    EXPECT_EQ(queuesAmong(wordsOf(head[1])), stage.reads);
    EXPECT_EQ(queuesAmong(wordsOf(head[2])), stage.writes);
}

INSTANTIATE_TEST_SUITE_P(Stages, StageQueues, testing::ValuesIn(stageCases()), [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace eikonal
