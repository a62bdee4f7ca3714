// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "base/communicator.hpp"

namespace interphase::test {

/// A new, empty folder for files that do not last; whoever makes it removes it. std::runtime_error where none can be
/// made.
std::filesystem::path new_folder();

/// A new folder that all ranks work in while this lives; removed with what is in it. Collective.
class ScratchFolder {
public:
    explicit ScratchFolder(const Communicator& comm);
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

private:
    Communicator comm_;
    std::filesystem::path before_;
    std::filesystem::path folder_;
};

}  // namespace interphase::test
