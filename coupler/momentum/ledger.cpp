// SPDX-License-Identifier: GPL-3.0-or-later
#include "momentum/ledger.hpp"

#include <algorithm>
#include <cmath>

namespace interphase {

ExchangeAccount::ExchangeAccount(std::string key, std::string sides, std::string relative_to, int components)
    : Account(std::move(key), std::move(sides), std::move(relative_to)),
      components_(components),
      given_(Eigen::VectorXd::Zero(components)),
      taken_(given_),
      owed_(given_),
      carried_off_(given_)
{
    clear();
}

void ExchangeAccount::clear()
{
    for (Eigen::VectorXd* numbers : {&step.given_by_gas, &step.taken_by_particles, &step.owed, &step.carried_off})
        numbers->setZero(components_);
}

void ExchangeAccount::hand_in(Scalars& numbers) const
{
    for (const Eigen::VectorXd* part : {&step.given_by_gas, &step.taken_by_particles, &step.owed, &step.carried_off})
        numbers.insert(numbers.end(), part->data(), part->data() + components_);
}

const double* ExchangeAccount::book(const double* sums)
{
    const auto part = [&](int n) { return Eigen::Map<const Eigen::VectorXd>(sums + n * components_, components_); };
    given_ += part(0);
    taken_ += part(1);
    owed_ = part(2);
    carried_off_ += part(3);
    exchanged_ += part(0).norm();
    clear();
    return sums + 4 * components_;
}

void ExchangeAccount::keep(Archive& archive)
{
    const auto count = static_cast<std::size_t>(components_);
    archive.keep("given", given_.data(), count);
    archive.keep("taken", taken_.data(), count);
    archive.keep("owed", owed_.data(), count);
    archive.keep("carried_off", carried_off_.data(), count);
    archive.keep("exchanged", exchanged_);
}

double ExchangeAccount::residual() const
{
    return exchanged_ > 0 ? (given_ - (taken_ + carried_off_ - owed_)).norm() / exchanged_ : 0.0;
}

void SharedAccount::hand_in(Scalars& numbers) const
{
    numbers.insert(numbers.end(), {step.in_cells, step.of_particles});
}

const double* SharedAccount::book(const double* sums)
{
    residual_ = sums[1] > 0 ? std::abs(sums[0] - sums[1]) / sums[1] : 0.0;
    step = {};
    return sums + 2;
}

void StockAccount::hand_in(Scalars& numbers) const { numbers.insert(numbers.end(), {step.content, step.in, step.out}); }

const double* StockAccount::book(const double* sums)
{
    const double content = sums[0], net_inflow = sums[1] - sums[2];
    expected_ = expected_ ? *expected_ + net_inflow : content;
    largest_ = std::max({largest_, content, *expected_});
    residual_ = largest_ > 0 ? std::abs(content - *expected_) / largest_ : 0.0;
    step = {};
    return sums + 3;
}

void Ledger::book()
{
    Scalars sums;
    for (const Account* account : accounts())
        account->hand_in(sums);
    comm_.sum(sums);
    const double* next = sums.data();
    for (Account* account : all())
        next = account->book(next);
}

}  // namespace interphase
