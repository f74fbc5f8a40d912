#include "child_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

namespace eikonal {

/// `direct` says where output and errors go.
template <class Direct> static pid_t start(const std::vector<std::string>& arguments, Direct direct) {
    std::vector<char*> words;
    for (const std::string& a : arguments) words.push_back(const_cast<char*>(a.c_str()));
    words.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    direct(&actions);
    pid_t process = 0;
    const int failure = posix_spawn(&process, "/proc/self/exe", &actions, nullptr, words.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return failure ? 0 : process;
}

pid_t startSelf(const std::vector<std::string>& arguments, const std::string& out, const std::string& err) {
    return start(arguments, [&](posix_spawn_file_actions_t* actions) {
        posix_spawn_file_actions_addopen(actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        posix_spawn_file_actions_addopen(actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    });
}

pid_t startSelf(const std::vector<std::string>& arguments, int out) {
    return start(arguments, [&](posix_spawn_file_actions_t* actions) {
        posix_spawn_file_actions_adddup2(actions, out, STDOUT_FILENO);
        posix_spawn_file_actions_addopen(actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    });
}

int exitStatusOf(pid_t process) {
    int status = 0;
    while (::waitpid(process, &status, 0) < 0)
        if (errno != EINTR) return -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace eikonal
