#pragma once
// Runs this program again, as a process of its own.

#include <sys/types.h>

#include <string>
#include <vector>

namespace eikonal {

/// Starts this program. `arguments` begins with its name. Its standard input is empty, its output and errors go to files, which are
/// replaced. Returns its process id, or 0 on failure.
pid_t startSelf(const std::vector<std::string>& arguments, const std::string& out = "/dev/null", const std::string& err = "/dev/null");

/// The same; its output goes to the file descriptor `out`, its errors nowhere.
pid_t startSelf(const std::vector<std::string>& arguments, int out);

/// Waits until a process has ended, and returns its exit status, or -1 if a signal ended it.
int exitStatusOf(pid_t process);

}  // namespace eikonal
