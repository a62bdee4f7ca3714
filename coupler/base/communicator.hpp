// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mpi.h>

#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "base/numbers.hpp"
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
    void sum(Scalars& values) const { combine(values.data(), values.size(), MPI_SUM); }
    long sum(long value) const;
    double max(double value) const;
    double min(double value) const;
    Vector max(const Vector& value) const;
    void max(Scalars& values) const { combine(values.data(), values.size(), MPI_MAX); }
    Vector min(const Vector& value) const;
    /// Of each number of a record of doubles.
    template <class Record>
    std::enable_if_t<std::is_class_v<Record> && std::is_trivially_copyable_v<Record>> sum(Record& record) const
    {
        combine(numbers(record).data(), static_cast<std::size_t>(width_of<Record>), MPI_SUM);
    }
    template <class Record>
    std::enable_if_t<std::is_class_v<Record> && std::is_trivially_copyable_v<Record>> max(Record& record) const
    {
        combine(numbers(record).data(), static_cast<std::size_t>(width_of<Record>), MPI_MAX);
    }
    bool any(bool value) const;
    void barrier() const;

    /// Each rank's `mine`, in rank order (all of the same length).
    Scalars all_gather(const Scalars& mine) const;

    /// Each rank's box, in rank order.
    std::vector<Box> gather_boxes(const Box& mine) const;

    /// Each rank's record, in rank order.
    template <class Record>
    std::vector<Record> all_gather(const Record& mine) const
    {
        static_assert(std::is_trivially_copyable_v<Record>);
        std::vector<Record> all(static_cast<std::size_t>(size_));
        MPI_Allgather(&mine, sizeof mine, MPI_BYTE, all.data(), sizeof mine, MPI_BYTE, comm_);
        return all;
    }

    /// Throws the lowest failing rank's problem as a UserError on every rank, so that all of them stop together.
    void fail_together(const std::optional<Problem>& problem) const;

private:
    void combine(double* values, std::size_t count, MPI_Op operation) const;
    double reduce(double value, MPI_Op operation) const;
    Vector reduce(const Vector& value, MPI_Op operation) const;
    /// `words` becomes on every rank what it is on rank `from`.
    void spread(std::string& words, int from) const;

    MPI_Comm comm_;
    int rank_ = 0;
    int size_ = 1;
};

}  // namespace interphase
