// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/tables.hpp"

#include <algorithm>
#include <limits>

namespace interphase {

namespace {

void fill_up(Hdf5File& file, const std::string& path, const std::string& unit, std::size_t rows, std::size_t width)
{
    const std::size_t there = file.length(path);
    if (there >= rows) return;
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    file.append(path, unit, std::vector<double>((rows - there) * std::max<std::size_t>(1, width), nothing), width);
}

}  // namespace

void append_rows(Hdf5File& file, const std::string& group, const std::vector<ColumnRows>& columns)
{
    if (file.remembers(group, columns.size())) {
        std::vector<const std::vector<double>*> rows;
        for (const ColumnRows& column : columns)
            rows.push_back(&column.rows);
        return file.append_to(group, rows);
    }
    const std::vector<std::string> names = file.names_in(group);
    std::size_t rows = 0;
    for (const std::string& name : names)
        rows = std::max(rows, file.length(group + "/" + name));
    for (const ColumnRows& column : columns) {
        fill_up(file, group + "/" + column.name, column.unit, rows, column.width);
        file.append(group + "/" + column.name, column.unit, column.rows, column.width);
    }
    if (columns.empty()) return;
    rows += columns.front().count();
    for (const std::string& name : names)
        fill_up(file, group + "/" + name, "", rows, file.width(group + "/" + name));
    if (file.names_in(group).size() != columns.size()) return;  // others have to be filled up each time
    std::vector<std::string> paths;
    for (const ColumnRows& column : columns)
        paths.push_back(group + "/" + column.name);
    file.remember(group, paths);
}

void keep_rows_until(Hdf5File& file, double time)
{
    for (const std::string& group : file.names_in("/")) {
        const std::vector<double> times = file.numbers("/" + group + "/time");
        const auto later = std::find_if(times.begin(), times.end(), [time](double t) { return t > time; });
        if (later == times.end()) continue;
        for (const std::string& name : file.names_in("/" + group))
            file.shorten("/" + group + "/" + name, static_cast<std::size_t>(later - times.begin()));
    }
}

}  // namespace interphase
