// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/disk_watch.hpp"

#include <chrono>
#include <cstdio>
#include <utility>

#include "base/disk_room.hpp"
#include "base/stop_together.hpp"

namespace interphase {

DiskWatch::DiskWatch(int rank, std::string program, std::string problem)
{
    if (rank == 0)
        thread_ = std::thread([this, named = std::move(program), told = std::move(problem)] { watch(named, told); });
}

DiskWatch::~DiskWatch()
{
    {
        const std::lock_guard lock(mutex_);
        done_ = true;
    }
    changed_.notify_one();
    if (thread_.joinable()) thread_.join();
}

void DiskWatch::watch(const std::string& program, const std::string& problem)
{
    constexpr std::chrono::seconds between_looks(3);
    std::unique_lock lock(mutex_);
    while (!changed_.wait_for(lock, between_looks, [this] { return done_; })) {
        if (!disk_is_full(0)) continue;  // a large snapshot may take its time
        std::fprintf(stderr, "\n%s: error: %s\n", program.c_str(), problem.c_str());
        end_all_ranks(MPI_COMM_WORLD, static_cast<int>(ExitCode::disk));
    }
}

}  // namespace interphase
