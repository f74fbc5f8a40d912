// The memory that is left to a program: of the machine, and of the control groups that it runs in.

#include "available_memory.h"

#include "unit/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>

namespace eikonal {
namespace {

class AvailableMemory : public TemporaryFolder {
protected:
    void put(const std::string& file, const std::string& text) {
        std::filesystem::create_directories(std::filesystem::path(path(file)).parent_path());
        write(file, text);
    }
    void putMachine() { put("proc/meminfo", "MemTotal: 9000 kB\nMemAvailable: 4000 kB\nSwapFree: 1000 kB\n"); }
    std::size_t left() const { return availableMemory(folder_.string()); }
};

TEST_F(AvailableMemory, isThatOfTheMachine) {
    EXPECT_EQ(left(), std::numeric_limits<std::size_t>::max()) << "Linux tells nothing";
    putMachine();
    EXPECT_EQ(left(), 5000u * 1024);
}

// The smallest of the group and those around it counts; "max" is no limit.
TEST_F(AvailableMemory, isThatOfControlGroups) {
    putMachine();
    put("proc/self/cgroup", "0::/job/step\n");
    put("sys/fs/cgroup/job/step/memory.max", "max\n");
    put("sys/fs/cgroup/job/step/memory.current", "100\n");
    EXPECT_EQ(left(), 5000u * 1024);
    put("sys/fs/cgroup/job/memory.max", "1000000\n");
    put("sys/fs/cgroup/job/memory.current", "300000\n");
    EXPECT_EQ(left(), 700000u);
    put("sys/fs/cgroup/job/memory.stat", "anon 1\ninactive_file 200000\n");
    EXPECT_EQ(left(), 900000u) << "pages of files are given up";
    put("sys/fs/cgroup/memory.max", "1000\n");  // as a container sees it
    put("sys/fs/cgroup/memory.current", "5000\n");
    EXPECT_EQ(left(), 0u);
}

TEST_F(AvailableMemory, isThatOfControlGroupsOfTheFirstVersion) {
    putMachine();
    put("proc/self/cgroup", "3:cpu,cpuacct:/a\n2:memory:/b\n");
    put("sys/fs/cgroup/memory/b/memory.limit_in_bytes", "1000000\n");
    put("sys/fs/cgroup/memory/b/memory.usage_in_bytes", "250000\n");
    EXPECT_EQ(left(), 750000u);
}

// Rows of /proc/self/status are a name, a number and a unit, or a name and words.
TEST_F(AvailableMemory, whatIsOccupiedIsReadFromTheProcess) {
    EXPECT_EQ(occupiedMemory(folder_.string()).most, 0u) << "Linux tells nothing";
    put("proc/self/status", "Name:\teikonal\nState:\tR (running)\nVmHWM:\t   300 kB\nVmRSS:\t   200 kB\n");
    const OccupiedMemory occupied = occupiedMemory(folder_.string());
    EXPECT_EQ(occupied.now, 200u * 1024);
    EXPECT_EQ(occupied.most, 300u * 1024);
}

}  // namespace
}  // namespace eikonal
