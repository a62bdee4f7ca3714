// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "base/user_error.hpp"

namespace interphase::test {

/// The problem that `action` ends with; one without words, and a failure of the test, where it ends well.
template <class Action>
Problem refused(const Action& action)
{
    try {
        action();
    } catch (const UserError& error) {
        return error.problem();
    }
    ADD_FAILURE() << "accepted";
    return {};
}

}  // namespace interphase::test
