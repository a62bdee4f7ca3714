// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/communicator.hpp"

#include "base/user_error.hpp"

namespace interphase {

Communicator::Communicator(MPI_Comm comm) : comm_(comm)
{
    MPI_Comm_rank(comm_, &rank_);
    MPI_Comm_size(comm_, &size_);
}

double Communicator::reduce(double value, MPI_Op operation) const
{
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, operation, comm_);
    return value;
}

Vector Communicator::reduce(const Vector& value, MPI_Op operation) const
{
    Vector result = value;
    MPI_Allreduce(MPI_IN_PLACE, result.data(), 3, MPI_DOUBLE, operation, comm_);
    return result;
}

double Communicator::sum(double value) const { return reduce(value, MPI_SUM); }
double Communicator::max(double value) const { return reduce(value, MPI_MAX); }
double Communicator::min(double value) const { return reduce(value, MPI_MIN); }
Vector Communicator::sum(const Vector& value) const { return reduce(value, MPI_SUM); }
Vector Communicator::max(const Vector& value) const { return reduce(value, MPI_MAX); }
Vector Communicator::min(const Vector& value) const { return reduce(value, MPI_MIN); }

void Communicator::combine(double* values, std::size_t count, MPI_Op operation) const
{
    MPI_Allreduce(MPI_IN_PLACE, values, static_cast<int>(count), MPI_DOUBLE, operation, comm_);
}

long Communicator::sum(long value) const
{
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_LONG, MPI_SUM, comm_);
    return value;
}

bool Communicator::any(bool value) const { return sum(static_cast<long>(value)) > 0; }

void Communicator::barrier() const { MPI_Barrier(comm_); }

Scalars Communicator::all_gather(const Scalars& mine) const
{
    const int n = static_cast<int>(mine.size());
    Scalars all(mine.size() * static_cast<std::size_t>(size_));
    MPI_Allgather(mine.data(), n, MPI_DOUBLE, all.data(), n, MPI_DOUBLE, comm_);
    return all;
}

std::vector<Box> Communicator::gather_boxes(const Box& mine) const
{
    const Scalars all = all_gather(Scalars(mine.data(), mine.data() + mine.size()));
    std::vector<Box> boxes;
    for (int rank = 0; rank < size_; ++rank)
        boxes.emplace_back(Eigen::Map<const Box>(all.data() + rank * mine.size()));
    return boxes;
}

void Communicator::spread(std::string& words, int from) const
{
    int length = static_cast<int>(words.size());
    MPI_Bcast(&length, 1, MPI_INT, from, comm_);
    words.resize(static_cast<std::size_t>(length));
    MPI_Bcast(words.data(), length, MPI_CHAR, from, comm_);
}

void Communicator::fail_together(const std::optional<Problem>& problem) const
{
    int lowest = problem ? rank_ : size_;
    MPI_Allreduce(MPI_IN_PLACE, &lowest, 1, MPI_INT, MPI_MIN, comm_);
    if (lowest == size_) return;
    Problem told = problem.value_or(Problem{});
    for (std::string* words : {&told.what, &told.where, &told.remedy, &told.when, &told.step})
        spread(*words, lowest);
    MPI_Bcast(&told.kind, static_cast<int>(sizeof told.kind), MPI_BYTE, lowest, comm_);
    throw UserError(told);
}

}  // namespace interphase
