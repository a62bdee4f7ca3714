// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/close_spheres.hpp"

namespace interphase {

CloseSpheres::CloseSpheres(const double* centre, const double* radius, std::size_t n)
{
    if (n == 0) return;
    const double smallest = *std::min_element(radius, radius + n);
    for (std::size_t i = 0; i < n; ++i) {
        const auto k = static_cast<std::size_t>(std::max(0, std::ilogb(radius[i] / smallest)));
        if (classes_.size() <= k) classes_.resize(k + 1);
        classes_[k].spheres.push_back({{centre[3 * i], centre[3 * i + 1], centre[3 * i + 2]}, radius[i], 0, i});
    }
    classes_.erase(std::remove_if(classes_.begin(), classes_.end(), [](const auto& of) { return of.spheres.empty(); }),
                   classes_.end());
    for (SizeClass& of : classes_)
        of.sort();
}

void CloseSpheres::SizeClass::sort()
{
    // A cell as wide as the largest diameter: two that overlap are in the same cell or in two side by side. The spare
    // part is for the rounding of an index.
    constexpr double spare = 1 + 1e-9;
    std::array<double, 3> high = low = spheres.front().at;
    for (const Sphere& sphere : spheres) {
        width = std::max(width, 2 * sphere.radius * spare);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], sphere.at[axis]);
            high[axis] = std::max(high[axis], sphere.at[axis]);
        }
    }
    // Cells are numbered with one more on each side; indices of those far away wrap in 20 bits an axis.
    stride[0] = 1;
    for (std::size_t axis = 1; axis < 3; ++axis) {
        constexpr std::int64_t most = 1 << 20;
        const double cells = std::floor((high[axis - 1] - low[axis - 1]) / width) + 3;
        stride[axis] = stride[axis - 1] * (cells < static_cast<double>(most) ? static_cast<std::int64_t>(cells) : most);
    }
    std::size_t places = 1024;
    while (places < 2 * spheres.size())
        places *= 2;
    mask = places - 1;

    first.assign(places + 1, 0);
    for (Sphere& sphere : spheres) {
        sphere.cell = cell_of(sphere.at);
        ++first[place(sphere.cell) + 1];
    }
    for (std::size_t p = 0; p < places; ++p)
        first[p + 1] += first[p];
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    std::vector<Sphere> sorted(spheres.size());
    for (const Sphere& sphere : spheres)
        sorted[next[place(sphere.cell)]++] = sphere;
    spheres.swap(sorted);
}

}  // namespace interphase
