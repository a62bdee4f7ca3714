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

void Mapping::place(const Vectors& positions, const std::vector<int>& cells)
{
    if (type_ == MappingType::kernel)
        weights_.spread_by_kernel(positions, cells);
    else
        weights_.place_in_own_cell(cells);
}

Scalars Mapping::solid_volume(const Scalars& of_particles)
{
    Scalars volume(cells_.local_count(), 0.0);
    weights_.deposit(of_particles, volume);
    cells_.add_halo_to_owners(volume);
    limit_.relieve(volume);
    volume.resize(cells_.own_count());
    return volume;
}

}  // namespace interphase
