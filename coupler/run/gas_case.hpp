// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "base/engine_warnings.hpp"
#include "base/problem.hpp"
#include "run/case_gas.hpp"
#include "settings/dictionary.hpp"
#include "settings/settings.hpp"

namespace interphase {

/// The case on disk, as the gas engine reads it: time, dictionaries and, where the scene has a gas, mesh and fields.
class GasCase {
public:
    virtual ~GasCase() = default;

    virtual const Dictionary& coupling_dict() const = 0;     ///< system/couplingDict
    virtual const Dictionary& scene_parameters() const = 0;  ///< the file `parameters`; empty where there is none

    /// Reads mesh and fields. Not for `gas { model none; }`.
    virtual std::unique_ptr<CaseGas> make_gas(const Settings& settings) = 0;

    virtual std::string name() const = 0;    ///< of the case folder
    virtual std::string engine() const = 0;  ///< name and version

    virtual double time() const = 0;      ///< [s]
    virtual double end_time() const = 0;  ///< [s]; may change while it runs, beyond all bounds, too
    virtual double gas_step() const = 0;  ///< as given [s]
    virtual bool adjusts_gas_step() const = 0;
    virtual double largest_courant_number() const = 0;  ///< that an adjusted step may reach
    virtual double largest_gas_step() const = 0;        ///< that an adjusted step may have [s]

    /// Whether there is time left.
    virtual bool running() = 0;
    virtual void advance_time(double step) = 0;

    /// There is no time left from now on.
    virtual void stop() = 0;

    virtual bool write_due() const = 0;  ///< of the fields, at the present time
    virtual void write() = 0;            ///< the fields, now

    /// Its clock.
    virtual void keep(Archive& archive) = 0;
    /// The run goes on from where keep() has set the clock: before the first step, on all ranks. What there is to be
    /// told, on the first.
    virtual std::vector<Problem> go_on() { return {}; }
    /// What sums up over time and begins anew in a run that goes on, in words; empty where nothing does.
    virtual std::string sums_lost() const { return {}; }

    /// What the engine warned of so far; null where it has no words of its own.
    virtual EngineWarnings* warnings() { return nullptr; }

    /// Runs `body`; what the engine throws in it becomes a UserError with the engine's own words.
    virtual void with_own_errors(const std::function<void()>& body) const = 0;
};

}  // namespace interphase
