// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mpi.h>

#include <optional>
#include <string>
#include <vector>

#include "base/problem.hpp"
#include "base/vector.hpp"

namespace interphase {

/// The ranks of a run. Every member function is collective.
class Communicator {
public:
    explicit Communicator(MPI_Comm comm = MPI_COMM_WORLD);

    int rank() const { return rank_; }
    int size() const { return size_; }
    bool is_master() const { return rank_ == 0; }
    MPI_Comm handle() const { return comm_; }

    double sum(double value) const;
    Vector sum(const Vector& value) const;
    void sum(Scalars& values) const;
    long sum(long value) const;
    double max(double value) const;
    double min(double value) const;
    Vector max(const Vector& value) const;
    void max(Scalars& values) const;
    Vector min(const Vector& value) const;
    bool any(bool value) const;
    void barrier() const;

    /// Each rank's `mine`, in rank order (all of the same length).
    Scalars all_gather(const Scalars& mine) const;

    /// Throws the lowest failing rank's problem as a UserError on every rank, so that all of them stop together.
    void fail_together(const std::optional<Problem>& problem) const;

private:
    double reduce(double value, MPI_Op operation) const;
    Vector reduce(const Vector& value, MPI_Op operation) const;
    /// `words` becomes on every rank what it is on rank `from`.
    void spread(std::string& words, int from) const;

    MPI_Comm comm_;
    int rank_ = 0;
    int size_ = 1;
};

}  // namespace interphase
