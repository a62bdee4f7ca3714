// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/archive.hpp"
#include "base/count.hpp"
#include "forces/needs.hpp"
#include "forces/particle_in_gas.hpp"
#include "forces/response.hpp"

namespace interphase {

/// An interphase term: one part of what the gas does to the particles.
class Term {
public:
    virtual ~Term() = default;

    virtual Needs needs() const { return {}; }

    /// Adds to `response` what the term does to one particle. Terms act in the order of terms.cpp; drag, which depends
    /// on what the others do, is the last.
    virtual void act(const ParticleInGas& at, Response& response) = 0;

    /// Of this rank.
    virtual std::vector<Count> counts() const { return {}; }

    /// What it knows of steps before: its counts, as a rule.
    virtual void keep(Archive&) {}
};

}  // namespace interphase
