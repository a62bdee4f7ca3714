// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "engines/openfoam/foam_gas.hpp"
#include "settings/dictionary.hpp"
#include "settings/settings.hpp"

namespace interphase {

/// The OpenFOAM case on disk: command line, time, dictionaries and, where the scene has a gas, mesh and fields. What
/// OpenFOAM says goes to log.openfoam in the case folder. (OpenFOAM's headers stay out of this one.)
class FoamCase {
public:
    /// Reads the command line (-case DIR, -parallel, ...) and the dictionaries; makes DIR the current folder.
    FoamCase(int& argc, char**& argv);
    ~FoamCase();

    const Dictionary& coupling_dict() const;     ///< system/couplingDict
    const Dictionary& scene_parameters() const;  ///< the file `parameters`; empty where there is none

    /// Reads mesh and fields. Not for `gas { model none; }`.
    std::unique_ptr<FoamGas> make_gas(const Settings& settings);

    std::string name() const;  ///< of the case folder
    static std::string version();

    double time() const;      ///< [s]
    double end_time() const;  ///< [s]
    double gas_step() const;  ///< deltaT of controlDict [s]
    bool adjusts_gas_step() const;
    double largest_courant_number() const;  ///< maxCo of controlDict
    double largest_gas_step() const;        ///< maxDeltaT [s]

    /// Whether there is time left; runs the function objects.
    bool running();
    void advance_time(double step);

    bool write_due() const;  ///< by writeControl and writeInterval
    void write();            ///< the fields, now

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// Runs `body`; what OpenFOAM throws in it becomes a UserError with OpenFOAM's own words.
void with_foam_errors(const std::function<void()>& body);

}  // namespace interphase
