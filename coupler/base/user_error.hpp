// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace interphase {

/// Something the user can put right. Says what is wrong (with the value), where, and what to do; the program prints
/// it once and ends with exit code 1.
class UserError : public std::runtime_error {
public:
    UserError(const std::string& what, const std::string& where, const std::string& remedy)
        : std::runtime_error(what + "\n  where:  " + where + "\n  remedy: " + remedy)
    {}

    /// A message that another rank has put together.
    explicit UserError(const std::string& message) : std::runtime_error(message) {}
};

}  // namespace interphase
