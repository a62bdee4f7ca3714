// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "records/case_inputs.hpp"
#include "run/checkpoint.hpp"

namespace interphase {

/// What files of a case say, by their meaning: entries of dictionaries by name, each with its value, and scripts of
/// LIGGGHTS line by line, without comments and with white space and numbers written in one way; of other files the
/// checksum.
Checkpoints::Facts facts_of(const std::vector<InputFile>& files);

/// How the facts of two runs differ, in words.
struct FactDifferences {
    std::vector<std::string> refused;  ///< the later one is not the earlier one going on
    std::vector<std::string> told;     ///< of when it ends, of what it writes and of where plug-ins are
};
FactDifferences differences(const Checkpoints::Facts& then, const Checkpoints::Facts& now);

}  // namespace interphase
