// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/results.hpp"

#include <algorithm>
#include <chrono>

namespace interphase {

namespace {

constexpr double promised = 1;      // what rows wait at most [s]
constexpr double patience = 0.6;    // of steps that are short: a flush takes 1 ms for a hundred columns
constexpr double least_ratio = 50;  // a disk that is slow gets a fiftieth of the time

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

Results::Results(const Communicator& comm)
{
    if (comm.is_master()) file_.emplace("results.h5");
}

void Results::add_row(const std::string& group, const std::vector<Entry>& row)
{
    if (!file_) return;
    for (const Entry& entry : row) {
        Column& column = columns_[group + "/" + entry.name];
        column.unit = entry.unit;
        column.rows.push_back(entry.value);
    }
    rows_wait_ = true;
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
    const double at = now(), step = at - last_step_, waited = at - last_flush_;
    last_step_ = at;
    if (!rows_wait_ || waited < least_ratio * cost_) return false;
    return waited > patience || waited + 3 * step > promised;
}

void Results::flush()
{
    if (!file_) return;
    const double start = now();
    for (auto& [path, column] : columns_) {
        if (column.rows.empty()) continue;
        file_->change([path = path, unit = column.unit, rows = std::move(column.rows)](Hdf5File& file) {
            file.append(path, unit, rows);
        });
        column.rows.clear();
    }
    rows_wait_ = false;
    file_->publish();
    last_flush_ = now();
    cost_ = last_flush_ - start;
}

}  // namespace interphase
