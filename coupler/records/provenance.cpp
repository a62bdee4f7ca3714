// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/provenance.hpp"

namespace interphase {

void record_provenance(Results& results, const Version& version, const std::vector<InputFile>& inputs)
{
    results.describe("/meta", "version", version.number);
    results.describe("/meta", "commit", version.commit);
    results.describe("/meta", "uncommitted_changes", version.uncommitted_changes);
    results.describe("/meta", "compiler", version.compiler);
    results.describe("/meta", "compiler_flags", version.flags);
    results.describe("/meta", "build_type", version.build_type);
    for (const InputFile& file : inputs) {
        const std::string path = "/meta/inputs/" + file.path;
        results.keep_text(path, file.text.value_or(""));
        results.describe(path, "kept", std::string(file.text ? "yes" : "no"));
        results.describe(path, "bytes", static_cast<double>(file.bytes));
        if (!file.sha256.empty()) results.describe(path, "sha256", file.sha256);
    }
}

}  // namespace interphase
