// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/disk_room.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <vector>

namespace interphase {

bool disk_is_full(int asker)
{
    const std::string name = ".room-on-disk-" + std::to_string(asker);
    const std::vector<char> tried(64 * 1024, 'x');
    const auto full = [](bool failed) { return failed && (errno == ENOSPC || errno == EDQUOT); };
    const int file = open(name.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    if (file < 0) return full(true);
    const ssize_t written = write(file, tried.data(), tried.size());
    // a short write is the disk's last room
    bool is_full = full(written < 0) || (written >= 0 && written < static_cast<ssize_t>(tried.size()));
    is_full = full(close(file) != 0) || is_full;  // where the disk is another machine's it shows here
    unlink(name.c_str());
    return is_full;
}

}  // namespace interphase
