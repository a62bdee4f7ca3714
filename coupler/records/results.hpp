// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/communicator.hpp"
#include "records/hdf5_file.hpp"

namespace interphase {

/// results.h5: tables of numbers against time, and attributes that describe the run. Rank 0 writes; the other ranks'
/// calls do nothing. Rows are kept until flush(), which leaves a complete file behind.
class Results {
public:
    explicit Results(const Communicator& comm);

    /// One number of a row: name, unit, value.
    struct Entry {
        std::string name;
        std::string unit;
        double value;
    };

    /// Adds a row to the group, e.g. "/series". Every row of a group has the same entries.
    void add_row(const std::string& group, const std::vector<Entry>& row);

    void describe(const std::string& group, const std::string& name, const std::string& value);
    void describe(const std::string& group, const std::string& name, double value);
    void describe_box(const std::string& group, const std::string& name, const Box& box);

    /// A text as a data set of its own, e.g. "/meta/inputs/system/controlDict", which can be described like a group.
    void keep_text(const std::string& path, const std::string& text);

    void flush();

private:
    struct Column {
        std::string unit;
        std::vector<double> rows;
    };

    std::optional<Hdf5File> file_;
    std::map<std::string, Column> columns_;  ///< by path
};

}  // namespace interphase
