// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/script/native_run.hpp"

#include <csignal>

#include "base/communicator.hpp"
#include "engines/liggghts/plugins/plugin_loader.hpp"
#include "engines/liggghts/script/last_words.hpp"
#include "input.h"
#include "lammps.h"
#include "signal_handling.h"

namespace interphase {

void run_natively(const std::vector<std::string>& arguments, const std::vector<std::string>& plugins)
{
    // as in LIGGGHTS's own main
    std::signal(SIGINT, LAMMPS_NS::SignalHandler::int_handler);
    std::signal(SIGTERM, LAMMPS_NS::SignalHandler::int_handler);
    std::signal(SIGUSR1, LAMMPS_NS::SignalHandler::usr1_handler);

    std::vector<std::string> words{"liggghts"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words)
        argv.push_back(word.data());

    const NativeWords words_of_liggghts;
    // an error leaves it in the middle of something: it cannot be closed then
    auto* const lmp = new LAMMPS_NS::LAMMPS(static_cast<int>(argv.size()), argv.data(), MPI_COMM_WORLD);
    load_plugins(Communicator(), *lmp, plugins, "option -plugin");
    lmp->input->file();
    delete lmp;
}

}  // namespace interphase
