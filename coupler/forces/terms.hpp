// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "forces/term.hpp"

namespace interphase {

/// A term that a case may ask for by name, beside drag and the pressure gradient, which are always there.
struct OptionalTerm {
    std::string_view name;
    std::unique_ptr<Term> (*make)();
    std::string_view sentence;
};

const std::vector<OptionalTerm>& optional_terms();

std::vector<std::string> names_of_optional_terms();

using Terms = std::vector<std::unique_ptr<Term>>;

/// The optional terms of these names, which have to be known (std::out_of_range otherwise).
Terms make_terms(const std::vector<std::string>& names);

}  // namespace interphase
