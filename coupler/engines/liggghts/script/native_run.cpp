// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/script/native_run.hpp"

#include <csignal>
#include <memory>

#include "base/communicator.hpp"
#include "engines/liggghts/plugins/plugin_loader.hpp"
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

    const auto lmp = std::make_unique<LAMMPS_NS::LAMMPS>(static_cast<int>(argv.size()), argv.data(), MPI_COMM_WORLD);
    load_plugins(Communicator(), *lmp, plugins, "option -plugin");
    lmp->input->file();
}

}  // namespace interphase
