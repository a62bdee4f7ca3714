// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "base/problem.hpp"

namespace interphase {

/// A problem that ends the run: the program prints it once and ends with the exit code of its kind.
class UserError : public std::runtime_error {
public:
    explicit UserError(Problem problem) : std::runtime_error(problem.message()), problem_(std::move(problem)) {}
    UserError(const std::string& what, const std::string& where, const std::string& remedy)
        : UserError(Problem{what, where, remedy})
    {}

    const Problem& problem() const { return problem_; }

private:
    Problem problem_;
};

}  // namespace interphase
