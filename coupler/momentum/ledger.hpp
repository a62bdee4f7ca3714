// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "base/communicator.hpp"

namespace interphase {

/// The account of one conserved quantity over a run. Each step its two sides are summed independently, one over the
/// cells and one over the particles or the boundary; numbers of a step are those of this rank.
class Account {
public:
    Account(std::string key, std::string sides, std::string relative_to)
        : key_(std::move(key)), sides_(std::move(sides)), relative_to_(std::move(relative_to))
    {}
    virtual ~Account() = default;

    const std::string& key() const { return key_; }                  ///< "momentum", as records name it
    const std::string& sides() const { return sides_; }              ///< "momentum, gas against particles"
    const std::string& relative_to() const { return relative_to_; }  ///< "of the impulse exchanged"
    virtual double residual() const = 0;                             ///< what is missing, relative to that

    /// The step's numbers, to be summed over the ranks.
    virtual void hand_in(Scalars& numbers) const = 0;
    /// Books their sums, and clears the step. Returns what follows them.
    virtual const double* book(const double* sums) = 0;

    virtual void keep(Archive& archive) = 0;

private:
    std::string key_, sides_, relative_to_;
};

/// A quantity of n components that gas and particles hand to each other, the particles' side one step late: momentum
/// [kg m/s], or heat.
class ExchangeAccount : public Account {
public:
    ExchangeAccount(std::string key, std::string sides, std::string relative_to, int components);

    struct Step {
        Eigen::VectorXd given_by_gas;        ///< from the cells' side
        Eigen::VectorXd taken_by_particles;  ///< from the particles' side, summed over the substeps: of all that took
        Eigen::VectorXd owed;                ///< taken less assumed: the next gas step's
        Eigen::VectorXd carried_off;         ///< assumed less taken, of particles that left
    } step;

    /// |given - (taken + carried off - owed)| over all steps, relative to the amount exchanged.
    double residual() const override;
    double exchanged() const { return exchanged_; }
    /// What the gas gave to particles that left, and they did not take.
    const Eigen::VectorXd& carried_off() const { return carried_off_; }

    void hand_in(Scalars& numbers) const override;
    const double* book(const double* sums) override;

    void keep(Archive& archive) override;

private:
    void clear();

    Eigen::Index components_;
    Eigen::VectorXd given_, taken_, owed_, carried_off_;
    double exchanged_ = 0;
};

/// A quantity that both sides know at any time: the solid volume [m3] in the cells and of the particles.
class SharedAccount : public Account {
public:
    using Account::Account;

    struct Step {
        double in_cells = 0, of_particles = 0;
    } step;

    /// |in cells - of particles| over the latter, in the last step.
    double residual() const override { return residual_; }

    void hand_in(Scalars& numbers) const override;
    const double* book(const double* sums) override;

    void keep(Archive& archive) override { archive.keep("residual", residual_); }

private:
    double residual_ = 0;
};

/// A content that changes by what comes and goes only: the gas volume of the cells, the volume of all solids [m3].
class StockAccount : public Account {
public:
    using Account::Account;

    struct Step {
        double content = 0, in = 0, out = 0;
    } step;

    /// |content - what was there at first - in + out| over all steps, relative to the largest so far, of either side:
    /// what was summed up on the way has the round-off of that, and a vessel that ends empty must not divide by
    /// nothing.
    double residual() const override { return residual_; }

    void hand_in(Scalars& numbers) const override;
    const double* book(const double* sums) override;

    void keep(Archive& archive) override
    {
        archive.keep("expected", expected_);
        archive.keep("largest", largest_);
        archive.keep("residual", residual_);
    }

private:
    std::optional<double> expected_;  ///< by the boundary's side
    double largest_ = 0, residual_ = 0;
};

/// The books: one account a conserved quantity.
class Ledger {
public:
    explicit Ledger(const Communicator& comm) : comm_(comm) {}

    ExchangeAccount momentum{"momentum", "momentum, gas against particles", "of the impulse exchanged", 3};
    SharedAccount solid_volume{"volume", "solid volume, cells against particles", "of the total"};
    StockAccount gas_volume{"gas_volume", "gas volume, cells against boundary", "of the total"};
    StockAccount solids{"solids", "solid volume, all particles against those that came and went",
                        "of the most there were"};

    std::vector<const Account*> accounts() const { return {&momentum, &solid_volume, &gas_volume, &solids}; }

    /// Books the step that the accounts were told. Collective.
    void book();

    void keep(Archive& archive)
    {
        for (Account* account : all())
            archive.keep(account->key(), *account);
    }

private:
    std::vector<Account*> all() { return {&momentum, &solid_volume, &gas_volume, &solids}; }

    Communicator comm_;
};

}  // namespace interphase
