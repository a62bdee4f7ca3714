// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/earlier_records.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "base/user_error.hpp"
#include "records/hdf5_file.hpp"

namespace interphase {

namespace {

std::string of_results(Hdf5File& file)
{
    std::size_t rows = 0;
    double last = 0;
    for (const char* table : {"/series/time", "/ledger/time"}) {
        const std::vector<double> at = file.numbers(table);
        if (at.empty()) continue;
        rows = std::max(rows, at.size());
        last = std::max(last, at.back());
    }
    return rows == 0 ? "" : std::to_string(rows) + " rows, to t = " + text(last) + " s";
}

std::string of_snapshots(Hdf5File& file)
{
    const std::size_t count = file.names_in("/snapshots").size();
    return count < 2 ? "" : std::to_string(count) + " snapshots";
}

}  // namespace

std::optional<std::string> earlier_records(const std::filesystem::path& folder)
{
    std::string all;
    const auto add = [&](const char* name, std::string (*look)(Hdf5File&)) {
        if (!std::filesystem::exists(folder / name)) return;
        std::string words;
        try {
            Hdf5File file = Hdf5File::read((folder / name).string());
            words = look(file);
        } catch (const UserError&) {
            words = "cannot be read";
        }
        if (!words.empty()) all += (all.empty() ? "" : ", ") + std::string(name) + " (" + words + ")";
    };
    add("results.h5", of_results);
    add("particles.h5", of_snapshots);
    return all.empty() ? std::nullopt : std::optional(all);
}

}  // namespace interphase
