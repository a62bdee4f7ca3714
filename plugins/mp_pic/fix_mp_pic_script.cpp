// SPDX-License-Identifier: GPL-3.0-or-later
// What fix mp_pic takes from the script, and what it does not bear beside it.
#include <cmath>
#include <cstdlib>
#include <string>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "force.h"
#include "modify.h"
#include "mp_pic/fix_mp_pic.hpp"
#include "script/script.hpp"

namespace interphase::mp_pic {

namespace {

/// The words of a fix command, one after the other; every complaint ends the run.
class Words {
public:
    Words(LAMMPS_NS::Error& error, int narg, char** arg) : error_(error), narg_(narg), arg_(arg) {}

    bool left() const { return next_ < narg_; }
    std::string word(const std::string& of)
    {
        if (!left()) fail("'" + of + "' needs a value");
        return arg_[next_++];
    }
    std::string choice(const std::string& of, const std::string& a, const std::string& b)
    {
        const std::string chosen = word(of);
        if (chosen != a && chosen != b) fail(of + " " + chosen + ": give " + a + " or " + b);
        return chosen;
    }
    template <class Holds>
    double number(const std::string& of, const Holds& holds, const char* demand)
    {
        const std::string given = word(of);
        char* end = nullptr;
        const double value = std::strtod(given.c_str(), &end);
        if (*end || end == given.c_str() || !std::isfinite(value)) fail("'" + of + " " + given + "': no number");
        if (!holds(value)) fail(of + " " + given + ": " + demand);
        return value;
    }
    [[noreturn]] void fail(const std::string& what) const
    {
        error_.all(FLERR, ("Fix mp_pic: " + what).c_str());
        std::abort();  // not reached; Error::all does not say that it never returns
    }

private:
    LAMMPS_NS::Error& error_;
    int narg_;
    char** arg_;
    int next_ = 3;
};

bool positive(double value) { return value > 0; }

HarrisCrighton harris_crighton(Words& words)
{
    HarrisCrighton law{};
    law.pressure = words.number("stress harris_crighton P_s", positive, "give P_s above 0, in Pa (1 to 100 are usual)");
    law.exponent =
        words.number("stress harris_crighton xi", positive, "give an exponent above 0 (2 to 5 are published)");
    return law;
}

Lun lun(Words& words)
{
    Lun law{};
    law.density = words.number("stress lun density", positive, "give the particles' density above 0, in kg/m3");
    law.temperature = words.number("stress lun temperature", positive, "give a granular temperature above 0, in m2/s2");
    law.restitution = words.number(
        "stress lun restitution", [](double e) { return e >= 0 && e <= 1; }, "give 0 to 1");
    return law;
}

}  // namespace

void FixMpPic::read_arguments(int narg, char** arg)
{
    Words words(*error, narg, arg);
    while (words.left()) {
        const std::string key = words.word("fix mp_pic");
        if (key == "stress") {
            const std::string law = words.word(key);
            has_stress_ = law != "off";
            if (law == "harris_crighton")
                law_ = harris_crighton(words);
            else if (law == "lun")
                law_ = lun(words);
            else if (has_stress_)
                words.fail("stress " + law +
                           ": give harris_crighton P_s xi, lun density temperature restitution, or off");
        } else if (key == "close_packing") {
            close_packing_ = words.number(
                key, [](double phi) { return phi > 0 && phi < 1; },
                "give a solid fraction between 0 and 1 (0.6 is usual)");
        } else if (key == "courant") {
            courant_ = words.number(key, positive, "give the part of a gas cell that a step may cross, above 0");
        } else if (key == "relaxation") {
            relaxation_share_ =
                words.number(key, positive, "give the part of the relaxation time that a step may last, above 0");
        } else if (key == "too_fast") {
            refuses_long_steps_ = words.choice(key, "stop", "count") == "stop";
        } else if (key == "overfilled") {
            refuses_overfilled_ = words.choice(key, "stop", "count") == "stop";
        } else {
            words.fail("unknown word '" + key +
                       "'; known: stress, close_packing, courant, relaxation, too_fast, overfilled");
        }
    }
    std::visit([&](auto& law) { law.close_packing = close_packing_; }, law_);
    const auto* law = std::get_if<HarrisCrighton>(&law_);
    if (has_stress_ && law && (law->exponent < exponent_min || law->exponent > exponent_max) && comm->me == 0)
        error->warning(FLERR, ("Fix mp_pic: the exponent of the stress is " + std::to_string(law->exponent) +
                               ", outside the published range of 2 to 5")
                                  .c_str());
}

void FixMpPic::refuse_company() const
{
    script::refuse_other_integrators(*lmp, *this);
    for (int k = 0; k < modify->nfix; ++k) {
        const LAMMPS_NS::Fix& other = *modify->fix[k];
        const std::string style = other.style;
        if (style.rfind("wall/", 0) == 0 && style != "wall/mp_pic" && style.rfind("wall/reg", 0) != 0)
            error->all(FLERR, (std::string("Fix ") + other.id + " (" + other.style +
                               ") makes contacts with walls, which fix mp_pic does itself. Write wall/mp_pic for it, "
                               "with the words from `primitive` or `mesh` on")
                                  .c_str());
    }
    if (force->pair)
        error->all(FLERR,
                   "Fix mp_pic has a stress in place of collisions, but a pair_style makes these, too. Remove the "
                   "pair_style, or use fix nve/sphere instead of fix mp_pic");
}

void FixMpPic::read_restitution()
{
    const auto n = static_cast<std::size_t>(atom->ntypes);
    restitution_.assign(n, 0.0);
    wall_laws_.assign(n, std::vector<WallLaw>(n));
    const auto law = [&](int a, int b) -> WallLaw& {
        return wall_laws_[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
    };
    script::read_between_types(*lmp, *this, "coefficientRestitution", {0, 1}, [&](int a, int b, double e) {
        law(a, b).normal_restitution = e;
        if (a == b) restitution_[static_cast<std::size_t>(a)] = e;
    });
    script::read_between_types(*lmp, *this, "tangentialRestitution", {0, 1},
                               [&](int a, int b, double e) { law(a, b).tangential_restitution = e; });
}

}  // namespace interphase::mp_pic
