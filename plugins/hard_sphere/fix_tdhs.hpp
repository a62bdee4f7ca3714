// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "comm.h"
#include "contacts/ghost_reach.hpp"
#include "fix.h"
#include "hard_sphere/any_law.hpp"
#include "hard_sphere/cell_grid.hpp"
#include "hard_sphere/contact_solver.hpp"
#include "hard_sphere/cost.hpp"
#include "hard_sphere/counters.hpp"
#include "hard_sphere/effort.hpp"
#include "hard_sphere/messages.hpp"
#include "hard_sphere/pair_search.hpp"
#include "walls/wall_set.hpp"

namespace interphase::hard_sphere {

/// The LIGGGHTS fix styles `tdhs` and `tdhs/LAW`: time-driven hard spheres, whose contacts follow a law
/// (fix_tdhs_of.hpp makes a style of it). It is the integrator of its group and resolves all contacts of the group's
/// spheres, among each other, with spheres outside the group (which it holds as they are) and with the walls that fixes
/// `wall/tdhs[/LAW]` describe. What the script may say stands in the folder's README.
///
/// A step: velocities take up all forces but contacts (eq. 9 of the paper), contacts change velocities, positions
/// follow. Velocities belong to the middle of the step before the position's time, as in LIGGGHTS's own integrators
/// after their second half.
class FixTdhs : public LAMMPS_NS::Fix {
public:
    FixTdhs(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg, std::unique_ptr<AnyLaw> law);
    ~FixTdhs() override;

    int setmask() override;
    void* extract(const char* name, int& dimension) override;
    void init() override;
    void setup(int) override;
    void setup_pre_neighbor() override { ghosts_.renew(); }
    void pre_neighbor() override { ghosts_.renew(); }
    double extend_cut_ghost() override { return ghosts_.distance(); }
    void initial_integrate(int) override;
    void final_integrate() override;
    void post_run() override;

    /// How many parts the next step has and what they look at, beside what travels with the particles.
    void write_restart(FILE* file) override;
    void restart(char* buffer) override;

    void setup_pre_exchange() override { pre_exchange(); }
    void pre_exchange() override;
    void grow_arrays(int count) override;
    void copy_arrays(int from, int to, int) override;
    void set_arrays(int i) override;
    int pack_exchange(int i, double* buffer) override;
    int unpack_exchange(int i, double* buffer) override;
    double memory_usage() override;

    int pack_comm(int n, int* list, double* buffer, int, int*) override;
    void unpack_comm(int n, int first, double* buffer) override;
    int pack_reverse_comm(int n, int first, double* buffer) override;
    void unpack_reverse_comm(int n, int* list, double* buffer) override;

    /// What `thermo_style custom v_ID_NAME` or f_ID[k] shows; see the README.
    double compute_vector(int k) override;

private:
    struct ShownValue {
        const char* name;
        double (*of)(const FixTdhs&);
    };
    static const std::vector<ShownValue>& shown_values();

    /// Of messages.hpp, the one that LIGGGHTS is asked to pass on.
    enum class Message { sizes, pulls, start, counts, motion, shift };

    /// Ends the run; the message begins with the style. Collective.
    void complain(const std::string& what) const;
    void read_arguments(int narg, char** arg);
    void refuse_company();
    void read_materials();
    void measure_spheres();
    void collect_walls();
    void follow_walls();
    void tell_walls();  ///< what spheres did to them, if they sum it up
    void ask_gravity();
    void check_law();
    void add_forces();
    void attract();
    void add_up_pulls();
    double pull();
    PullMessage pull_of(std::size_t body) const;
    void gather(double reach);
    void gather(int first, int last);
    void choose_effort();
    void choose_parts();
    void move();
    void resolve_contacts(bool attracting = false);
    bool has_ghosts() const;
    void tell_counts();  ///< of touches, to the ranks that have a sphere as a ghost

    /// A body that several ranks change in a pass is, for each, a part of it: the ranks would all give it the whole
    /// answer otherwise, and shake it (mass splitting: Tonge et al., ACM Trans. Graph. 31 (2012) 105).
    void split_masses();
    void join_masses();
    void share_changes();

    void scatter();
    template <class... Values>
    void say(const char* format, Values... values) const
    {
        if (comm->me != 0) return;
        for (FILE* stream : {screen, logfile})
            if (stream) std::fprintf(stream, format, values...);
    }
    double shared_max(double value) const;

    // what the script says
    int passes_given_ = 0;      ///< 0: not
    double margin_given_ = -1;  ///< below 0: not
    double share_ = 0.8, relief_ = 0, tolerated_ = 3e-3;
    double resting_speed_ = -1;  ///< [m/s]; below 0: from gravity
    bool shortens_ = true;

    // Passes that go along gravity, and upwards last, carry a bed's weight through it at once.
    double gravity_ = 0;  ///< [m/s2]
    int up_axis_ = 2;
    bool up_is_forward_ = true;

    bool started_ = false;

    int parts_ = 1;  ///< of the step, so that no sphere moves too far in one
    Effort effort_{};
    std::array<double, counter_number> counted_{};  ///< so far
    CounterValues counter_values_{counted_.size(), counted_.data()};

    std::unique_ptr<AnyLaw> law_;
    walls::WallSet walls_;
    StepLimits limits_{};
    double reach_ = 0;             ///< gap up to which pairs are looked for [m]
    contacts::GhostReach ghosts_;  ///< as far away as a pair may be that meets within one step
    double smallest_radius_ = 0;   ///< [m]
    bool sizes_change_ = false;    ///< while the run goes on

    double range_ = 0;  ///< of the law's attraction; 0: it has none [m]
    std::vector<Attraction> attractions_;
    std::vector<Vector> pulls_;  ///< impulses by these [bodies, kg m/s]
    double pulled_ = 0;          ///< the largest change of a velocity by them in the last step, of all ranks [m/s]

    Scalars push_;   ///< [atoms x 3]
    Scalars shift_;  ///< not yet in the positions [atoms x 3, m]
    ImpulseMemory memory_;
    int room_ = 0;  ///< for what a sphere takes along, as LIGGGHTS was asked for at the last exchange [numbers]

    Bodies bodies_;
    CellGrid grid_;
    PairSearch pairs_;
    std::vector<Contact> wall_contacts_;
    ContactSolver solver_;
    std::vector<std::uint8_t>* counts_ = nullptr;  ///< the solver's, which ranks tell each other
    std::vector<int> body_of_;                     ///< [atoms, ghosts included]
    std::vector<Body> shared_;                     ///< as all ranks last knew them, masses whole [bodies]
    Message message_ = Message::start;
    Cost cost_;
};

}  // namespace interphase::hard_sphere
