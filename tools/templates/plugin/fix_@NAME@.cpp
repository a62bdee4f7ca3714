// SPDX-License-Identifier: GPL-3.0-or-later
#include <interphase/contacts/fix_contacts.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace interphase;
using namespace interphase::contacts;

/// What the fix counts, for the summary of a run and /counters of its results.h5.
constexpr Counter counters[] = {
    {"deepest_overlap", "deepest overlap", "R", OverRanks::largest, 0.1,
     "The deepest overlap so far, of the reduced radius R = r_1 r_2/(r_1 + r_2) of its contact, at a wall of the sphere's.",
     "Springs may be soft as long as overlaps are some hundredths of a radius.", "a larger kn, and with it a shorter step"}};

/// The fix style `@NAME@/spheres`: spheres that push each other and walls apart while they overlap, by a spring and a dashpot along the
/// line of their centres, and rub, by a dashpot along their surfaces that Coulomb's friction limits:
///
///     fix ID group @NAME@/spheres
///     fix ID all wall/@NAME@ primitive ... | mesh ...       walls, in the words of wall/gran
///
/// The script gives kn [N/m], coefficientRestitution (above 0, to 1) and coefficientFriction, as
/// `fix ID all property/global NAME peratomtypepair ...`.
class Fix@CLASS@ : public FixContacts {
public:
    Fix@CLASS@(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg) : FixContacts(lmp, narg, arg, "wall/@NAME@")
    {
        // arg: ID, group, style, and then what is ours
        if (narg > 3) complain("'" + std::string(arg[3]) + "' is not known here; the materials say all: kn, "
                               "coefficientRestitution, coefficientFriction (fix property/global)");
    }

    void init() override
    {
        FixContacts::init();
        stiffness_ = between_types("kn", [](double k) { return k > 0; }, "give numbers above 0 N/m");
        restitution_ = between_types("coefficientRestitution", [](double e) { return e > 0 && e <= 1; },
                                     "give numbers above 0, up to 1");
        friction_ = between_types("coefficientFriction", [](double mu) { return mu >= 0; }, "give numbers from 0 on");
    }

    void post_force(int) override
    {
        each_contact([this](const Contact& contact) {
            count(contact);
            return push(contact);
        });
    }

    /// Tells the coupler what the fix counts: in the order of `counters`, of this rank.
    void* extract(const char* name, int& dimension) override
    {
        if (std::strcmp(name, extract_counters) == 0) return &counted_;
        return FixContacts::extract(name, dimension);
    }

private:
    void count(const Contact& contact) { deepest_ = std::max(deepest_, contact.overlap / contact.radius); }

    /// The law, from one contact to the force on its sphere.
    Push push(const Contact& contact) const
    {
        const double k = stiffness_(contact), log_e = std::log(restitution_(contact)), unit = std::sqrt(k * contact.mass);

        // m x'' + c x' + k x = 0 ends at e times the speed of approach when c = -2 ln(e) sqrt(m k/(pi^2 + ln(e)^2))
        const double damping = -2 * log_e / std::sqrt(M_PI * M_PI + log_e * log_e) * unit;
        const double parting = contact.velocity.dot(contact.normal);
        const double apart = k * contact.overlap - damping * parting;

        // stops slip within a collision, where friction suffices
        const Vector slip = contact.velocity - parting * contact.normal;
        Vector rub = -slip_damping * unit * slip;
        const double most = friction_(contact) * std::max(apart, 0.0);
        if (rub.norm() > most) rub *= most / rub.norm();

        return {apart * contact.normal + rub};
    }

    static constexpr double slip_damping = 0.5;  // of sqrt(k m)

    BetweenTypes stiffness_, restitution_, friction_;

    double deepest_ = 0;
    CounterValues counted_{std::size(counters), &deepest_};
};

// This line makes the library a plug-in. More fix styles: more {"name", creator} pairs. The next ones say what method of the coupling it
// brings, and what its fixes count.
INTERPHASE_PLUGIN("@NAME@", {"@NAME@/spheres", &create<Fix@CLASS@>}, {"wall/@NAME@", &create<FixContactsWall>})
INTERPHASE_METHODS(method("@METHOD@", "springs and dashpots of @NAME@").resolving_contacts())
INTERPHASE_COUNTERS(counters)
