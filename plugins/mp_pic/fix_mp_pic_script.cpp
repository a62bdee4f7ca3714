// SPDX-License-Identifier: GPL-3.0-or-later
// What fix mp_pic takes from the script, and what it does not bear beside it.
#include <mpi.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "atom.h"
#include "base/text.hpp"
#include "comm.h"
#include "error.h"
#include "force.h"
#include "modify.h"
#include "mp_pic/fix_mp_pic.hpp"
#include "mp_pic/stress_check.hpp"
#include "script/script.hpp"

namespace interphase::mp_pic {

namespace {

bool positive(double value) { return value > 0; }

/// "a number above 0, in Pa (1 to 100 are published)".
std::string demand(const StressNumber& number)
{
    const std::string to_most = number.most < unbounded ? " to " + text(number.most) : " or more";
    const std::string unit = number.unit, range = number.least == above_zero && number.most == unbounded
                                                      ? "a number above 0"
                                                      : text(number.least) + to_most;
    const std::string published =
        number.published_most < unbounded
            ? " (" + text(number.published_least) + " to " + text(number.published_most) + " are published)"
            : "";
    return "give " + range + (unit.empty() ? "" : ", in " + unit) + published;
}

/// "harris_crighton P_s xi": what stands behind `stress`.
std::string words_of(const AnyStress& stress)
{
    std::string words = stress.name;
    for (const StressNumber& number : stress.numbers)
        words += std::string(" ") + number.name;
    return words;
}

/// The words of a fix command, one after the other; every complaint ends the run.
class Words {
public:
    Words(LAMMPS_NS::Error& error, std::string style, std::vector<std::string> words)
        : error_(error), style_(std::move(style)), words_(std::move(words))
    {}

    bool left() const { return next_ < words_.size(); }
    std::string word(const std::string& of)
    {
        if (!left()) fail("'" + of + "' needs a value");
        return words_[next_++];
    }
    std::string choice(const std::string& of, const std::string& a, const std::string& b)
    {
        const std::string chosen = word(of);
        if (chosen != a && chosen != b) fail(of + " " + chosen + ": give " + a + " or " + b);
        return chosen;
    }
    template <class Holds>
    double number(const std::string& of, const Holds& holds, const std::string& demand)
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
        error_.all(FLERR, ("Fix " + style_ + ": " + what).c_str());
        std::abort();  // not reached; Error::all does not say that it never returns
    }

    /// What stands behind `stress`: a stress and its numbers, or null for `off`.
    const AnyStress* stress(const std::vector<AnyStress>& known, std::vector<double>& values)
    {
        const std::string name = word("stress");
        values.clear();
        if (name == "off") return nullptr;
        std::string all;
        for (const AnyStress& each : known) {
            all += words_of(each) + ", ";
            if (each.name != name) continue;
            for (const StressNumber& number : each.numbers)
                values.push_back(this->number(
                    "stress " + name + " " + number.name,
                    [&](double value) { return value >= number.least && value <= number.most; }, demand(number)));
            return &each;
        }
        fail("stress " + name + ": give " + all + "or off");
    }

private:
    LAMMPS_NS::Error& error_;
    std::string style_;
    std::vector<std::string> words_;
    std::size_t next_ = 0;
};

}  // namespace

void FixMpPic::complain(const std::string& what) const
{
    error->all(FLERR, ("Fix " + std::string(style) + ": " + what).c_str());
}

void FixMpPic::read_arguments(const std::vector<std::string>& given, const std::vector<AnyStress>& stresses,
                              const std::vector<std::string>& usual)
{
    Words words(*error, style, given), otherwise(*error, style, usual);
    const AnyStress* chosen = nullptr;
    std::vector<double> values;
    std::string table;
    bool says_stress = false;
    while (words.left()) {
        const std::string key = words.word(style);
        if (key == "stress") {
            chosen = words.stress(stresses, values);
            says_stress = true;
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
        } else if (key == "table") {
            table = words.word(key);
        } else {
            words.fail("unknown word '" + key +
                       "'; known: stress, close_packing, courant, relaxation, too_fast, overfilled, table");
        }
    }
    if (!says_stress) {
        if (!otherwise.left())
            words.fail("the script does not give the stress; add `stress " + words_of(stresses.front()) + "`");
        chosen = otherwise.stress(stresses, values);
    }
    if (!chosen) {
        if (!table.empty()) words.fail("table " + table + ": with `stress off` there is no stress to write");
        return;
    }
    warn_of_unpublished(*chosen, values);
    values.push_back(close_packing_);
    stress_ = chosen->of(values);
    check_stress(*chosen, table);
}

void FixMpPic::warn_of_unpublished(const AnyStress& stress, const std::vector<double>& values) const
{
    if (comm->me != 0) return;
    for (std::size_t k = 0; k < values.size(); ++k) {
        const StressNumber& number = stress.numbers[k];
        if (values[k] < number.published_least || values[k] > number.published_most)
            error->warning(FLERR, ("Fix " + std::string(style) + ": " + number.name + " of the stress " + stress.name +
                                   " is " + text(values[k]) + ", outside the published range of " +
                                   text(number.published_least) + " to " + text(number.published_most))
                                      .c_str());
    }
}

/// Before anything moves; every rank looks at the same. Writes the table where the script wants one.
void FixMpPic::check_stress(const AnyStress& stress, const std::string& table) const
{
    const std::vector<double> solid_fractions = looked_at(close_packing_);
    const std::string wrong = complaint_of(stress_, solid_fractions);
    if (!wrong.empty()) complain("the stress " + stress.name + " " + wrong);
    if (table.empty()) return;
    int failed = 0;
    if (comm->me == 0) {
        FILE* file = std::fopen(table.c_str(), "w");
        if (file) std::fprintf(file, "# solid fraction, stress %s [Pa]\n", stress.name.c_str());
        for (const double phi : solid_fractions)
            if (file) std::fprintf(file, "%.17g %.17g\n", phi, stress_(phi));
        failed = !file || std::fclose(file) != 0;
    }
    MPI_Bcast(&failed, 1, MPI_INT, 0, world);
    if (failed) complain("table " + table + ": this file cannot be written; give one in a folder that is there");
}

void FixMpPic::refuse_company() const
{
    script::refuse_other_integrators(*lmp, *this);
    const std::string own_walls = "wall/" + std::string(style);
    for (int k = 0; k < modify->nfix; ++k) {
        const LAMMPS_NS::Fix& other = *modify->fix[k];
        const std::string kind = other.style;
        if (kind.rfind("wall/", 0) == 0 && kind != own_walls && kind.rfind("wall/reg", 0) != 0)
            error->all(FLERR, ("Fix " + std::string(other.id) + " (" + kind +
                               ") makes contacts with walls, which fix " + style + " does itself. Write " + own_walls +
                               " for it, with the words from `primitive` or `mesh` on")
                                  .c_str());
    }
    if (force->pair)
        error->all(FLERR, ("Fix " + std::string(style) +
                           " has a stress in place of collisions, but a pair_style makes these, too. Remove the "
                           "pair_style, or use fix nve/sphere instead of it")
                              .c_str());
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
