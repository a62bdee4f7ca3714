// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "records/hdf5_file.hpp"

namespace interphase {

/// A column's new rows: a number each, or `width` numbers each, one row after the other.
struct ColumnRows {
    std::string name, unit;
    std::vector<double> rows;
    std::size_t width = 0;  ///< 0: one-dimensional

    std::size_t count() const { return width == 0 ? rows.size() : rows.size() / width; }
};

/// Adds rows to the table `group`: data sets of equal length, of which one is called "time". `columns` are of equal
/// length. Where a column is new, or one that is there has no new rows, NaN stands in its place: rows of one
/// number belong together.
void append_rows(Hdf5File& file, const std::string& group, const std::vector<ColumnRows>& columns);

/// Takes the rows after `time` [s] from every table of the file.
void keep_rows_until(Hdf5File& file, double time);

}  // namespace interphase
