// SPDX-License-Identifier: GPL-3.0-or-later
#include "momentum/ledger.hpp"

#include <cmath>

namespace interphase {

void Ledger::book(const Transactions& mine, const Vector& assumed_at_start, bool particles_left)
{
    Scalars sums;
    for (const Vector* v :
         {&mine.given_by_gas, &mine.taken_by_particles, &mine.pending, &mine.assumed_of_particles, &assumed_at_start})
        sums.insert(sums.end(), v->data(), v->data() + 3);
    sums.push_back(mine.solid_volume_in_cells);
    sums.push_back(mine.solid_volume_of_particles);
    for (const double volume : {mine.gas_volume, mine.gas_in, mine.gas_out})
        sums.push_back(volume);
    comm_.sum(sums);

    const auto vector = [&](std::size_t n) { return Vector(sums[3 * n], sums[3 * n + 1], sums[3 * n + 2]); };
    given_ += vector(0);
    taken_ += vector(1);
    pending_ = vector(2);
    if (particles_left) carried_off_ += vector(4) - vector(3);
    exchanged_ += vector(0).norm();

    const double in_cells = sums[15], of_particles = sums[16];
    volume_residual_ = of_particles > 0 ? std::abs(in_cells - of_particles) / of_particles : 0.0;

    const double gas = sums[17], net_inflow = sums[18] - sums[19];
    gas_expected_ = gas_expected_ ? *gas_expected_ + net_inflow : gas;
    gas_volume_residual_ = gas > 0 ? std::abs(gas - *gas_expected_) / gas : 0.0;
}

double Ledger::momentum_residual() const
{
    if (exchanged_ == 0) return 0;
    return (given_ - (taken_ + carried_off_ - pending_)).norm() / exchanged_;
}

}  // namespace interphase
