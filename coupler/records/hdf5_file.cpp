// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/hdf5_file.hpp"

#include <algorithm>

#include "records/unwritten.hpp"

namespace interphase {

namespace {

constexpr hsize_t rows_per_chunk = 256;  // a chunk is written whole whenever it has grown
constexpr hsize_t numbers_per_chunk = 8192;

hsize_t rows_of_chunk(std::size_t width)
{
    return width == 0 ? rows_per_chunk : std::clamp<hsize_t>(numbers_per_chunk / width, 1, rows_per_chunk);
}

std::vector<hsize_t> shape_of(hsize_t rows, std::size_t width)
{
    if (width == 0) return {rows};
    return {rows, width};
}

/// Of a data set of one or two dimensions.
std::vector<hsize_t> shape_of(hid_t data_set)
{
    const Hdf5Handle space(H5Dget_space(data_set), H5Sclose, "a data space");
    std::vector<hsize_t> shape(static_cast<std::size_t>(std::max(1, H5Sget_simple_extent_ndims(space))));
    H5Sget_simple_extent_dims(space, shape.data(), nullptr);
    return shape;
}

Hdf5Handle property_list(hid_t kind) { return {H5Pcreate(kind), H5Pclose, "a property list"}; }

Hdf5Handle with_parent_groups()
{
    Hdf5Handle list = property_list(H5P_LINK_CREATE);
    H5Pset_create_intermediate_group(list, 1);
    return list;
}

Hdf5Handle shared_by(const Communicator& comm)
{
    Hdf5Handle list = property_list(H5P_FILE_ACCESS);
    H5Pset_fapl_mpio(list, comm.handle(), MPI_INFO_NULL);
    return list;
}

Hdf5Handle space(const std::vector<hsize_t>& shape)
{
    return {H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose, "a data space"};
}

/// `status` is what HDF5 returned for writing `what`.
void demand(herr_t status, const std::string& what)
{
    if (status < 0) throw unwritten("HDF5 could not write " + what, "the case folder");
}

/// Of any length: h5py reads that as `str`, and a text of fixed length as bytes.
Hdf5Handle text_of_any_length()
{
    Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "a text type");
    H5Tset_size(type, H5T_VARIABLE);
    H5Tset_cset(type, H5T_CSET_UTF8);
    return type;
}

void write_unit(hid_t data_set, const std::string& unit)
{
    const Hdf5Handle type = text_of_any_length();
    const Hdf5Handle scalar(H5Screate(H5S_SCALAR), H5Sclose, "a data space");
    const Hdf5Handle attribute(H5Acreate2(data_set, "unit", type, scalar, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                               "a unit");
    const char* words = unit.empty() ? "1" : unit.c_str();
    demand(H5Awrite(attribute, type, &words), "a unit");
}

void replace_attribute(hid_t object, const std::string& name, hid_t type, hid_t shape, const void* value)
{
    if (H5Aexists(object, name.c_str()) > 0) H5Adelete(object, name.c_str());
    const Hdf5Handle attribute(H5Acreate2(object, name.c_str(), type, shape, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                               "the attribute " + name);
    demand(H5Awrite(attribute, type, value), "the attribute " + name);
}

bool there(hid_t file, const std::string& path)
{
    for (std::size_t slash = path.find('/', 1); slash != std::string::npos; slash = path.find('/', slash + 1))
        if (H5Lexists(file, path.substr(0, slash).c_str(), H5P_DEFAULT) <= 0) return false;
    return H5Lexists(file, path.c_str(), H5P_DEFAULT) > 0;
}

}  // namespace

Hdf5Handle::Hdf5Handle(hid_t id, herr_t (*close)(hid_t), const std::string& what) : id_(id), close_(close)
{
    if (id_ < 0) throw unwritten("HDF5 could not open or make " + what, "the case folder");
}

Hdf5Handle::Hdf5Handle(Hdf5Handle&& other) noexcept : id_(other.id_), close_(other.close_) { other.id_ = -1; }

Hdf5Handle::~Hdf5Handle()
{
    if (id_ >= 0) close_(id_);
}

Hdf5File Hdf5File::create(const std::string& path)
{
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    return {Hdf5Handle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose, path), false};
}

Hdf5File Hdf5File::open(const std::string& path)
{
    return {Hdf5Handle(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose, path), false};
}

Hdf5File Hdf5File::read(const std::string& path)
{
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    return {Hdf5Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, path), false};
}

Hdf5File Hdf5File::create(const std::string& path, const Communicator& comm)
{
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    return {Hdf5Handle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, shared_by(comm)), H5Fclose, path), true};
}

Hdf5Handle Hdf5File::object(const std::string& path)
{
    if (path != "/" && !there(file_, path)) {
        const Hdf5Handle group(H5Gcreate2(file_, path.c_str(), with_parent_groups(), H5P_DEFAULT, H5P_DEFAULT),
                               H5Gclose, "the group " + path);
    }
    return {H5Oopen(file_, path.c_str(), H5P_DEFAULT), H5Oclose, path};
}

void Hdf5File::set_attribute(const std::string& path, const std::string& name, const std::string& value)
{
    const char* words = value.c_str();
    replace_attribute(object(path), name, text_of_any_length(),
                      Hdf5Handle(H5Screate(H5S_SCALAR), H5Sclose, "a data space"), &words);
}

void Hdf5File::set_attribute(const std::string& path, const std::string& name, double value)
{
    replace_attribute(object(path), name, H5T_NATIVE_DOUBLE,
                      Hdf5Handle(H5Screate(H5S_SCALAR), H5Sclose, "a data space"), &value);
}

void Hdf5File::set_attribute(const std::string& path, const std::string& name, const std::vector<double>& values,
                             const std::vector<hsize_t>& shape)
{
    replace_attribute(object(path), name, H5T_NATIVE_DOUBLE, space(shape), values.data());
}

double Hdf5File::number_attribute(const std::string& path, const std::string& name)
{
    const Hdf5Handle attribute(H5Aopen_by_name(file_, path.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                               "the attribute " + name);
    double value = 0;
    if (H5Aread(attribute, H5T_NATIVE_DOUBLE, &value) < 0) throw unwritten("HDF5 could not read " + name, path);
    return value;
}

void Hdf5File::make_column(const std::string& path, const std::string& unit, std::size_t width)
{
    const std::vector<hsize_t> none = shape_of(0, width), unlimited = shape_of(H5S_UNLIMITED, width);
    const Hdf5Handle shape(H5Screate_simple(static_cast<int>(none.size()), none.data(), unlimited.data()), H5Sclose,
                           "a data space");
    const Hdf5Handle creation = property_list(H5P_DATASET_CREATE);
    const std::vector<hsize_t> chunk = shape_of(rows_of_chunk(width), width);
    H5Pset_chunk(creation, static_cast<int>(chunk.size()), chunk.data());
    if (width > 0) {
        H5Pset_shuffle(creation);
        H5Pset_deflate(creation, 1);
    }
    const Hdf5Handle made(
        H5Dcreate2(file_, path.c_str(), H5T_NATIVE_DOUBLE, shape, with_parent_groups(), creation, H5P_DEFAULT),
        H5Dclose, path);
    write_unit(made, unit);
}

Hdf5File::Column& Hdf5File::column(const std::string& path)
{
    const auto found = columns_.find(path);
    if (found != columns_.end()) return found->second;
    Hdf5Handle data_set(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), H5Dclose, path);
    const std::vector<hsize_t> shape = shape_of(data_set);
    const std::size_t width = shape.size() > 1 ? shape[1] : 0;
    return columns_.emplace(path, Column{std::move(data_set), shape[0], width, {}}).first->second;
}

std::size_t Hdf5File::length(const std::string& path)
{
    if (columns_.find(path) == columns_.end() && !there(file_, path)) return 0;
    const Column& found = column(path);
    return found.rows + found.rows_waiting();
}

void Hdf5File::append(const std::string& path, const std::string& unit, const std::vector<double>& values,
                      std::size_t width)
{
    if (columns_.find(path) == columns_.end() && !there(file_, path)) make_column(path, unit, width);
    Column& to = column(path);
    if (to.width != width)
        throw UserError(path + " has rows of " + std::to_string(to.width) + " numbers, and now " +
                            std::to_string(width) + " are to be added",
                        "results.h5", "start anew, without -resume, or ask for as many as the run before did");
    append(to, values);
}

void Hdf5File::remember(const std::string& group, const std::vector<std::string>& paths)
{
    std::vector<Column*>& all = remembered_[group];
    all.clear();
    for (const std::string& path : paths)
        all.push_back(&column(path));
}

void Hdf5File::append_to(const std::string& group, const std::vector<const std::vector<double>*>& values)
{
    const std::vector<Column*>& all = remembered_.at(group);
    for (std::size_t n = 0; n < all.size(); ++n)
        append(*all[n], *values[n]);
}

void Hdf5File::append(Column& to, const std::vector<double>& values)
{
    to.waiting.insert(to.waiting.end(), values.begin(), values.end());
}

void Hdf5File::write_waiting(const std::string& path, Column& of)
{
    if (of.waiting.empty()) return;
    const hsize_t added = of.rows_waiting(), count = of.rows + added;
    demand(H5Dset_extent(of.data_set, shape_of(count, of.width).data()), path);
    const Hdf5Handle target(H5Dget_space(of.data_set), H5Sclose, "a data space");
    const std::vector<hsize_t> start{of.rows, 0}, shape = shape_of(added, of.width);
    H5Sselect_hyperslab(target, H5S_SELECT_SET, start.data(), nullptr, shape.data(), nullptr);
    demand(H5Dwrite(of.data_set, H5T_NATIVE_DOUBLE, space(shape), target, H5P_DEFAULT, of.waiting.data()), path);
    of.rows = count;
    of.waiting.clear();
}

void Hdf5File::write_waiting(const std::string& path)
{
    const auto found = columns_.find(path);
    if (found != columns_.end()) write_waiting(path, found->second);
}

void Hdf5File::write_rows(const std::string& path, const std::string& unit, hid_t type, const void* data,
                          std::size_t rows, std::size_t columns, std::size_t first_row, std::size_t all_rows)
{
    const std::size_t width = columns > 1 ? columns : 0;
    const Hdf5Handle data_set(H5Dcreate2(file_, path.c_str(), type, space(shape_of(all_rows, width)),
                                         with_parent_groups(), H5P_DEFAULT, H5P_DEFAULT),
                              H5Dclose, path);
    write_unit(data_set, unit);
    if (all_rows == 0) return;  // HDF5 refuses to write nothing
    const Hdf5Handle target(H5Dget_space(data_set), H5Sclose, "a data space");
    const Hdf5Handle source = space(shape_of(rows, width));
    if (rows > 0) {
        const std::vector<hsize_t> start{first_row, 0}, count{rows, columns};
        H5Sselect_hyperslab(target, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr);
    } else {
        H5Sselect_none(target);
        H5Sselect_none(source);
    }
    const Hdf5Handle transfer = property_list(H5P_DATASET_XFER);
    if (collective_) H5Pset_dxpl_mpio(transfer, H5FD_MPIO_COLLECTIVE);
    demand(H5Dwrite(data_set, type, source, target, transfer, data), path);
}

void Hdf5File::write_text(const std::string& path, const std::string& text)
{
    const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "a text type");
    H5Tset_size(type, text.empty() ? 1 : text.size());
    H5Tset_cset(type, H5T_CSET_UTF8);
    const Hdf5Handle scalar(H5Screate(H5S_SCALAR), H5Sclose, "a data space");
    if (there(file_, path)) remove(path);
    const Hdf5Handle data_set(
        H5Dcreate2(file_, path.c_str(), type, scalar, with_parent_groups(), H5P_DEFAULT, H5P_DEFAULT), H5Dclose, path);
    demand(H5Dwrite(data_set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()), path);
}

void Hdf5File::link(const std::string& path, const std::string& file, const std::string& of_file)
{
    demand(H5Lcreate_external(file.c_str(), of_file.c_str(), file_, path.c_str(), with_parent_groups(), H5P_DEFAULT),
           path);
}

std::vector<std::string> Hdf5File::names_in(const std::string& path)
{
    std::vector<std::string> names;
    if (path != "/" && !there(file_, path)) return names;
    const Hdf5Handle group(H5Gopen2(file_, path.c_str(), H5P_DEFAULT), H5Gclose, "the group " + path);
    const auto add = [](hid_t, const char* name, const H5L_info_t*, void* to) -> herr_t {
        static_cast<std::vector<std::string>*>(to)->emplace_back(name);
        return 0;
    };
    H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &names);
    return names;
}

std::vector<double> Hdf5File::numbers(const std::string& path)
{
    write_waiting(path);
    if (!there(file_, path)) return {};
    const Hdf5Handle data_set(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), H5Dclose, path);
    const Hdf5Handle shape(H5Dget_space(data_set), H5Sclose, "a data space");
    std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(shape)));
    if (!values.empty() && H5Dread(data_set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
        throw unwritten("HDF5 could not read " + path, "the case folder");
    return values;
}

void Hdf5File::shorten(const std::string& path, std::size_t rows)
{
    write_waiting(path);
    remembered_.clear();
    columns_.erase(path);
    const Hdf5Handle data_set(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), H5Dclose, path);
    std::vector<hsize_t> shape = shape_of(data_set);
    shape[0] = rows;
    demand(H5Dset_extent(data_set, shape.data()), path);
}

void Hdf5File::remove(const std::string& path) { demand(H5Ldelete(file_, path.c_str(), H5P_DEFAULT), path); }

void Hdf5File::flush()
{
    for (auto& [path, column] : columns_)
        write_waiting(path, column);
    demand(H5Fflush(file_, H5F_SCOPE_GLOBAL), "what was recorded");
}

}  // namespace interphase
