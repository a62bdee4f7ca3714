// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/version.hpp"
#include "records/case_inputs.hpp"
#include "records/results.hpp"

namespace interphase {

/// What made a results.h5, so that a run can be told from another, and done again:
/// attributes of /meta: version, commit, uncommitted_changes, compiler, compiler_flags, build_type (base/version.hpp);
/// /meta/inputs/<path>: the text of each input file, empty where it is not kept (attribute kept: yes or no), with the
/// attributes bytes and, up to 64 MB, sha256.
void record_provenance(Results& results, const Version& version, const std::vector<InputFile>& inputs);

}  // namespace interphase
