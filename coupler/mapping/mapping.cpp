// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapping/mapping.hpp"

namespace interphase {

Mapping::Mapping(const Communicator& comm, const MeshView& mesh, MappingType type, double kernel_width,
                 double maximum_packing)
    : type_(type),
      cells_(comm, mesh, type == MappingType::kernel ? kernel_width : 0.0),
      weights_(cells_),
      limit_(cells_, comm, maximum_packing)
{}

void Mapping::place(const Scalars& positions, const std::vector<int>& cells)
{
    if (type_ == MappingType::kernel)
        weights_.spread_by_kernel(positions, cells);
    else
        weights_.place_in_own_cell(cells);
}

Scalars Mapping::solid_volume(const Scalars& of_particles)
{
    Scalars volume(cells_.local_count(), 0.0);
    weights_.add_to_cells(of_particles, 1, volume);
    cells_.add_halo_to_owners(volume, 1);
    limit_.relieve(volume);
    volume.resize(cells_.own_count());
    return volume;
}

Scalars Mapping::to_cells(const Scalars& of_particles, int width) const
{
    const auto w = static_cast<std::size_t>(width);
    Scalars content(cells_.local_count() * w, 0.0);
    weights_.add_to_cells(of_particles, width, content);
    cells_.add_halo_to_owners(content, width);
    limit_.hand_over(content, width);
    content.resize(cells_.own_count() * w);
    return content;
}

void Mapping::to_particles(const Scalars& of_cells, int width, Scalars& of_particles) const
{
    Scalars values(of_cells);
    values.resize(cells_.local_count() * static_cast<std::size_t>(width), 0.0);
    limit_.take_from_receivers(values, width);
    cells_.fill_halo(values, width);
    weights_.at_particles(values, width, of_particles);
}

}  // namespace interphase
