// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "fix.h"
#include "mp_pic/any_stress.hpp"
#include "mp_pic/wall_bounce.hpp"
#include "plugin/counter.hpp"
#include "plugin/solid_stress.hpp"
#include "walls/wall_set.hpp"

namespace interphase::mp_pic {

/// The LIGGGHTS fix styles `mp_pic` and `mp_pic/NAME` (fix_mp_pic_of.hpp makes one of a stress): moves the particles of
/// its group without rotation and without collisions among each other. In their place the stress of the solids on the
/// gas mesh, which the coupler brings, guides the velocity; off walls (fixes `wall/mp_pic[/NAME]`) particles bounce.
/// What the script may say stands in the folder's README.
///
/// A step is that of LIGGGHTS's own integrators (velocity Verlet: half a kick, a drift, the forces, half a kick), with
/// the stress's change of velocity before the drift. So it is no part of the forces, and the gas, which answers for
/// these (FluidForce), does not take it for another's.
class FixMpPic : public LAMMPS_NS::Fix, public SolidStress {
public:
    /// `stresses`: those that the script may choose from; `usual`: its words behind `stress` where it chooses none.
    /// Where these are none either, it has to choose.
    FixMpPic(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg, const std::vector<AnyStress>& stresses,
             const std::vector<std::string>& usual = {});
    ~FixMpPic() override;

    int setmask() override;
    void init() override;
    void setup(int) override;
    void initial_integrate(int) override;
    void final_integrate() override;
    void* extract(const char* name, int& dimension) override;

    /// The sums, beside what travels with the particles.
    void write_restart(FILE* file) override;
    void restart(char* buffer) override;

    void grow_arrays(int count) override;
    void copy_arrays(int from, int to, int) override;
    void set_arrays(int i) override;
    int pack_exchange(int i, double* buffer) override;
    int unpack_exchange(int i, double* buffer) override;
    double memory_usage() override;

    /// What `thermo_style custom v_ID_NAME` or f_ID[k] shows; see the README. Collective.
    double compute_vector(int k) override;

    double stress(double solid_fraction) const override { return stress_(solid_fraction); }
    double close_packing() const override { return close_packing_; }
    bool refuses_overfilled_start() const override { return refuses_overfilled_; }
    StressState* states() override { return states_.data(); }
    StepTooLong begin(double gas_step) override;
    const char* complaint() const override { return complaint_.empty() ? nullptr : complaint_.c_str(); }

private:
    /// Ends the run; the message begins with the style. Collective.
    void complain(const std::string& what) const;
    void read_arguments(const std::vector<std::string>& words, const std::vector<AnyStress>& stresses,
                        const std::vector<std::string>& usual);
    void warn_of_unpublished(const AnyStress& stress, const std::vector<double>& values) const;
    void check_stress(const AnyStress& stress, const std::string& table) const;
    void refuse_company() const;
    void read_restitution();
    void kick(int i, double dt);
    Vector take_stress(int i);
    void move(int i);
    void follow_walls();
    void complain_of_step(int particle, double gas_step, double longest);

    // what the script says
    StressFunction stress_;  ///< none: they do not feel each other
    double close_packing_ = 0.6;
    bool refuses_overfilled_ = true;
    bool refuses_long_steps_ = false;
    double courant_ = 1, relaxation_share_ = 1;

    std::vector<double> restitution_;              ///< among particles, by type
    std::vector<std::vector<WallLaw>> wall_laws_;  ///< by type of particle and of wall
    walls::WallSet walls_;                         ///< where they will be at the end of the next step

    std::vector<StressState> states_;  ///< [atoms]
    bool kicked_whole_ = false;        ///< where the stress acts, by the forces of the gas step
    bool arrived_ = false;
    std::string complaint_;

    enum Sum { by_stress = 0, by_walls = 3, bounces = 6, pushed = 7, sum_number = 8 };
    /// Since the start, of this rank: momentum that stress and walls gave [kg m/s]; bounces, put out of walls.
    std::array<double, sum_number> sums_{};
    CounterValues counted_{1, &sums_[pushed]};
};

}  // namespace interphase::mp_pic
