// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "run/gas_case.hpp"
#include "run/run_options.hpp"

namespace interphase {

/// The OpenFOAM case on disk: command line, time, dictionaries and, where the scene has a gas, mesh and fields. What
/// OpenFOAM says goes to log.openfoam in the case folder. (OpenFOAM's headers stay out of this one.)
class FoamCase : public GasCase {
public:
    /// Reads the command line (-case DIR, -parallel, ...) and the dictionaries; makes DIR the current folder.
    FoamCase(int& argc, char**& argv);
    ~FoamCase() override;

    const Dictionary& coupling_dict() const override;
    const Dictionary& scene_parameters() const override;
    std::unique_ptr<CaseGas> make_gas(const Settings& settings) override;

    std::string name() const override;
    std::string engine() const override { return "OpenFOAM " + version(); }
    static std::string version();
    RunOptions options() const;  ///< as the command line has them

    double time() const override;
    double end_time() const override;
    double gas_step() const override;  ///< deltaT of controlDict [s]
    bool adjusts_gas_step() const override;
    double largest_courant_number() const override;  ///< maxCo of controlDict
    double largest_gas_step() const override;        ///< maxDeltaT [s]

    bool running() override;  ///< and runs the function objects
    void advance_time(double step) override;
    void stop() override;

    bool write_due() const override;  ///< by writeControl and writeInterval
    void write() override;

    void keep(Archive& archive) override;
    std::vector<Problem> go_on() override;
    std::string sums_lost() const override;  ///< of function objects

    EngineWarnings* warnings() override;
    void with_own_errors(const std::function<void()>& body) const override;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace interphase
