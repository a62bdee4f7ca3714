// SPDX-License-Identifier: GPL-3.0-or-later
// What fix tdhs takes from the script, and what it does not bear beside it.
#include <cfenv>
#include <cmath>
#include <cstdlib>
#include <string>

#include "atom.h"
#include "error.h"
#include "force.h"
#include "hard_sphere/fix_tdhs.hpp"
#include "modify.h"
#include "script/script.hpp"
#include "update.h"

namespace interphase::hard_sphere {

void FixTdhs::complain(const std::string& what) const
{
    error->all(FLERR, ("Fix " + std::string(style) + ": " + what).c_str());
}

void FixTdhs::read_arguments(int narg, char** arg)
{
    for (int k = 3; k < narg; k += 2) {
        const std::string key = arg[k];
        if (k + 1 >= narg) complain("'" + key + "' needs a value");
        if (key == "too_fast") {
            const std::string choice = arg[k + 1];
            if (choice != "stop" && choice != "shorten") complain("too_fast " + choice + ": give stop or shorten");
            shortens_ = choice == "shorten";
            continue;
        }
        char* end = nullptr;
        const double value = std::strtod(arg[k + 1], &end);
        if (*end || end == arg[k + 1]) complain("'" + key + " " + arg[k + 1] + "': no number");
        const auto check = [&](bool holds, const char* demand) {
            if (!holds) complain(key + " " + arg[k + 1] + ": " + demand);
        };
        if (key == "passes") {
            check(value >= 2 && value <= 1000 && value == std::floor(value),
                  "give a whole number of at least 2, at most 1000");
            passes_given_ = static_cast<int>(value);
        } else if (key == "margin") {
            check(value >= 0 && value <= 1, "give a share of a diameter, 0 to 1");
            margin_given_ = value;
        } else if (key == "separation") {
            check(value >= 0 && value <= 1, "give the share of an overlap taken away in a step by position, 0 to 1");
            share_ = value;
        } else if (key == "relief") {
            check(value >= 0 && value <= 1, "give the share of an overlap taken away in a step by velocity, 0 to 1");
            relief_ = value;
        } else if (key == "tolerated_overlap") {
            check(value >= 0 && value < 1, "give a share of a diameter, 0 to 1");
            tolerated_ = value;
        } else if (key == "resting_speed") {
            check(value >= 0 && value < 1e300, "give a speed in m/s, not below 0");
            resting_speed_ = value;
        } else {
            complain("unknown word '" + key +
                     "'; known: passes, margin, separation, relief, tolerated_overlap, "
                     "resting_speed, too_fast");
        }
    }
}

/// Before anything moves, with the spheres there are or will be. Every rank asks the same.
void FixTdhs::check_law()
{
    const bool any = smallest_radius_ < 1e300;
    std::fenv_t traps;  // a division by 0 is to be told in words
    std::feholdexcept(&traps);
    const std::string wrong = law_->complaint({any ? smallest_radius_ : 1e-3, any ? ghosts_.largest_radius() : 1e-3});
    range_ = law_->longest_range();
    std::fesetenv(&traps);
    if (!wrong.empty()) complain(wrong);
}

void FixTdhs::choose_effort()
{
    effort_ = usual_effort(gravity_, update->dt, 2 * smallest_radius_);
    if (passes_given_ > 0) effort_.passes = passes_given_;
    if (margin_given_ >= 0) effort_.margin = margin_given_;
    say("Fix %s: %d passes over the contacts of a step, margin %g of the smallest diameter\n", style, effort_.passes,
        effort_.margin);
}

void FixTdhs::refuse_company()
{
    script::refuse_other_integrators(*lmp, *this);
    for (int k = 0; k < modify->nfix; ++k) {
        const LAMMPS_NS::Fix& other = *modify->fix[k];
        if (std::string(other.style).rfind("wall/gran", 0) == 0)
            error->all(FLERR,
                       (std::string("Fix ") + other.id + " (" + other.style +
                        ") makes contact forces on walls, but fix " + style + " resolves contacts itself. Write wall/" +
                        style + " for it, with the words from `primitive` or `mesh` on")
                           .c_str());
    }
    if (force->pair)
        error->all(FLERR, ("Fix " + std::string(style) +
                           " resolves contacts itself, but a pair_style does, too. Remove the pair_style, or use fix "
                           "nve/sphere instead of it")
                              .c_str());
}

void FixTdhs::read_materials()
{
    Materials& materials = law_->start(atom->ntypes);
    const std::vector<MaterialProperty>& properties = law_->properties();
    for (std::size_t k = 0; k < properties.size(); ++k)
        script::read_between_types(
            *lmp, *this, properties[k].name, {properties[k].least, properties[k].most},
            [&](int a, int b, double value) { materials.number(materials.between(a, b), k) = value; });
}

}  // namespace interphase::hard_sphere
