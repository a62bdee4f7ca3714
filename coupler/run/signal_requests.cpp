// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/signal_requests.hpp"

#include <csignal>

namespace interphase {

namespace {

volatile std::sig_atomic_t noted = 0, checkpoint_asked = 0;

void note(int number)
{
    if (number == SIGUSR1) {
        checkpoint_asked = 1;
        return;
    }
    if (noted) {
        std::signal(number, SIG_DFL);
        std::raise(number);  // takes effect when this returns; the process ends by it, as the shell expects
    }
    noted = number;
}

}  // namespace

SignalRequests::SignalRequests()
{
    noted = checkpoint_asked = 0;
    struct sigaction action = {};
    action.sa_handler = note;
    action.sa_flags = SA_RESTART;  // reading, writing and waiting go on
    sigemptyset(&action.sa_mask);
    for (std::size_t i = 0; i < signals.size(); ++i) {
        sigaction(signals[i], nullptr, &before_[i]);
        if (before_[i].sa_handler != SIG_IGN)
            sigaction(signals[i], &action, nullptr);  // as of nohup and `&` in scripts
    }
}

SignalRequests::~SignalRequests()
{
    for (std::size_t i = 0; i < signals.size(); ++i)
        sigaction(signals[i], &before_[i], nullptr);
}

int SignalRequests::end() const { return noted; }

bool SignalRequests::take_checkpoint()
{
    const bool asked = checkpoint_asked != 0;
    checkpoint_asked = 0;
    return asked;
}

const char* SignalRequests::name_of(int signal)
{
    switch (signal) {
        case SIGINT:
            return "SIGINT";
        case SIGTERM:
            return "SIGTERM";
        case SIGUSR2:
            return "SIGUSR2";
        default:
            return "a signal";
    }
}

}  // namespace interphase
