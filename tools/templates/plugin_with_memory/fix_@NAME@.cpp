// SPDX-License-Identifier: GPL-3.0-or-later
#include <interphase/contacts/fix_contacts_with_memory.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace interphase;
using namespace interphase::contacts;

/// What a contact remembers while it lasts: numbers and arrays of numbers. A contact that begins has Spring{}.
struct Spring {
    double stretch[3] = {0, 0, 0};  ///< along the surfaces [m]
};

/// What the fix counts, for the summary of a run and /counters of its results.h5.
constexpr Counter counters[] = {
    {"deepest_overlap", "deepest overlap", "R", OverRanks::largest, 0.1,
     "The deepest overlap so far, of the reduced radius R = r_1 r_2/(r_1 + r_2) of its contact, at a wall of the sphere's.",
     "Springs may be soft as long as overlaps are some hundredths of a radius.", "a larger kn, and with it a shorter step"}};

/// The fix style `@NAME@/spheres`: spheres that push each other and walls apart while they overlap, by a spring and a dashpot along the
/// line of their centres, and hold each other by another spring along their surfaces (Cundall and Strack, Geotechnique 29
/// (1979) 47), which slips where Coulomb's friction is too weak for it:
///
///     fix ID group @NAME@/spheres
///     fix ID all wall/@NAME@ primitive ... | mesh ...       walls, in the words of wall/gran
///
/// The script gives kn [N/m], coefficientRestitution (above 0, to 1) and coefficientFriction, as
/// `fix ID all property/global NAME peratomtypepair ...`.
class Fix@CLASS@ : public FixContactsWithMemory<Spring> {
public:
    Fix@CLASS@(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg) : FixContactsWithMemory(lmp, narg, arg, "wall/@NAME@")
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
        each_contact([this](const Contact& contact, Spring& spring) {
            count(contact);
            return push(contact, spring);
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

    /// The law, from one contact and what it remembers to the force on its sphere. It is called once a step, and changes nothing that
    /// it remembers where contact.step is 0.
    Push push(const Contact& contact, Spring& spring) const
    {
        const double k = stiffness_(contact), log_e = std::log(restitution_(contact));

        // m x'' + c x' + k x = 0 ends at e times the speed of approach when c = -2 ln(e) sqrt(m k/(pi^2 + ln(e)^2))
        const double damping = -2 * log_e / std::sqrt(M_PI * M_PI + log_e * log_e) * std::sqrt(k * contact.mass);
        const double parting = contact.velocity.dot(contact.normal);
        const double apart = k * contact.overlap - damping * parting;

        // The stretch follows the slip, and the surfaces as they turn.
        const Vector slip = contact.velocity - parting * contact.normal;
        Vector stretch = to_vector(spring.stretch) + contact.step * slip;
        stretch -= stretch.dot(contact.normal) * contact.normal;
        Vector hold = -rolls * (k * stretch + damping * slip);
        const double most = friction_(contact) * std::max(apart, 0.0);
        if (hold.norm() > most) {
            hold *= most / hold.norm();
            stretch = -(hold / rolls + damping * slip) / k;
        }
        if (contact.step > 0) set(spring.stretch, stretch);

        return {apart * contact.normal + hold};
    }

    /// Surfaces of spheres that may turn give way as 2/7 of the mass does: slip swings as fast as an impact does.
    static constexpr double rolls = 2.0 / 7.0;

    BetweenTypes stiffness_, restitution_, friction_;

    double deepest_ = 0;
    CounterValues counted_{std::size(counters), &deepest_};
};

// This line makes the library a plug-in. More fix styles: more {"name", creator} pairs. The next ones say what method of the coupling it
// brings, and what its fixes count.
INTERPHASE_PLUGIN("@NAME@", {"@NAME@/spheres", &create<Fix@CLASS@>}, {"wall/@NAME@", &create<FixContactsWall>})
INTERPHASE_METHODS(method("@METHOD@", "springs and dashpots of @NAME@").resolving_contacts())
INTERPHASE_COUNTERS(counters)
