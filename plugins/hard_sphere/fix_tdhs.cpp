// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_sphere/fix_tdhs.hpp"

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix_gravity.h"
#include "hard_sphere/fix_wall_tdhs.hpp"
#include "hard_sphere/messages.hpp"
#include "hard_sphere/processor.hpp"
#include "hard_sphere/wall_contacts.hpp"
#include "modify.h"
#include "plugin/plugin.hpp"
#include "script/script.hpp"
#include "update.h"

namespace interphase::hard_sphere {

namespace {

constexpr int grow_callback = 0;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

FixTdhs::FixTdhs(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg, std::unique_ptr<AnyLaw> law)
    : Fix(lmp, narg, arg),
      law_(std::move(law)),
      ghosts_(*lmp, 4),
      memory_(static_cast<std::size_t>((law_->rolls() ? 3 : 0) + law_->state_count()))
{
    if (!atom->sphere_flag) complain("the particles are no spheres; use atom_style granular");
    time_integrate = 1;
    create_attribute = 1;
    restart_global = 1;
    comm_forward = most_forward;
    comm_reverse = most_reverse;
    vector_flag = 1;
    size_vector = static_cast<int>(shown_values().size());
    global_freq = 1;
    extvector = 0;
    read_arguments(narg, arg);
    std::vector<std::string> names;
    for (const ShownValue& value : shown_values())
        names.emplace_back(value.name);
    script::name_values(*lmp, *this, names);
    grow_arrays(atom->nmax);
    atom->add_callback(grow_callback);
}

FixTdhs::~FixTdhs() { atom->delete_callback(id, grow_callback); }

void FixTdhs::post_run()
{
    if (counted_[steps_in_parts] > 0)
        say("Fix %s resolved contacts in more than one part in %.0f steps, for fast spheres or walls\n", style,
            counted_[steps_in_parts]);
    const double deepest = shared_max(counted_[deepest_overlap]);
    if (deepest > deep)
        say("Fix %s: the deepest overlap was %g of the smallest diameter. If the bed sinks, give more `passes` (now "
            "%d) "
            "or a shorter step\n",
            style, deepest, effort_.passes);
}

namespace {

/// In a restart file.
struct StepState {
    StepLimits limits;
    double reach, parts, pulled;
    std::array<double, counter_number> counted;
};

}  // namespace

void FixTdhs::write_restart(FILE* file)
{
    StepState state{limits_, reach_, static_cast<double>(parts_), pulled_, counted_};
    state.counted[deepest_overlap] = shared_max(counted_[deepest_overlap]);
    MPI_Allreduce(&counted_[impulses_left_out], &state.counted[impulses_left_out], 1, MPI_DOUBLE, MPI_SUM, world);
    if (comm->me != 0) return;
    const int bytes = sizeof state;
    std::fwrite(&bytes, sizeof bytes, 1, file);
    std::fwrite(&state, sizeof state, 1, file);
}

void FixTdhs::restart(char* buffer)
{
    StepState state;
    std::memcpy(&state, buffer, sizeof state);
    limits_ = state.limits;
    reach_ = state.reach;
    parts_ = static_cast<int>(state.parts);
    pulled_ = state.pulled;
    counted_ = state.counted;
    if (comm->me != 0) counted_[impulses_left_out] = 0;  // the sum of all ranks
}

int FixTdhs::setmask()
{
    using namespace LAMMPS_NS::FixConst;
    return INITIAL_INTEGRATE | FINAL_INTEGRATE | PRE_EXCHANGE | PRE_NEIGHBOR;
}

void* FixTdhs::extract(const char* name, int& dimension)
{
    static int yes = 1;
    dimension = 0;
    if (std::strcmp(name, extract_counters) == 0) return &counter_values_;
    return std::strcmp(name, extract_moves_before_forces) == 0 ? &yes : nullptr;
}

void FixTdhs::ask_gravity()
{
    auto* fix = dynamic_cast<LAMMPS_NS::FixGravity*>(modify->find_fix_style("gravity", 0));
    if (!fix) return;
    Vector gravity;
    fix->get_gravity(gravity.data());
    gravity_ = gravity.norm();
    Eigen::Index axis;
    gravity.cwiseAbs().maxCoeff(&axis);
    up_axis_ = static_cast<int>(axis);
    up_is_forward_ = gravity[axis] <= 0;
}

void FixTdhs::init()
{
    refuse_company();
    read_materials();

    ghosts_.begin();
    measure_spheres();
    check_law();
    sizes_change_ = contacts::sizes_change(*lmp);
    script::sort_by_default(*lmp, 4 * ghosts_.largest_radius());
}

void FixTdhs::setup(int)
{
    ask_gravity();  // not in init(): the fix may come later in the script, and knows only after its own
    choose_effort();
    collect_walls();
    if (!started_) {  // what meets in the very first step
        started_ = true;
        std::fill(push_.begin(), push_.end(), 0.0);
        choose_parts();
        resolve_contacts();
    }
    cost_.switch_to(Part::outside);
}

void FixTdhs::initial_integrate(int)
{
    const TinyIsZero in_this_step;
    move();
    for (int part = 1; part < parts_; ++part) {
        cost_.switch_to(Part::communication);
        comm->forward_comm();
        std::fill(push_.begin(), push_.end(), 0.0);
        walls_.travel(limits_.step);
        resolve_contacts();
        move();
    }
    cost_.switch_to(Part::outside);
}

void FixTdhs::final_integrate()
{
    const TinyIsZero in_this_step;
    add_forces();
    follow_walls();
    choose_parts();
    resolve_contacts(range_ > 0);
    cost_.switch_to(Part::outside);
}

void FixTdhs::move()
{
    cost_.switch_to(Part::integration);
    if (atom->nlocal == 0) return;
    const double dt = update->dt / parts_;
    double* x = atom->x[0];
    const double* v = atom->v[0];
    double* shift = shift_.data();
    for (int i = 0; i < atom->nlocal; ++i)
        if (atom->mask[i] & groupbit)
            for (int k = 3 * i; k < 3 * i + 3; ++k) {
                x[k] += dt * v[k] + shift[k];
                shift[k] = 0;
            }
}

void FixTdhs::resolve_contacts(bool attracting)
{
    if (has_ghosts()) {
        cost_.switch_to(Part::communication);
        if (sizes_change_) {
            message_ = Message::sizes;
            comm->forward_comm_fix(this);
        }
        message_ = Message::start;
        comm->forward_comm_fix(this);
    }
    cost_.switch_to(Part::search);
    if (attracting)
        attract();
    else {
        gather(reach_);
        pairs_.find(bodies_, grid_, limits_.step, limits_.margin, limits_.touching);
    }
    cost_.switch_to(Part::walls);
    find_wall_contacts(bodies_, walls_.all(), law_->materials, limits_, wall_contacts_);

    cost_.switch_to(Part::contacts);
    counts_ = &solver_.count_touches(pairs_, wall_contacts_);
    if (has_ghosts()) tell_counts();
    solver_.classify(bodies_);
    if (has_ghosts()) split_masses();
    solver_.start(bodies_, pairs_, wall_contacts_, *law_, limits_, memory_, effort_.passes);
    share_changes();
    for (int k = 0; k < effort_.passes; ++k) {
        solver_.pass(bodies_.body, up_is_forward_);
        share_changes();
    }
    if (has_ghosts()) join_masses();
    solver_.finish(bodies_, grid_.order(), memory_);
    tell_walls();
    counted_[deepest_overlap] = std::max(counted_[deepest_overlap],
                                         solver_.separate(bodies_, share_, limits_.tolerated) / (2 * smallest_radius_));
    cost_.switch_to(Part::integration);
    scatter();
}

void FixTdhs::add_forces()
{
    cost_.switch_to(Part::integration);
    if (atom->nlocal == 0) return;
    const double dt = update->dt;
    double *v = atom->v[0], *omega = atom->omega[0];
    const double *f = atom->f[0], *torque = atom->torque[0];
    for (int i = 0; i < atom->nlocal; ++i) {
        const bool moves = atom->mask[i] & groupbit;
        const double per_mass = moves ? dt / atom->rmass[i] : 0;
        const double per_inertia = per_mass * 2.5 / (atom->radius[i] * atom->radius[i]);
        for (int k = 3 * i; k < 3 * i + 3; ++k) {
            push_[at(k)] = per_mass * f[k];
            v[k] += push_[at(k)];
            omega[k] += per_inertia * torque[k];
        }
    }
}

bool FixTdhs::has_ghosts() const { return comm->nprocs > 1 || atom->nghost > 0; }

double FixTdhs::shared_max(double value) const
{
    double result = value;
    MPI_Allreduce(&value, &result, 1, MPI_DOUBLE, MPI_MAX, world);
    return result;
}

const std::vector<FixTdhs::ShownValue>& FixTdhs::shown_values()
{
    static const std::vector<ShownValue> values{
        {"pairs", [](const FixTdhs& fix) { return static_cast<double>(fix.pairs_.end() - fix.pairs_.begin()); }},
        {"binary_collisions", [](const FixTdhs& fix) { return static_cast<double>(fix.solver_.binary_collisions()); }},
        {"cluster_contacts", [](const FixTdhs& fix) { return static_cast<double>(fix.solver_.cluster_contacts()); }},
        {"shortened_steps", [](const FixTdhs& fix) { return fix.counted_[steps_in_parts]; }},
        {"search", [](const FixTdhs& fix) { return fix.cost_.seconds(Part::search); }},
        {"walls", [](const FixTdhs& fix) { return fix.cost_.seconds(Part::walls); }},
        {"contacts", [](const FixTdhs& fix) { return fix.cost_.seconds(Part::contacts); }},
        {"integration", [](const FixTdhs& fix) { return fix.cost_.seconds(Part::integration); }},
        {"communication", [](const FixTdhs& fix) { return fix.cost_.seconds(Part::communication); }},
    };
    return values;
}

double FixTdhs::compute_vector(int k) { return shown_values()[at(k)].of(*this); }

}  // namespace interphase::hard_sphere
