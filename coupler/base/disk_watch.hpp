// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace interphase {

/// Lives while all ranks write: parallel HDF5 leaves ranks waiting for one another for ever where the disk has become
/// full on the way. Ends them then, on rank 0, with the cause.
class DiskWatch {
public:
    /// `problem`: what to tell.
    DiskWatch(int rank, std::string program, std::string problem);
    ~DiskWatch();
    DiskWatch(const DiskWatch&) = delete;
    DiskWatch& operator=(const DiskWatch&) = delete;

private:
    void watch(const std::string& program, const std::string& problem);

    std::mutex mutex_;
    std::condition_variable changed_;
    bool done_ = false;
    std::thread thread_;
};

}  // namespace interphase
