// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <type_traits>

namespace interphase {

/// A record of doubles only (a struct, or one double) as an array of them, to be weighted and summed. Its width is
/// known to the compiler, which unrolls.
template <class Record>
constexpr int width_of = static_cast<int>(sizeof(Record) / sizeof(double));

template <class Record>
using Numbers = Eigen::Array<double, width_of<Record>, 1>;

template <class Record>
Eigen::Map<Numbers<Record>> numbers(Record& record)
{
    static_assert(std::is_trivially_copyable_v<Record> && std::is_standard_layout_v<Record> &&
                  sizeof(Record) % sizeof(double) == 0);
    return Eigen::Map<Numbers<Record>>(reinterpret_cast<double*>(&record));
}

template <class Record>
Eigen::Map<const Numbers<Record>> numbers(const Record& record)
{
    static_assert(std::is_trivially_copyable_v<Record> && std::is_standard_layout_v<Record> &&
                  sizeof(Record) % sizeof(double) == 0);
    return Eigen::Map<const Numbers<Record>>(reinterpret_cast<const double*>(&record));
}

}  // namespace interphase
