// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/communicator.hpp"
#include "base/vector.hpp"
#include "records/tables.hpp"
#include "records/twin_file.hpp"

namespace interphase {

/// results.h5: tables of numbers against time, and attributes that describe the run. Rank 0 writes; the other ranks'
/// calls do nothing. The file is whole at any moment (TwinFile).
class Results {
public:
    /// What was there before goes with the first flush(); where the run goes on from a time [s], only rows after it.
    explicit Results(const Communicator& comm, std::optional<double> goes_on_from = std::nullopt);

    /// One number of a row. Its name is `name` with `ending`; texts are only read during the call, and only where they
    /// are new to the table: a row is made in every step, and costs nothing but its numbers.
    struct Entry {
        const char* name;
        const char* unit;
        double value;
        const char* ending = "";
    };

    /// Adds a row to the table, e.g. "/series". Every row has the entries of the one before, in the same order, and may
    /// have new ones behind them.
    void add_row(const std::string& group, const std::vector<Entry>& row);

    /// A row with columns of several numbers, [n, width] in the file: for what is seldom taken.
    class Row {
    public:
        void add(std::string name, std::string unit, double value)
        {
            columns_.push_back({std::move(name), std::move(unit), {value}});
        }
        /// At least one number, always as many.
        void add(std::string name, std::string unit, const Scalars& values)
        {
            columns_.push_back({std::move(name), std::move(unit), values, values.size()});
        }
        const std::vector<ColumnRows>& columns() const { return columns_; }

    private:
        std::vector<ColumnRows> columns_;
    };
    void add_row(const std::string& group, const Row& row);

    void describe(const std::string& group, const std::string& name, const std::string& value);
    void describe(const std::string& group, const std::string& name, double value);
    void describe(const std::string& group, const std::string& name, const Scalars& values);
    void describe_box(const std::string& group, const std::string& name, const Box& box);

    /// A text as a data set of its own, e.g. "/meta/inputs/system/controlDict", which can be described like a group.
    void keep_text(const std::string& path, const std::string& text);

    /// To be called after each step: whether flush() is due for the rows so far to be on disk within a second, though
    /// the next step should take three times as long as this one.
    bool flush_due();

    /// All of it is in the file then.
    void flush();

private:
    void hand_over(const std::string& group, std::vector<ColumnRows>& columns);

    std::optional<TwinFile> file_;
    std::map<std::string, std::vector<ColumnRows>> tables_;  ///< rows that are not in the file yet
    bool rows_wait_ = false;
    double last_flush_ = 0, last_step_ = 0;  ///< when, by the wall clock [s]
    double cost_ = 0;                        ///< of the last flush, in wall-clock time [s]
};

}  // namespace interphase
