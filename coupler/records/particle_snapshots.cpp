// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/particle_snapshots.hpp"

#include <cstdio>
#include <fstream>

#include "records/hdf5_file.hpp"

namespace interphase {

namespace {

constexpr const char* data_file = "particles.h5";
constexpr const char* scene_file = "particles.xdmf";

std::string group_name(int number)
{
    char name[32];
    std::snprintf(name, sizeof name, "/snapshots/%06d", number);
    return name;
}

std::string item(const std::string& group, const std::string& name, std::size_t particles, int columns)
{
    const std::string type =
        name == "id" ? "NumberType=\"Int\" Precision=\"4\"" : "NumberType=\"Float\" Precision=\"8\"";
    std::string shape = std::to_string(particles);
    if (columns > 1) shape += " " + std::to_string(columns);
    return "<DataItem Format=\"HDF\" " + type + " Dimensions=\"" + shape + "\">" + data_file + ":" + group + "/" +
           name + "</DataItem>";
}

}  // namespace

ParticleSnapshots::ParticleSnapshots(const Communicator& comm) : comm_(comm)
{
    Hdf5File::create(data_file, comm_).set_attribute("/snapshots", "unit_system", "SI");
}

void ParticleSnapshots::write(double time, const ParticleRows& rows)
{
    const auto mine = static_cast<double>(rows.id.size());
    std::size_t first = 0, all = 0;
    const Scalars counts = comm_.all_gather({mine});
    for (int rank = 0; rank < comm_.size(); ++rank) {
        if (rank == comm_.rank()) first = all;
        all += static_cast<std::size_t>(counts[static_cast<std::size_t>(rank)]);
    }

    const std::string group = group_name(count_);
    {
        Hdf5File file = Hdf5File::open(data_file, comm_);
        file.set_attribute(group, "time", time);
        const std::size_t n = rows.id.size();
        const auto write = [&](const char* name, const char* unit, const Scalars& values, std::size_t columns) {
            file.write_rows(group + "/" + name, unit, H5T_NATIVE_DOUBLE, values.data(), n, columns, first, all);
        };
        file.write_rows(group + "/id", "1", H5T_NATIVE_INT, rows.id.data(), n, 1, first, all);
        write("position", "m", rows.position, 3);
        write("velocity", "m/s", rows.velocity, 3);
        write("angular_velocity", "rad/s", rows.angular_velocity, 3);
        write("force", "N", rows.force, 3);
        write("diameter", "m", rows.diameter, 1);
        if (rows.weight) write("weight", "1", *rows.weight, 1);
    }
    ++count_;
    if (comm_.is_master()) write_xdmf(all, time, rows.weight.has_value());
}

void ParticleSnapshots::write_xdmf(std::size_t particles, double time, bool with_weights)
{
    const std::string group = group_name(count_ - 1);
    char stamp[64];
    std::snprintf(stamp, sizeof stamp, "%.12g", time);
    grids_ += std::string("<Grid Name=\"particles\" GridType=\"Uniform\"><Time Value=\"") + stamp + "\"/>\n" +
              "<Topology TopologyType=\"Polyvertex\" NumberOfElements=\"" + std::to_string(particles) + "\"/>\n";
    if (particles == 0) {  // ParaView's reader takes no array without rows, and a geometry without any
        grids_ += "<Geometry GeometryType=\"XYZ\"/>\n</Grid>\n";
        write_scene();
        return;
    }
    grids_ += "<Geometry GeometryType=\"XYZ\">" + item(group, "position", particles, 3) + "</Geometry>\n";
    for (const char* name : {"velocity", "angular_velocity", "force"})
        grids_ += std::string("<Attribute Name=\"") + name + "\" AttributeType=\"Vector\" Center=\"Node\">" +
                  item(group, name, particles, 3) + "</Attribute>\n";
    std::vector<const char*> scalars{"id", "diameter"};
    if (with_weights) scalars.push_back("weight");
    for (const char* name : scalars)
        grids_ += std::string("<Attribute Name=\"") + name + "\" AttributeType=\"Scalar\" Center=\"Node\">" +
                  item(group, name, particles, 1) + "</Attribute>\n";
    grids_ += "</Grid>\n";
    write_scene();
}

void ParticleSnapshots::write_scene() const
{
    std::ofstream(scene_file) << "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\"><Domain>\n"
                              << "<Grid Name=\"snapshots\" GridType=\"Collection\" CollectionType=\"Temporal\">\n"
                              << grids_ << "</Grid></Domain></Xdmf>\n";
}

}  // namespace interphase
