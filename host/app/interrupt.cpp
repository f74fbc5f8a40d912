#include "app/interrupt.h"

#include <csignal>
#include <initializer_list>
#include <unistd.h>

namespace eikonal {

constexpr int stopSignals[] = {SIGHUP, SIGINT, SIGTERM};
static volatile std::sig_atomic_t noted = 0;

extern "C" void noteSignal(int number) {
    if (noted) ::_exit(signalStatus + number);
    noted = number;
}

void keepIgnoredSignals() {
    sigset_t ignored;
    sigemptyset(&ignored);
    for (const int number : {SIGHUP, SIGINT, SIGQUIT, SIGTERM}) {
        struct sigaction action {};
        if (::sigaction(number, nullptr, &action) == 0 && action.sa_handler == SIG_IGN) sigaddset(&ignored, number);
    }
    ::pthread_sigmask(SIG_BLOCK, &ignored, nullptr);
}

Interrupt::Interrupt() {
    noted = 0;
    struct sigaction action {};
    action.sa_handler = noteSignal;
    action.sa_flags = SA_RESTART;
    for (const int number : stopSignals) ::sigaction(number, &action, nullptr);
}

Interrupt::~Interrupt() {
    for (const int number : stopSignals) std::signal(number, SIG_DFL);
}

void Interrupt::request() {
    if (!noted) noted = SIGINT;
}

int Interrupt::signal() { return noted; }

}  // namespace eikonal
