// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/box_mesh.hpp"

#include <algorithm>
#include <stdexcept>

#include "support/whole_mesh.hpp"

namespace interphase::test {

namespace {

/// As engines do: a longer walk is given up, and the whole part searched.
constexpr int longest_walk = 20;

std::size_t at(int axis) { return static_cast<std::size_t>(axis); }

}  // namespace

BoxMesh::BoxMesh(const Communicator& comm, Planes planes, int cut, const std::array<bool, 3>& periodic)
    : planes_(std::move(planes)), cut_(cut), rank_(comm.rank()), ranks_(comm.size())
{
    if (layers(cut_) < ranks_) throw std::invalid_argument("BoxMesh: fewer layers than ranks");
    Index low{0, 0, 0}, high{layers(0), layers(1), layers(2)};
    low[at(cut_)] = first_layer(rank_);
    high[at(cut_)] = first_layer(rank_ + 1);
    for (int k = low[2]; k < high[2]; ++k)
        for (int j = low[1]; j < high[1]; ++j)
            for (int i = low[0]; i < high[0]; ++i) {
                const Vector near(planes_[0][at(i)], planes_[1][at(j)], planes_[2][at(k)]);
                const Vector far(planes_[0][at(i + 1)], planes_[1][at(j + 1)], planes_[2][at(k + 1)]);
                extend(bounds_, near);
                extend(bounds_, far);
            }
    const WholeMesh whole = WholeMesh::of_boxes(planes_, periodic);
    std::vector<int> rank_of, number_on;
    for (int k = 0; k < layers(2); ++k)
        for (int j = 0; j < layers(1); ++j)
            for (int i = 0; i < layers(0); ++i) {
                const CellAddress address = address_of(Index{i, j, k});
                rank_of.push_back(address.rank);
                number_on.push_back(address.cell);
            }
    view_ = whole.part(rank_of, number_on, rank_);
}

int BoxMesh::rank_of_layer(int layer) const
{
    int rank = 0;
    while (first_layer(rank + 1) <= layer)
        ++rank;
    return rank;
}

BoxMesh::Index BoxMesh::index_of(const CellAddress& address) const
{
    Index count{layers(0), layers(1), layers(2)};
    count[at(cut_)] = first_layer(address.rank + 1) - first_layer(address.rank);
    Index index{address.cell % count[0], address.cell / count[0] % count[1], address.cell / (count[0] * count[1])};
    index[at(cut_)] += first_layer(address.rank);
    return index;
}

CellAddress BoxMesh::address_of(const Index& index) const
{
    const int rank = rank_of_layer(index[at(cut_)]);
    Index count{layers(0), layers(1), layers(2)}, local = index;
    count[at(cut_)] = first_layer(rank + 1) - first_layer(rank);
    local[at(cut_)] -= first_layer(rank);
    return {rank, local[0] + count[0] * (local[1] + count[1] * local[2])};
}

CellAddress BoxMesh::walk(const Vector& point, int start) const
{
    CellAddress here{rank_, start};
    for (int step = 0; step < longest_walk; ++step) {
        Index index = index_of(here);
        int moved = -1;
        for (int axis = 0; axis < 3 && moved < 0; ++axis) {
            const Scalars& planes = planes_[at(axis)];
            int& layer = index[at(axis)];
            const int towards = point[axis] < planes[at(layer)] ? -1 : point[axis] > planes[at(layer + 1)] ? 1 : 0;
            if (towards == 0) continue;
            if (layer + towards < 0 || layer + towards >= layers(axis)) return {};
            layer += towards;
            moved = axis;
        }
        if (moved < 0) return here;
        here = address_of(index);
        if (here.rank != rank_) return here;
    }
    return {};
}

CellAddress BoxMesh::search(const Vector& point) const
{
    if (!contains(bounds_, point)) return {};
    for (std::size_t c = 0; c < view_.size(); ++c)
        if (holds({rank_, static_cast<int>(c)}, point)) return {rank_, static_cast<int>(c)};
    return {};
}

NearCell BoxMesh::nearest(const Vector& point, double reach) const
{
    const Box box = whole();
    const Vector edge = point.cwiseMax(box.col(0)).cwiseMin(box.col(1));
    const double distance = (edge - point).norm();
    const CellAddress address = address_of(edge);
    return address.rank == rank_ && distance <= reach ? NearCell{address.cell, distance} : NearCell{};
}

CellAddress BoxMesh::address_of(const Vector& point) const
{
    Index index{};
    for (int axis = 0; axis < 3; ++axis) {
        const Scalars& planes = planes_[at(axis)];
        if (!(point[axis] >= planes.front() && point[axis] <= planes.back())) return {};
        const auto above = std::upper_bound(planes.begin(), planes.end(), point[axis]) - planes.begin();
        index[at(axis)] = std::clamp(static_cast<int>(above) - 1, 0, layers(axis) - 1);
    }
    return address_of(index);
}

bool BoxMesh::holds(const CellAddress& address, const Vector& point) const
{
    if (!address.known()) return false;
    const Index index = index_of(address);
    for (int axis = 0; axis < 3; ++axis) {
        const Scalars& planes = planes_[at(axis)];
        const int layer = index[at(axis)];
        if (!(point[axis] >= planes[at(layer)] && point[axis] <= planes[at(layer + 1)])) return false;
    }
    return true;
}

std::size_t BoxMesh::global_number(std::size_t own) const
{
    const Index index = index_of({rank_, static_cast<int>(own)});
    return at(index[0] + layers(0) * (index[1] + layers(1) * index[2]));
}

std::size_t BoxMesh::global_count() const { return at(layers(0) * layers(1) * layers(2)); }

Box BoxMesh::whole() const
{
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
        box(axis, 0) = planes_[at(axis)].front();
        box(axis, 1) = planes_[at(axis)].back();
    }
    return box;
}

Scalars BoxMesh::gradient(const Scalars& of_all_cells, std::optional<double> at_sides) const
{
    Scalars gradient(3 * view_.size());
    for (std::size_t c = 0; c < view_.size(); ++c) {
        const Index index = index_of({rank_, static_cast<int>(c)});
        const double own = of_all_cells[global_number(c)];
        for (int axis = 0, stride = 1; axis < 3; stride *= layers(axis++)) {
            const Scalars& planes = planes_[at(axis)];
            const int layer = index[at(axis)];
            const auto thickness = [&](int n) { return planes[at(n + 1)] - planes[at(n)]; };
            double face[2] = {at_sides.value_or(own), at_sides.value_or(own)};
            for (const int side : {0, 1}) {
                const int next = layer + (side == 0 ? -1 : 1);
                if (next < 0 || next >= layers(axis)) continue;
                const double share = thickness(layer) / (thickness(layer) + thickness(next));
                const auto there = static_cast<int>(global_number(c)) + (next - layer) * stride;
                face[side] = own + share * (of_all_cells[at(there)] - own);
            }
            gradient[3 * c + at(axis)] = (face[1] - face[0]) / thickness(layer);
        }
    }
    return gradient;
}

Scalars even_planes(double low, double high, int cells) { return graded_planes(low, high, cells, 1.0); }

Scalars graded_planes(double low, double high, int cells, double ratio)
{
    Scalars planes{0.0};
    double thickness = 1;
    for (int i = 0; i < cells; ++i) {
        planes.push_back(planes.back() + thickness);
        thickness *= ratio;
    }
    const double sum = planes.back();
    for (double& plane : planes)
        plane = low + (high - low) * plane / sum;
    planes.back() = high;
    return planes;
}

}  // namespace interphase::test
