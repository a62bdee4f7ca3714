// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/scratch_folder.hpp"

#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>

namespace interphase::test {

std::filesystem::path new_folder()
{
    std::string name =
        (std::filesystem::temp_directory_path() / "interphase-test-XXXXXX").string();  // mkdtemp's pattern
    if (!mkdtemp(name.data())) throw std::runtime_error("no folder could be made at " + name);
    return name;
}

ScratchFolder::ScratchFolder(const Communicator& comm) : comm_(comm), before_(std::filesystem::current_path())
{
    std::string name;
    std::optional<Problem> problem;
    try {
        if (comm_.is_master()) name = new_folder().string();
    } catch (const std::runtime_error& error) {
        problem = Problem{error.what(), "", ""};
    }
    comm_.fail_together(problem);
    auto length = static_cast<int>(name.size());
    MPI_Bcast(&length, 1, MPI_INT, 0, comm_.handle());
    name.resize(static_cast<std::size_t>(length));
    MPI_Bcast(name.data(), length, MPI_CHAR, 0, comm_.handle());
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
