// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/particle_snapshots.hpp"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <utility>

#include "records/hdf5_file.hpp"
#include "records/unwritten.hpp"

namespace interphase {

namespace {

constexpr const char* index_file = "particles.h5";
constexpr const char* scene_file = "particles.xdmf";
constexpr const char* folder = "snapshots";
constexpr double none = -1e300;  // no time

std::string number_text(int number)
{
    char text[32];
    std::snprintf(text, sizeof text, "%06d", number);
    return text;
}

std::string file_of(int number) { return std::string(folder) + "/" + number_text(number) + ".h5"; }

std::string item(const std::string& file, const std::string& name, std::size_t particles, int columns)
{
    const bool whole = name == "id" || name == "type";
    const std::string type = whole ? "NumberType=\"Int\" Precision=\"4\"" : "NumberType=\"Float\" Precision=\"8\"";
    std::string shape = std::to_string(particles);
    if (columns > 1) shape += " " + std::to_string(columns);
    return "<DataItem Format=\"HDF\" " + type + " Dimensions=\"" + shape + "\">" + file + ":/" + name + "</DataItem>";
}

/// The end of a name that no other run on this machine takes: Open MPI 4.1 has a semaphore for each file that several
/// ranks open, named by the file without its folder. Runs at once would share it, and all wait for ever for one that a
/// killed run holds (sharedfp/sm).
std::string own_ending(const Communicator& comm)
{
    const double number = comm.max(comm.is_master() ? static_cast<double>(std::random_device{}()) : 0.0);
    char ending[32];
    std::snprintf(ending, sizeof ending, ".part-%08lx", static_cast<unsigned long>(number));
    return ending;
}

/// A file is complete under another name before it takes its own.
void put_in_place(const std::string& part, const std::string& file)
{
    if (std::rename(part.c_str(), file.c_str()) != 0)
        throw unwritten("it cannot be put in place: " + std::string(std::strerror(errno)), file);
}

/// From its number on: snapshots of an earlier run, and what a killed one has left; nothing else that may be in the
/// folder.
void remove_snapshots(int first)
{
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
        const std::string name = entry.path().filename().string();
        const std::string ending = name.size() > 6 ? name.substr(6) : "";
        if (name.find_first_not_of("0123456789") == 6 && (ending == ".h5" || ending.rfind(".h5.part", 0) == 0) &&
            name >= number_text(first))
            std::filesystem::remove(entry.path(), ignored);
    }
}

}  // namespace

ParticleSnapshots::ParticleSnapshots(const Communicator& comm, std::optional<double> goes_on_from)
    : comm_(comm), part_(own_ending(comm))
{
    const bool goes_on = goes_on_from && std::filesystem::exists(index_file);
    if (comm_.is_master()) {
        index_.emplace(index_file, goes_on ? TwinFile::Start::from_what_is_there : TwinFile::Start::anew);
        std::error_code error;
        std::filesystem::create_directories(folder, error);
        if (error) throw unwritten("it cannot be made: " + error.message(), std::filesystem::absolute(folder).string());
        if (goes_on)
            take_up(*goes_on_from);
        else {
            std::remove(scene_file);
            index_->change([](Hdf5File& file) { file.set_attribute("/snapshots", "unit_system", "SI"); });
            index_->publish();
            remove_snapshots(0);
        }
    }
    Scalars known{static_cast<double>(count_), last_.value_or(none)};  // of the first rank
    comm_.max(known);
    count_ = static_cast<int>(known[0]);
    if (known[1] > none) last_ = known[1];
}

void ParticleSnapshots::take_up(double time)
{
    Hdf5File index = Hdf5File::read(index_file);
    const std::vector<std::string> names = index.names_in("/snapshots");
    for (const std::string& name : names) {
        const int number = std::atoi(name.c_str());
        if (!std::filesystem::exists(file_of(number))) continue;  // taken away to make room
        Hdf5File file = Hdf5File::read(file_of(number));
        const double at = file.number_attribute("/", "time");
        if (at > time) break;
        count_ = number + 1;
        last_ = at;
        write_xdmf(number, file.length("/id"), at, file.length("/weight") > 0);
    }
    for (const std::string& name : names)
        if (std::atoi(name.c_str()) >= count_) later_.push_back("/snapshots/" + name);
}

void ParticleSnapshots::drop_later_ones()
{
    index_->change([later = std::move(later_)](Hdf5File& file) {
        for (const std::string& link : later)
            file.remove(link);
    });
    later_.clear();
    index_->publish();
    remove_snapshots(count_);
}

void ParticleSnapshots::write(double time, const ParticleRows& rows)
{
    if (comm_.is_master() && !later_.empty()) drop_later_ones();
    const auto mine = static_cast<double>(rows.id.size());
    std::size_t first = 0, all = 0;
    const Scalars counts = comm_.all_gather({mine});
    for (int rank = 0; rank < comm_.size(); ++rank) {
        if (rank == comm_.rank()) first = all;
        all += static_cast<std::size_t>(counts[static_cast<std::size_t>(rank)]);
    }

    const std::string name = file_of(count_), part = name + part_;
    {
        Hdf5File file = Hdf5File::create(part, comm_);
        file.set_attribute("/", "time", time);
        const std::size_t n = rows.id.size();
        const auto write = [&](const char* what, const char* unit, const Scalars& values, std::size_t columns) {
            file.write_rows(std::string("/") + what, unit, H5T_NATIVE_DOUBLE, values.data(), n, columns, first, all);
        };
        for (const auto& [what, values] : {std::pair("/id", &rows.id), std::pair("/type", &rows.type)})
            file.write_rows(what, "1", H5T_NATIVE_INT, values->data(), n, 1, first, all);
        write("position", "m", rows.position, 3);
        write("velocity", "m/s", rows.velocity, 3);
        write("angular_velocity", "rad/s", rows.angular_velocity, 3);
        write("force", "N", rows.force, 3);
        write("diameter", "m", rows.diameter, 1);
        write("density", "kg/m3", rows.density, 1);
        if (rows.weight) write("weight", "1", *rows.weight, 1);
        file.flush();
    }
    comm_.barrier();  // all ranks' rows are in it
    if (comm_.is_master()) {
        put_in_place(part, name);
        index_->change(
            [name, link = "/snapshots/" + number_text(count_)](Hdf5File& file) { file.link(link, name, "/"); });
        index_->publish();
    }
    last_ = time;
    if (comm_.is_master()) {
        write_xdmf(count_, all, time, rows.weight.has_value());
        write_scene();
    }
    ++count_;
}

void ParticleSnapshots::write_xdmf(int number, std::size_t particles, double time, bool with_weights)
{
    const std::string file = file_of(number);
    char stamp[64];
    std::snprintf(stamp, sizeof stamp, "%.12g", time);
    grids_ += std::string("<Grid Name=\"particles\" GridType=\"Uniform\"><Time Value=\"") + stamp + "\"/>\n" +
              "<Topology TopologyType=\"Polyvertex\" NumberOfElements=\"" + std::to_string(particles) + "\"/>\n";
    if (particles == 0) {  // ParaView's reader takes no array without rows, and a geometry without any
        grids_ += "<Geometry GeometryType=\"XYZ\"/>\n</Grid>\n";
        return;
    }
    grids_ += "<Geometry GeometryType=\"XYZ\">" + item(file, "position", particles, 3) + "</Geometry>\n";
    for (const char* name : {"velocity", "angular_velocity", "force"})
        grids_ += std::string("<Attribute Name=\"") + name + "\" AttributeType=\"Vector\" Center=\"Node\">" +
                  item(file, name, particles, 3) + "</Attribute>\n";
    std::vector<const char*> scalars{"id", "type", "diameter", "density"};
    if (with_weights) scalars.push_back("weight");
    for (const char* name : scalars)
        grids_ += std::string("<Attribute Name=\"") + name + "\" AttributeType=\"Scalar\" Center=\"Node\">" +
                  item(file, name, particles, 1) + "</Attribute>\n";
    grids_ += "</Grid>\n";
}

void ParticleSnapshots::write_scene() const
{
    const std::string part = std::string(scene_file) + ".part";
    std::ofstream scene(part);
    scene << "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\"><Domain>\n"
          << "<Grid Name=\"snapshots\" GridType=\"Collection\" CollectionType=\"Temporal\">\n"
          << grids_ << "</Grid></Domain></Xdmf>\n";
    scene.close();
    if (!scene) throw unwritten("it cannot be written: " + std::string(std::strerror(errno)), part);
    put_in_place(part, scene_file);
}

}  // namespace interphase
