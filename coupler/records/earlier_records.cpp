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
    const std::vector<double> series = file.numbers("/series/time"), ledger = file.numbers("/ledger/time");
    if (series.size() < 2 && ledger.empty()) return "";  // the start's
    double last = 0;
    for (const std::vector<double>* times : {&series, &ledger})
        if (!times->empty()) last = std::max(last, times->back());
    const std::size_t rows = std::max(series.size(), ledger.size());
    return std::to_string(rows) + " rows, to t = " + text(last) + " s";
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
