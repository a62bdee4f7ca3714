// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <hdf5.h>

#include <numeric>
#include <string>
#include <vector>

#include "records/hdf5_file.hpp"

namespace interphase::test {

/// An HDF5 file as it lies there, read with HDF5 itself.
class OpenFile {
public:
    explicit OpenFile(const std::string& path)
        : file_(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, path)
    {}

    bool has(const std::string& path) const { return H5Lexists(file_, path.c_str(), H5P_DEFAULT) > 0; }

    std::vector<hsize_t> shape(const std::string& path) const
    {
        const Hdf5Handle set(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), H5Dclose, path);
        const Hdf5Handle space(H5Dget_space(set), H5Sclose, path);
        std::vector<hsize_t> extents(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
        H5Sget_simple_extent_dims(space, extents.data(), nullptr);
        return extents;
    }

    template <class Number>
    std::vector<Number> numbers(const std::string& path, hid_t type) const
    {
        const auto extents = shape(path);
        std::vector<Number> values(
            std::accumulate(extents.begin(), extents.end(), std::size_t{1}, std::multiplies<std::size_t>()));
        const Hdf5Handle set(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), H5Dclose, path);
        EXPECT_GE(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0) << path;
        return values;
    }
    Scalars doubles(const std::string& path) const { return numbers<double>(path, H5T_NATIVE_DOUBLE); }
    std::vector<int> integers(const std::string& path) const { return numbers<int>(path, H5T_NATIVE_INT); }

    std::string word(const std::string& object, const std::string& name) const
    {
        // open while it is read: a text of any length lies elsewhere in its file, to which a link may lead
        const Hdf5Handle of(H5Oopen(file_, object.c_str(), H5P_DEFAULT), H5Oclose, object);
        const Hdf5Handle attribute(H5Aopen(of, name.c_str(), H5P_DEFAULT), H5Aclose, name);
        const Hdf5Handle type(H5Aget_type(attribute), H5Tclose, name);
        EXPECT_GT(H5Tis_variable_str(type), 0) << name << ": h5py would read bytes";
        EXPECT_EQ(H5Tget_cset(type), H5T_CSET_UTF8) << name;
        char* words = nullptr;
        EXPECT_GE(H5Aread(attribute, type, &words), 0) << name;
        if (!words) return "";
        std::string value = words;
        H5free_memory(words);
        return value;
    }

    Scalars attribute(const std::string& object, const std::string& name) const
    {
        const Hdf5Handle attribute(H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
                                   H5Aclose, name);
        const Hdf5Handle space(H5Aget_space(attribute), H5Sclose, name);
        Scalars values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
        EXPECT_GE(H5Aread(attribute, H5T_NATIVE_DOUBLE, values.data()), 0) << name;
        return values;
    }

private:
    Hdf5Handle file_;
};

}  // namespace interphase::test
