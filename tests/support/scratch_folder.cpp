// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/scratch_folder.hpp"

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace interphase::test {

ScratchFolder::ScratchFolder(const Communicator& comm) : comm_(comm), before_(std::filesystem::current_path())
{
    std::string name = (std::filesystem::temp_directory_path() / "interphase-test-XXXXXX").string();
    const bool made = !comm_.is_master() || mkdtemp(name.data()) != nullptr;
    if (comm_.any(!made)) throw std::runtime_error("no folder could be made at " + name);
    MPI_Bcast(name.data(), static_cast<int>(name.size()), MPI_CHAR, 0, comm_.handle());
    folder_ = name;
    std::filesystem::current_path(folder_);
}

ScratchFolder::~ScratchFolder()
{
    std::error_code ignored;
    std::filesystem::current_path(before_, ignored);
    comm_.barrier();
    if (comm_.is_master()) std::filesystem::remove_all(folder_, ignored);
}

}  // namespace interphase::test
