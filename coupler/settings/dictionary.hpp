// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/vector.hpp"

namespace interphase {

/// A block of entries `key value;` as a user wrote them. It knows how values are written and where they stand; what is
/// allowed is the Reader's matter. Each value is asked for by the form it should have: nothing where it has another.
/// But for has(), the key must be there.
class Dictionary {
public:
    virtual ~Dictionary() = default;

    virtual std::vector<std::string> keys() const = 0;  ///< in their order
    virtual bool has(const std::string& key) const = 0;

    virtual std::optional<double> number(const std::string& key) const = 0;
    /// A word, or a text in quotes.
    virtual std::optional<std::string> text(const std::string& key) const = 0;
    /// (one "another/one"); the environment's variables are put in for $NAME, the home folder for ~.
    virtual std::optional<std::vector<std::string>> names(const std::string& key) const = 0;
    /// The same with all texts as they are written.
    virtual std::optional<std::vector<std::string>> texts(const std::string& key) const = 0;
    /// ((x y z) (x y z)).
    virtual std::optional<std::vector<Vector>> points(const std::string& key) const = 0;
    /// The entries in braces; null where there are none.
    virtual std::unique_ptr<Dictionary> block(const std::string& key) const = 0;

    /// The value, whatever it is, numbers to the last bit; "{...}" for a block.
    virtual std::string written(const std::string& key) const = 0;
    /// File, block and line of a key; without the line where it is not there.
    virtual std::string place(const std::string& key) const = 0;

    /// (1 2.5 3).
    virtual std::optional<Scalars> numbers(const std::string& key) const = 0;
};

}  // namespace interphase
