// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/earlier_records.hpp"

#include <hdf5.h>

#include <algorithm>

#include "base/numbers.hpp"
#include "base/text.hpp"

namespace interphase {

namespace {

/// What is opened, or nothing.
class Opened {
public:
    Opened(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
    ~Opened()
    {
        if (id_ >= 0) close_(id_);
    }
    Opened(const Opened&) = delete;
    Opened& operator=(const Opened&) = delete;
    operator hid_t() const { return id_; }
    bool there() const { return id_ >= 0; }

private:
    hid_t id_;
    herr_t (*close_)(hid_t);
};

/// The times of a table.
Scalars times(hid_t file, const std::string& path)
{
    const Opened data_set(H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose);
    if (!data_set.there()) return {};
    const Opened space(H5Dget_space(data_set), H5Sclose);
    const hssize_t count = space.there() ? H5Sget_simple_extent_npoints(space) : 0;
    Scalars values(static_cast<std::size_t>(std::max<hssize_t>(count, 0)));
    if (count > 0) H5Dread(data_set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    return values;
}

std::string of_results(hid_t file)
{
    std::size_t rows = 0;
    double last = 0;
    for (const char* table : {"/series/time", "/ledger/time"}) {
        const Scalars at = times(file, table);
        if (at.empty()) continue;
        rows = std::max(rows, at.size());
        last = std::max(last, at.back());
    }
    return rows == 0 ? "" : std::to_string(rows) + " rows, to t = " + text(last) + " s";
}

std::string of_snapshots(hid_t file)
{
    const Opened group(H5Gopen2(file, "/snapshots", H5P_DEFAULT), H5Gclose);
    H5G_info_t info;
    if (!group.there() || H5Gget_info(group, &info) < 0 || info.nlinks < 2) return "";
    return std::to_string(info.nlinks) + " snapshots";
}

}  // namespace

std::optional<std::string> earlier_records(const std::filesystem::path& folder)
{
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    std::string all;
    const auto add = [&](const char* name, std::string (*look)(hid_t)) {
        if (!std::filesystem::exists(folder / name)) return;
        const Opened file(H5Fopen((folder / name).c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
        const std::string words = file.there() ? look(file) : "cannot be read";
        if (!words.empty()) all += (all.empty() ? "" : ", ") + std::string(name) + " (" + words + ")";
    };
    add("results.h5", of_results);
    add("particles.h5", of_snapshots);
    return all.empty() ? std::nullopt : std::optional(all);
}

}  // namespace interphase
