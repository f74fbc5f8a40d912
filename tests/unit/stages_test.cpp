// What stages.h and the head of each kernel file say a stage reads and writes is what its arguments let it read and write.

#include "device/source.h"
#include "render/stage_table.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

namespace eikonal {

static void PrintTo(const StageRow& stage, std::ostream* out) { *out << stage.name; }

namespace {

using Names = std::set<std::string>;

Names namesOf(const QueueList& queues) {
    Names names;
    for (Queue queue : queues) names.insert(nameOf(queue));
    return names;
}

Names wordsOf(const std::string& text) {
    static const std::regex word("[a-z_]+");
    Names names;
    for (std::sregex_iterator i(text.begin(), text.end(), word), end; i != end; ++i) names.insert(i->str());
    return names;
}

/// What a stage can read or write.
Names queuesAmong(const Names& words) {
    static const Names all = [] {
        Names names = namesOf({Queue::next_ray, Queue::pixels, Queue::film, Queue::splat, Queue::cached, Queue::vertex, Queue::grid,
                                 Queue::counts});
        for (const QueueRow& queue : queueTable) names.insert(queue.name);
        return names;
    }();
    Names found;
    for (const std::string& w : words)
        if (all.count(w)) found.insert(w);
    return found;
}

std::string textOf(const std::string& stage) {
    std::ifstream file(std::filesystem::path(findKernelFolders().kernels) / "stages" / (stage + ".cl"));
    return {std::istreambuf_iterator<char>(file), {}};
}

/// What declares a kernel of this form.
std::string macroOf(StageForm form) {
    return form == StageForm::straight_line ? "STAGE" : form == StageForm::tracing ? "TRACING_STAGE" : "COUNTING_STAGE";
}

/// The names of a kernel's queues, those that it may write or those that it may only read.
Names queueArguments(const std::string& arguments, bool written) {
    static const std::regex buffer(R"(__global (const )?uint \*, ([a-z_]+)\))");
    Names names;
    for (std::sregex_iterator i(arguments.begin(), arguments.end(), buffer), end; i != end; ++i)
        if ((*i)[1].matched != written) names.insert((*i)[2]);
    return queuesAmong(names);
}

class StageQueues : public testing::TestWithParam<StageRow> {};

TEST_P(StageQueues, AreTheArgumentsOfItsKernel) {
    const StageRow& stage = GetParam();
    const Names reads = namesOf(stage.reads), writes = namesOf(stage.writes);
    const std::string text = textOf(stage.name);
    std::smatch kernel;
    const std::regex declaration(R"(#define ([A-Z_]+)\(TABLE, ARGUMENT\)((?:.*\\\n)*.*)\n)" + macroOf(stage.form) + R"(\()" + stage.name +
                                 R"(, \1\) \{)");
    ASSERT_TRUE(std::regex_search(text, kernel, declaration));
    EXPECT_EQ(queueArguments(kernel[2], true), writes);
    /* What is not const may be read as well, where the list says so */
    Names readable = queueArguments(kernel[2], false);
    for (const std::string& q : reads)
        if (writes.count(q) || q == "pixels") readable.insert(q);
    EXPECT_EQ(readable, reads);
}

TEST_P(StageQueues, AreSaidInTheHeadOfItsFile) {
    const StageRow& stage = GetParam();
    const Names reads = namesOf(stage.reads), writes = namesOf(stage.writes);
    const std::string text = textOf(stage.name);
    std::smatch head;
    ASSERT_TRUE(std::regex_search(text, head, std::regex(R"(^/\* ([^>]*) -> ([^.]*)\.)"))) << "/* what it reads -> what it writes. ...";
    EXPECT_EQ(queuesAmong(wordsOf(head[1])), reads);
    EXPECT_EQ(queuesAmong(wordsOf(head[2])), writes);
}

/// The order of STAGES: the items of a stage come from one before it. What else it reads may be of the bounce before.
TEST(StageTable, DrainsWhatAnEarlierStageFills) {
    std::set<Queue> filled{Queue::pixels}, filledByAny;
    for (const StageRow& stage : stageTable) filledByAny.insert(stage.writes.begin(), stage.writes.end());
    for (const StageRow& stage : stageTable) {
        const Queue drained = *stage.reads.begin();
        EXPECT_TRUE(filled.contains(drained)) << stage.name << " drains " << nameOf(drained);
        for (Queue queue : stage.reads)
            EXPECT_TRUE(queue == Queue::pixels || filledByAny.contains(queue)) << stage.name << " reads " << nameOf(queue);
        filled.insert(stage.writes.begin(), stage.writes.end());
    }
}

/// A queue is there wherever a stage is that drains it.
TEST(StageTable, RequiresNoMoreOfAQueueThanOfTheStageThatDrainsIt) {
    for (const StageRow& stage : stageTable) {
        const Queue drained = *stage.reads.begin();
        if (static_cast<size_t>(drained) >= queueCount) continue;   // memory that is not of a wave
        const Requirement queue = rowOf(drained).requirement;
        EXPECT_TRUE(queue == Requirement() || queue == stage.requirement) << stage.name;
    }
}

INSTANTIATE_TEST_SUITE_P(Stages, StageQueues, testing::ValuesIn(stageTable), [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace eikonal
