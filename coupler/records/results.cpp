// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/results.hpp"

#include <algorithm>
#include <filesystem>

#include "base/stopwatch.hpp"

namespace interphase {

namespace {

constexpr double promised = 1;      // what rows wait at most [s]
constexpr double patience = 0.8;    // of steps that are short: a flush takes 1 ms for a hundred columns
constexpr double least_ratio = 50;  // a disk that is slow gets a fiftieth of the time

}  // namespace

Results::Results(const Communicator& comm, std::optional<double> goes_on_from)
{
    if (!comm.is_master()) return;
    constexpr const char* name = "results.h5";
    const bool goes_on = goes_on_from && std::filesystem::exists(name);
    file_.emplace(name, goes_on ? TwinFile::Start::from_what_is_there : TwinFile::Start::anew);
    if (goes_on) file_->change([time = *goes_on_from](Hdf5File& file) { keep_rows_until(file, time); });
}

void Results::add_row(const std::string& group, const std::vector<Entry>& row)
{
    if (!file_) return;
    std::vector<ColumnRows>& table = tables_[group];
    if (table.size() < row.size()) {
        hand_over(group, table);
        for (std::size_t n = table.size(); n < row.size(); ++n)
            table.push_back({std::string(row[n].name) + row[n].ending, row[n].unit, {}});
    }
    for (std::size_t n = 0; n < row.size(); ++n)
        table[n].rows.push_back(row[n].value);
    rows_wait_ = true;
}

void Results::add_row(const std::string& group, const Row& row)
{
    if (!file_) return;
    std::vector<ColumnRows>& table = tables_[group];
    if (table.empty())
        table = row.columns();
    else
        for (std::size_t n = 0; n < table.size(); ++n)
            table[n].rows.insert(table[n].rows.end(), row.columns()[n].rows.begin(), row.columns()[n].rows.end());
    rows_wait_ = true;
}

void Results::describe(const std::string& group, const std::string& name, const Scalars& values)
{
    if (file_) file_->change([=](Hdf5File& file) { file.set_attribute(group, name, values, {values.size()}); });
}

void Results::describe(const std::string& group, const std::string& name, const std::string& value)
{
    if (file_) file_->change([=](Hdf5File& file) { file.set_attribute(group, name, value); });
}

void Results::describe(const std::string& group, const std::string& name, double value)
{
    if (file_) file_->change([=](Hdf5File& file) { file.set_attribute(group, name, value); });
}

void Results::describe_box(const std::string& group, const std::string& name, const Box& box)
{
    if (!file_) return;
    const Eigen::Matrix<double, 2, 3, Eigen::RowMajor> corners = box.transpose();
    const std::vector<double> values(corners.data(), corners.data() + 6);
    file_->change([=](Hdf5File& file) { file.set_attribute(group, name, values, {2, 3}); });
}

void Results::keep_text(const std::string& path, const std::string& text)
{
    if (file_) file_->change([=](Hdf5File& file) { file.write_text(path, text); });
}

bool Results::flush_due()
{
    const double at = wall_clock(), step = at - last_step_, waited = at - last_flush_;
    last_step_ = at;
    if (!rows_wait_ || waited < least_ratio * cost_) return false;
    return waited > patience || waited + 3 * step > promised;
}

/// The rows that wait.
void Results::hand_over(const std::string& group, std::vector<ColumnRows>& columns)
{
    if (columns.empty() || columns.front().rows.empty()) return;
    file_->change([=](Hdf5File& file) { append_rows(file, group, columns); });
    for (ColumnRows& column : columns)
        column.rows.clear();
}

void Results::flush()
{
    if (!file_) return;
    const double start = wall_clock();
    for (auto& [group, columns] : tables_)
        hand_over(group, columns);
    rows_wait_ = false;
    file_->publish();
    last_flush_ = wall_clock();
    cost_ = last_flush_ - start;
}

}  // namespace interphase
