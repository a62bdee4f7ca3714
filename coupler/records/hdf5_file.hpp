// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hdf5.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "base/communicator.hpp"

namespace interphase {

/// An HDF5 handle that closes itself.
class Hdf5Handle {
public:
    /// Throws a UserError naming `what` where HDF5 gave no handle.
    Hdf5Handle(hid_t id, herr_t (*close)(hid_t), const std::string& what);
    ~Hdf5Handle();
    Hdf5Handle(Hdf5Handle&& other) noexcept;
    Hdf5Handle(const Hdf5Handle&) = delete;
    Hdf5Handle& operator=(const Hdf5Handle&) = delete;
    Hdf5Handle& operator=(Hdf5Handle&&) = delete;
    operator hid_t() const { return id_; }

private:
    hid_t id_;
    herr_t (*close_)(hid_t);
};

/// An HDF5 file of one rank, or of all ranks together (every call collective then). Paths are absolute, groups along
/// them are made as needed.
class Hdf5File {
public:
    /// A new file by this rank alone.
    static Hdf5File create(const std::string& path);
    /// An existing file by this rank alone, to be changed.
    static Hdf5File open(const std::string& path);
    /// An existing file by this rank alone, only to be read.
    static Hdf5File read(const std::string& path);
    /// A new file by all ranks.
    static Hdf5File create(const std::string& path, const Communicator& comm);

    // What follows throws a UserError where it cannot be written.

    /// Makes the group where it is missing, and sets an attribute of it (replacing an older one).
    void set_attribute(const std::string& object, const std::string& name, const std::string& value);
    void set_attribute(const std::string& object, const std::string& name, double value);
    void set_attribute(const std::string& object, const std::string& name, const std::vector<double>& values,
                       const std::vector<hsize_t>& shape);

    /// An attribute with one number.
    double number_attribute(const std::string& object, const std::string& name);

    /// Appends to a data set of doubles, made with its unit where it is missing: in the file with the next flush().
    /// With `width` 0 it is one-dimensional, else [rows, width], compressed. Throws a UserError where it has another
    /// width.
    void append(const std::string& path, const std::string& unit, const std::vector<double>& values,
                std::size_t width = 0);

    /// Remembers data sets that append() has made longer, in this order: append_to() makes all of them longer again, by
    /// one of `values` each, without looking for them by name.
    void remember(const std::string& group, const std::vector<std::string>& paths);
    /// Whether so many of this group.
    bool remembers(const std::string& group, std::size_t count) const
    {
        const auto found = remembered_.find(group);
        return found != remembered_.end() && found->second.size() == count;
    }
    void append_to(const std::string& group, const std::vector<const std::vector<double>*>& values);

    /// Writes a new data set of `columns` per row (1: one-dimensional), this rank's `rows` at `first_row` of
    /// `all_rows`. `type` H5T_NATIVE_DOUBLE or H5T_NATIVE_INT.
    void write_rows(const std::string& path, const std::string& unit, hid_t type, const void* data, std::size_t rows,
                    std::size_t columns, std::size_t first_row, std::size_t all_rows);

    /// Writes a scalar data set of a text without zero bytes (replacing an older one).
    void write_text(const std::string& path, const std::string& text);

    /// Makes the link `path` to the object `of_file` of another file, which is looked for from this file's folder.
    void link(const std::string& path, const std::string& file, const std::string& of_file);

    /// Names of what is in a group; none where there is no such group.
    std::vector<std::string> names_in(const std::string& group);

    /// How many rows a data set has; 0 where there is none.
    std::size_t length(const std::string& path);

    /// The width of a data set that append() has made.
    std::size_t width(const std::string& path) { return column(path).width; }

    /// The numbers of a data set, row by row; none where there is no such data set.
    std::vector<double> numbers(const std::string& path);

    /// Takes what append() has added after the first `rows`.
    void shorten(const std::string& path, std::size_t rows);

    /// Takes a link, and with the last one what it leads to.
    void remove(const std::string& path);

    /// The file is complete on disk then, for all who open it.
    void flush();

private:
    Hdf5File(Hdf5Handle file, bool collective) : file_(std::move(file)), collective_(collective) {}

    /// A data set that append() makes longer; left open, since opening takes longer than appending.
    struct Column {
        Hdf5Handle data_set;
        hsize_t rows;       ///< in the file
        std::size_t width;  ///< 0: one-dimensional
        std::vector<double>
            waiting;  ///< rows for flush(), which writes them at once, however often append() was called
        hsize_t rows_waiting() const { return waiting.size() / std::max<std::size_t>(1, width); }
    };

    Hdf5Handle object(const std::string& path);
    static void append(Column& to, const std::vector<double>& values);
    static void write_waiting(const std::string& path, Column& of);
    void write_waiting(const std::string& path);
    Column& column(const std::string& path);
    void make_column(const std::string& path, const std::string& unit, std::size_t width);

    Hdf5Handle file_;
    bool collective_;
    std::map<std::string, Column> columns_;  ///< by path
    std::map<std::string, std::vector<Column*>> remembered_;
};

}  // namespace interphase
