// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace interphase {

/// Whether the disk of the current folder, or the user's share of it, takes no 64 KiB more: tried by writing them to
/// a file that is removed again, named after the asker. Engines and libraries write on into a full disk without a word.
bool disk_is_full(int asker);

}  // namespace interphase
