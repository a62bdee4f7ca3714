// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/results.hpp"

namespace interphase {

Results::Results(const Communicator& comm)
{
    if (comm.is_master()) file_.emplace(Hdf5File::create("results.h5"));
}

void Results::add_row(const std::string& group, const std::vector<Entry>& row)
{
    if (!file_) return;
    for (const Entry& entry : row) {
        Column& column = columns_[group + "/" + entry.name];
        column.unit = entry.unit;
        column.rows.push_back(entry.value);
    }
}

void Results::describe(const std::string& group, const std::string& name, const std::string& value)
{
    if (file_) file_->set_attribute(group, name, value);
}

void Results::describe(const std::string& group, const std::string& name, double value)
{
    if (file_) file_->set_attribute(group, name, value);
}

void Results::describe_box(const std::string& group, const std::string& name, const Box& box)
{
    if (!file_) return;
    const Eigen::Matrix<double, 2, 3, Eigen::RowMajor> corners = box.transpose();
    file_->set_attribute(group, name, std::vector<double>(corners.data(), corners.data() + 6), {2, 3});
}

void Results::keep_text(const std::string& path, const std::string& text)
{
    if (file_) file_->write_text(path, text);
}

void Results::flush()
{
    if (!file_) return;
    for (auto& [path, column] : columns_) {
        if (column.rows.empty()) continue;
        file_->append(path, column.unit, column.rows);
        column.rows.clear();
    }
    file_->flush();
}

}  // namespace interphase
