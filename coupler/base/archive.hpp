// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstring>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/communicator.hpp"
#include "base/numbers.hpp"

namespace interphase {

class Archive;

/// Whether an object has keep(Archive&).
template <class Object, class = void>
inline constexpr bool keeps_itself = false;
template <class Object>
inline constexpr bool
    keeps_itself<Object, std::void_t<decltype(std::declval<Object&>().keep(std::declval<Archive&>()))>> = true;

/// The state of a rank's objects, by name, as bytes. An object with state has one function `keep(Archive&)` that names
/// its members in turn; the archive either takes them in or gives them back, so that what is saved is what is loaded:
///
///     void keep(Archive& archive) { archive.keep("time", time_); archive.keep("watch", watch_); }
///
/// What was taken in by the ranks of one run may be given back to more or fewer ranks, and to ranks whose gas cells are
/// others. How each entry fares then, its name of keeping says: keep() is for what all ranks have alike, keep_share()
/// for numbers that are meant as their sum, keep_cells() for values of the gas cells; what goes by other rules asks for
/// each rank's entry by part(). Then all of these are collective.
class Archive {
public:
    using State = std::map<std::string, std::vector<char>>;

    /// Takes in.
    Archive() = default;

    /// One that gives back what this one has taken in.
    Archive to_load() const
    {
        Archive archive;
        archive.state_ = state_;
        archive.loads_ = true;
        return archive;
    }

    /// One that gives back what another has taken in, as its state() tells.
    static Archive loading(State state)
    {
        Archive archive;
        archive.state_ = std::move(state);
        archive.loads_ = true;
        return archive;
    }

    /// One that gives back what the `parts` ranks of a run have taken in: `mine` holds those of rank r, r + size, ...
    /// of that run on rank r of `comm`.
    static Archive loading(const Communicator& comm, int parts, std::map<int, State> mine);

    /// Whether something of this name was taken in, by the first rank where the ranks are others. Collective.
    bool has(const std::string& name) const;

    /// Whether it gives back.
    bool loads() const { return loads_; }

    /// Whether each rank is given back what it has taken in itself; else the ranks are more or fewer than those were.
    bool same_ranks() const { return !comm_ || parts_ == comm_->size(); }
    /// Ranks that took in.
    int parts() const { return parts_; }

    /// What rank `part` of them took in under `name`, to all ranks. Throws a std::runtime_error on all where it has no
    /// such name. Collective.
    std::vector<char> part(int part, const std::string& name) const { return whole(part, prefix_ + name); }
    /// The same piece by piece, as the bytes of a large entry need not be on all ranks at once: each has at most `most`
    /// bytes, all but the last just as many.
    void part_in_pieces(int part, const std::string& name, std::size_t most,
                        const std::function<void(const std::vector<char>&)>& take) const;
    /// What part() gives, as values that lie side by side.
    template <class Value>
    std::vector<Value> part_as(int part, const std::string& name) const
    {
        return as<Value>(this->part(part, name), prefix_ + name);
    }

    /// An object that has keep(Archive&), also one whose bytes could be copied (it may hold references), a number or
    /// any other trivially copyable object, or a vector of such, which all ranks have alike (without gaps between
    /// members). Throws a std::runtime_error where it gives back and has no such name, or one of another size, or where
    /// other ranks are to be given what is not alike.
    template <class Object>
    void keep(const std::string& name, Object& object)
    {
        if constexpr (keeps_itself<Object>)
            within(name, [&] { object.keep(*this); });
        else {
            static_assert(std::is_trivially_copyable_v<Object>);
            bytes(name, &object, sizeof object);
        }
    }

    template <class Object>
    void keep(const std::string& name, std::vector<Object>& objects)
    {
        if constexpr (std::is_trivially_copyable_v<Object> && !keeps_itself<Object>) {
            if (loads_) objects.resize(saved(name).size() / sizeof(Object));
            bytes(name, objects.data(), objects.size() * sizeof(Object));
        } else {
            std::size_t count = objects.size();
            keep(name + ".count", count);
            objects.resize(count);
            for (std::size_t i = 0; i < count; ++i)
                keep(name + "." + std::to_string(i), objects[i]);
        }
    }

    void keep(const std::string& name, std::string& text)
    {
        std::vector<char> letters(text.begin(), text.end());
        keep(name, letters);
        text.assign(letters.begin(), letters.end());
    }

    template <class Number>
    void keep(const std::string& name, std::optional<Number>& number)
    {
        bool there = number.has_value();
        Number value = number.value_or(Number{});
        keep(name + ".there", there);
        keep(name, value);
        number = there ? std::optional<Number>(value) : std::nullopt;
    }

    /// A number, or a record of doubles, of which each rank has its share: the first rank of others gets the sum.
    template <class Share>
    void keep_share(const std::string& name, Share& share)
    {
        if (!loads_ || same_ranks()) return keep(name, share);
        Share sum{};
        for (int n = 0; n < parts_; ++n) {
            const std::vector<Share> of_part = part_as<Share>(n, name);
            if (of_part.size() != 1) throw std::runtime_error("a saved state has no one number in " + prefix_ + name);
            if constexpr (std::is_arithmetic_v<Share>)
                sum += of_part[0];
            else
                numbers(sum) += numbers(of_part[0]);
        }
        share = comm_->is_master() ? sum : Share{};
    }

    /// A number of which other ranks get the largest.
    template <class Number>
    void keep_largest(const std::string& name, Number& number)
    {
        if (!loads_ || same_ranks()) return keep(name, number);
        for (int n = 0; n < parts_; ++n)
            for (const Number& of_part : part_as<Number>(n, name))
                number = n == 0 ? of_part : std::max(number, of_part);
    }

    /// The values of an item (a gas cell) of a rank that took in, and of which item of this rank they become those.
    struct Move {
        int from, to;
    };
    /// How the gas cells have moved between ranks.
    struct CellMoves {
        std::string numbers;                  ///< under which name each rank's cells are numbered
        std::vector<int> own;                 ///< numbers of this rank's cells, the same for the same cells
        std::vector<std::vector<Move>> from;  ///< each rank that took in
        std::vector<std::size_t> cells;       ///< of each such rank
    };
    /// From now on cells are given back so. For whoever knows them (the gas engine), before others ask.
    void move_cells(CellMoves moves)
    {
        moves_ = std::move(moves);
        moves_->numbers.insert(0, prefix_);
    }
    /// Nothing where each rank is given its own cells.
    const std::optional<CellMoves>& moved_cells() const { return moves_; }
    /// The numbers of the cells of rank `part` of those that took in, where cells have moved. Collective.
    std::vector<int> cell_numbers(int part) const { return as<int>(whole(part, moves_->numbers), moves_->numbers); }

    /// Values of this rank's gas cells, so many for each cell; also none at all.
    template <class Value>
    void keep_cells(const std::string& name, std::vector<Value>& values)
    {
        if (!loads_ || !moves_) return keep(name, values);
        std::size_t width = 0;
        for (int n = 0; n < parts_; ++n) {
            const auto k = static_cast<std::size_t>(n);
            const std::vector<Value> of_part = part_as<Value>(n, name);
            if (of_part.empty()) continue;
            if (width == 0) {
                width = of_part.size() / std::max<std::size_t>(1, moves_->cells[k]);
                values.assign(width * moves_->own.size(), Value{});
            }
            if (of_part.size() != width * moves_->cells[k])
                throw std::runtime_error("a saved state has other cells in " + prefix_ + name);
            for (const Move& move : moves_->from[k])
                std::copy_n(&of_part[width * static_cast<std::size_t>(move.from)], width,
                            &values[width * static_cast<std::size_t>(move.to)]);
        }
        if (width == 0) values.clear();
    }

    /// So many numbers that lie side by side, whose count does not change.
    void keep(const std::string& name, double* numbers, std::size_t count)
    {
        bytes(name, numbers, count * sizeof(double));
    }

    /// What `body` keeps is named "name/...".
    template <class Body>
    void within(const std::string& name, const Body& body)
    {
        const std::string outside = prefix_;
        prefix_ += name + "/";
        body();
        prefix_ = outside;
    }

    const State& state() const { return state_; }

private:
    const std::vector<char>& saved(const std::string& name)
    {
        const auto entry = state_.find(prefix_ + name);
        if (entry != state_.end()) return entry->second;
        if (same_ranks()) throw std::runtime_error("a saved state has no " + prefix_ + name);
        return state_[prefix_ + name] = alike(name);
    }

    template <class Value>
    static std::vector<Value> as(const std::vector<char>& bytes, const std::string& name)
    {
        if (bytes.size() % sizeof(Value) != 0) throw std::runtime_error("a saved state is cut off in " + name);
        std::vector<Value> values(bytes.size() / sizeof(Value));
        if (!bytes.empty()) std::memcpy(static_cast<void*>(values.data()), bytes.data(), bytes.size());
        return values;
    }

    void whole_in_pieces(int part, const std::string& whole_name, std::size_t most,
                         const std::function<void(const std::vector<char>&)>& take) const;
    std::vector<char> whole(int part, const std::string& whole_name) const;
    std::vector<char> alike(const std::string& name) const;

    void bytes(const std::string& name, void* object, std::size_t size)
    {
        if (!loads_) {
            const char* first = static_cast<const char*>(object);
            state_[prefix_ + name].assign(first, first + size);
            return;
        }
        const std::vector<char>& given = saved(name);
        if (given.size() != size)
            throw std::runtime_error("a saved state has " + std::to_string(given.size()) + " bytes of " + prefix_ +
                                     name + " instead of " + std::to_string(size));
        if (size > 0) std::memcpy(object, given.data(), size);
    }

    State state_;  ///< of this rank; of others, what all have alike and was asked for
    std::string prefix_;
    bool loads_ = false;
    std::optional<Communicator> comm_;  ///< of the ranks that are given back to; none: each has its own
    int parts_ = 1;
    std::map<int, State> others_;  ///< of more or fewer ranks, those that this one has read
    std::optional<CellMoves> moves_;
};

}  // namespace interphase
