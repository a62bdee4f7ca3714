// SPDX-License-Identifier: GPL-3.0-or-later
#include "hard_sphere/fix_tdhs.hpp"

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix_gravity.h"
#include "fix_property_global.h"
#include "force.h"
#include "hard_sphere/fix_wall_tdhs.hpp"
#include "hard_sphere/processor.hpp"
#include "hard_sphere/wall_contacts.hpp"
#include "modify.h"
#include "neighbor.h"
#include "update.h"

namespace interphase::hard_sphere {

namespace {

constexpr int grow_callback = 0;
constexpr double usual_reach = 0.3;  // of a diameter: hardly any pair closes a wider gap in a step

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

FixTdhs::FixTdhs(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg) : Fix(lmp, narg, arg)
{
    if (!atom->sphere_flag) error->all(FLERR, "Fix tdhs: the particles are no spheres; use atom_style granular");
    time_integrate = 1;
    create_attribute = 1;
    comm_forward = 9;
    comm_reverse = 6;
    vector_flag = 1;
    size_vector = 9;
    global_freq = 1;
    extvector = 0;
    read_arguments(narg, arg);
    grow_arrays(atom->nmax);
    atom->add_callback(grow_callback);
}

FixTdhs::~FixTdhs() { atom->delete_callback(id, grow_callback); }

int FixTdhs::setmask() { return LAMMPS_NS::FixConst::INITIAL_INTEGRATE | LAMMPS_NS::FixConst::FINAL_INTEGRATE; }

void FixTdhs::read_arguments(int narg, char** arg)
{
    const auto fail = [&](const std::string& what) { error->all(FLERR, ("Fix tdhs: " + what).c_str()); };
    for (int k = 3; k < narg; k += 2) {
        const std::string key = arg[k];
        if (k + 1 >= narg) fail("'" + key + "' needs a value");
        char* end = nullptr;
        const double value = std::strtod(arg[k + 1], &end);
        if (*end || end == arg[k + 1]) fail("'" + key + " " + arg[k + 1] + "': no number");
        const auto check = [&](bool holds, const char* demand) {
            if (!holds) fail(key + " " + arg[k + 1] + ": " + demand);
        };
        if (key == "passes") {
            check(value >= 2 && value == std::floor(value), "give a whole number of at least 2");
            passes_ = static_cast<int>(value);
        } else if (key == "margin") {
            check(value >= 0 && value <= 1, "give a share of a diameter, 0 to 1");
            margin_ = value;
        } else if (key == "separation") {
            check(value >= 0 && value <= 1, "give the share of an overlap taken away in a step, 0 to 1");
            share_ = value;
        } else if (key == "tolerated_overlap") {
            check(value >= 0 && value < 1, "give a share of a diameter, 0 to 1");
            tolerated_ = value;
        } else if (key == "resting_speed") {
            check(value >= 0, "give a speed in m/s, not below 0");
            resting_speed_ = value;
        } else {
            fail("unknown word '" + key + "'; known: passes, margin, separation, tolerated_overlap, resting_speed");
        }
    }
}

void FixTdhs::refuse_company()
{
    for (int k = 0; k < modify->nfix; ++k) {
        const LAMMPS_NS::Fix& other = *modify->fix[k];
        if (&other == this) continue;
        if (other.time_integrate)
            error->all(FLERR, (std::string("Fix tdhs moves the particles itself, but fix ") + other.id + " (" +
                               other.style + ") does, too. Remove one of them")
                                  .c_str());
        if (std::string(other.style).rfind("wall/gran", 0) == 0)
            error->all(FLERR, (std::string("Fix ") + other.id + " (" + other.style +
                               ") makes contact forces on walls, but fix tdhs resolves contacts itself. Write wall/tdhs "
                               "for it, with the words from `primitive` or `mesh` on")
                                  .c_str());
    }
    if (force->pair)
        error->all(FLERR,
                   "Fix tdhs resolves contacts itself, but a pair_style does, too. Remove the pair_style, or use fix "
                   "nve/sphere instead of fix tdhs");
}

Materials FixTdhs::read_materials()
{
    const int types = atom->ntypes;
    Materials materials(types);
    const auto read = [&](const char* name, double ContactLaw::*member, double most) {
        Fix* fix = modify->find_fix_property(name, "property/global", "peratomtypepair", types, types, style);
        const double* const* values = static_cast<LAMMPS_NS::FixPropertyGlobal*>(fix)->get_array();
        for (int a = 0; a < types; ++a)
            for (int b = 0; b < types; ++b) {
                if (!(values[a][b] >= 0 && values[a][b] <= most))
                    error->all(FLERR, ("Fix tdhs: fix property/global " + std::string(name) + " is " +
                                       std::to_string(values[a][b]) + " between types " + std::to_string(a + 1) +
                                       " and " + std::to_string(b + 1) + "; give " +
                                       (most < 2 ? "0 to 1" : "0 or more"))
                                          .c_str());
                materials.between(a, b).*member = values[a][b];
            }
    };
    read("coefficientRestitution", &ContactLaw::restitution, 1);
    read("tangentialRestitution", &ContactLaw::tangential_restitution, 1);
    read("coefficientFriction", &ContactLaw::friction, 1e300);
    return materials;
}

double FixTdhs::gravity_speed() const
{
    auto* fix = dynamic_cast<LAMMPS_NS::FixGravity*>(modify->find_fix_style("gravity", 0));
    if (!fix) return 0;
    double g[3];
    fix->get_gravity(g);
    return std::sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]) * update->dt;
}

void FixTdhs::init()
{
    refuse_company();
    materials_ = read_materials();

    double smallest = 1e300, largest = 0;
    for (int i = 0; i < atom->nlocal; ++i) {
        smallest = std::min(smallest, atom->radius[i]);
        largest = std::max(largest, atom->radius[i]);
    }
    for (int k = 0; k < modify->nfix; ++k)
        for (int type = 1; type <= atom->ntypes; ++type) {
            largest = std::max(largest, modify->fix[k]->max_rad(type));
            const double least = modify->fix[k]->min_rad(type);
            if (least > 0) smallest = std::min(smallest, least);
        }
    smallest_radius_ = -shared_max(-smallest);
    largest_radius_ = shared_max(largest);
    // ghosts as far away as a pair may be that meets within one step
    comm->cutghostuser = std::max(comm->cutghostuser, 4 * largest_radius_ + neighbor->skin);
}

void FixTdhs::setup(int)
{
    collect_walls();
    for (const auto& wall : walls_)
        if (wall->type() < 0 || wall->type() >= atom->ntypes)
            error->all(FLERR, "Fix tdhs: a wall has a type that the simulation box does not know");
    cost_.switch_to(Part::outside);
}

void FixTdhs::collect_walls()
{
    walls_.clear();
    for (int k = 0; k < modify->nfix; ++k)
        if (const auto* fix = dynamic_cast<FixWallTdhs*>(modify->fix[k])) fix->add_walls(walls_);
}

void FixTdhs::initial_integrate(int)
{
    cost_.switch_to(Part::integration);
    if (atom->nlocal == 0) return;
    const double dt = update->dt;
    double* x = atom->x[0];
    const double* v = atom->v[0];
    double* shift = shift_.data();
    for (int i = 0; i < atom->nlocal; ++i)
        if (atom->mask[i] & groupbit)
            for (int k = 3 * i; k < 3 * i + 3; ++k) {
                x[k] += dt * v[k] + shift[k];
                shift[k] = 0;
            }
    cost_.switch_to(Part::outside);
}

void FixTdhs::final_integrate()
{
    const TinyIsZero in_this_step;
    cost_.switch_to(Part::integration);
    add_forces();
    if (comm->nprocs > 1 || atom->nghost > 0) {
        cost_.switch_to(Part::communication);
        message_ = Message::start;
        comm->forward_comm_fix(this);
    }
    cost_.switch_to(Part::search);
    choose_limits();
    gather();
    const std::size_t spheres = bodies_.size();
    bodies_.body.resize(spheres + 1);
    bodies_.body.back() = Body{};  // of resting walls
    pairs_.find(bodies_, grid_, limits_.step, limits_.margin);
    cost_.switch_to(Part::walls);
    find_wall_contacts(bodies_, spheres, walls_, materials_, limits_, wall_contacts_);

    cost_.switch_to(Part::contacts);
    solver_.start(bodies_, pairs_, wall_contacts_, materials_, limits_, memory_, passes_);
    share_changes();
    for (int k = 0; k < passes_; ++k) {
        solver_.pass(bodies_.body);
        share_changes();
    }
    solver_.separate(bodies_, share_, tolerated_ * 2 * smallest_radius_);
    solver_.remember(bodies_, memory_);
    cost_.switch_to(Part::integration);
    scatter();
    cost_.switch_to(Part::outside);
}

void FixTdhs::add_forces()
{
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

void FixTdhs::gather()
{
    const int count = atom->nlocal + atom->nghost;
    places_.resize(at(count));
    for (int i = 0; i < count; ++i) {
        std::copy_n(atom->x[i], 3, places_[at(i)].centre);
        places_[at(i)].radius = atom->radius[i];
    }
    grid_.sort(places_, reach_);
    const std::vector<int>& order = grid_.order();
    bodies_.resize(at(count));
    body_of_.resize(at(count));
    for (std::size_t b = 0; b < order.size(); ++b) {
        const int i = order[b];
        body_of_[at(i)] = static_cast<int>(b);
        bodies_.place[b] = places_[at(i)];
        bodies_.label[b] = {i, atom->tag[i], atom->type[i] - 1, i >= atom->nlocal};
        bodies_.push[b] = Vector(push_[at(3 * i)], push_[at(3 * i + 1)], push_[at(3 * i + 2)]);
        Body& body = bodies_.body[b];
        std::copy_n(atom->v[i], 3, body.velocity);
        std::copy_n(atom->omega[i], 3, body.spin);
        const bool moves = atom->mask[i] & groupbit;
        const double r = atom->radius[i];
        body.inverse_mass = moves ? 1 / atom->rmass[i] : 0;
        body.inverse_inertia = 2.5 * body.inverse_mass / (r * r);
    }
    shared_.resize(at(count));
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        if (bodies_.label[b].ghost) shared_[b] = bodies_.body[b];
}

void FixTdhs::choose_limits()
{
    double fastest2 = 0;
    const double* v = atom->nlocal > 0 ? atom->v[0] : nullptr;
    for (int i = 0; i < 3 * atom->nlocal; i += 3)
        fastest2 = std::max(fastest2, v[i] * v[i] + v[i + 1] * v[i + 1] + v[i + 2] * v[i + 2]);
    const double closing = 2 * std::sqrt(shared_max(fastest2)) * update->dt;
    const double diameter = 2 * smallest_radius_;
    limits_.step = update->dt;
    limits_.margin = margin_ * diameter;
    limits_.resting_speed = resting_speed_ >= 0 ? resting_speed_ : 2 * gravity_speed();
    // Farther than that no two spheres can meet; and what is not looked at must not pass through each other.
    reach_ = std::max({limits_.margin, std::min(closing, usual_reach * diameter), closing - diameter});
}

void FixTdhs::share_changes()
{
    if (comm->nprocs == 1 && atom->nghost == 0) return;
    cost_.switch_to(Part::communication);
    message_ = Message::passes;
    comm->reverse_comm_fix(this);
    comm->forward_comm_fix(this);
    cost_.switch_to(Part::contacts);
}

void FixTdhs::scatter()
{
    if (comm->nprocs > 1 || atom->nghost > 0) {
        message_ = Message::shift;
        comm->reverse_comm_fix(this);
    }
    for (int i = 0; i < atom->nlocal; ++i) {
        const auto b = at(body_of_[at(i)]);
        std::copy_n(bodies_.body[b].velocity, 3, atom->v[i]);
        std::copy_n(bodies_.body[b].spin, 3, atom->omega[i]);
        std::copy_n(solver_.shift()[b].data(), 3, &shift_[at(3 * i)]);
    }
}

double FixTdhs::shared_max(double value) const
{
    double result = value;
    MPI_Allreduce(&value, &result, 1, MPI_DOUBLE, MPI_MAX, world);
    return result;
}

double FixTdhs::compute_vector(int k)
{
    switch (k) {
        case 0: return static_cast<double>(pairs_.end() - pairs_.begin());
        case 1: return static_cast<double>(solver_.binary_collisions());
        case 2: return static_cast<double>(solver_.cluster_contacts());
        default: return cost_.seconds(static_cast<Part>(k - 2));
    }
}

}  // namespace interphase::hard_sphere
