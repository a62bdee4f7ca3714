// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapping/mesh_view.hpp"

namespace interphase {

std::vector<std::vector<int>> MeshView::faces_of_cells() const
{
    std::vector<std::vector<int>> faces_of(size());
    for (std::size_t f = 0; f < faces.size(); ++f)
        for (const int cell : {faces[f].owner, faces[f].neighbour})
            if (cell >= 0) faces_of[static_cast<std::size_t>(cell)].push_back(static_cast<int>(f));
    return faces_of;
}

std::vector<std::vector<std::size_t>> MeshView::halves_by_rank(int ranks) const
{
    std::vector<std::vector<std::size_t>> halves(static_cast<std::size_t>(ranks));
    for (std::size_t f = 0; f < faces.size(); ++f)
        if (faces[f].partner >= 0) halves[static_cast<std::size_t>(faces[f].partner_rank)].push_back(f);
    return halves;
}

}  // namespace interphase
