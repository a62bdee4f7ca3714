// SPDX-License-Identifier: GPL-3.0-or-later
// Laws that answer what is none, each in one way.
#include <cmath>

#include "hard_sphere/fix_tdhs_of.hpp"

using interphase::hard_sphere::MaterialProperty;
using interphase::hard_sphere::Meeting;
using interphase::hard_sphere::Separation;

namespace {

/// All of it right, from one number.
struct Right {
    template <class D>
    struct Materials {
        D restitution;
    };
    static constexpr MaterialProperty properties[] = {{"coefficientRestitution", 0, 1}};

    template <class D>
    static D restitution(const Materials<D>& materials, const Meeting<D>&)
    {
        return materials.restitution;
    }
};

struct GainsEnergy : Right {
    template <class D>
    static D restitution(const Materials<D>& materials, const Meeting<D>& meeting)
    {
        return materials.restitution + 0.1 * meeting.speed;
    }
};

struct NoAnswerAtRest : Right {
    template <class D>
    static D restitution(const Materials<D>& materials, const Meeting<D>& meeting)
    {
        return materials.restitution * meeting.speed / meeting.speed;
    }
};

struct PushesFriction : Right {
    template <class D>
    static D friction(const Materials<D>& materials, const Meeting<D>&)
    {
        return -1 * materials.restitution;
    }
};

struct WithoutRange : Right {
    static double attraction(const Materials<double>&, const Separation&) { return 1e-3; }
    static double range(const Materials<double>&) { return 0; }
};

struct TooFar : WithoutRange {
    static double range(const Materials<double>&) { return 1; }
};

struct NoForceAtContact : WithoutRange {
    static double attraction(const Materials<double>&, const Separation& separation) { return 1e-9 / separation.gap; }
    static double range(const Materials<double>&) { return 1e-4; }
};

}  // namespace

INTERPHASE_LAWS("bad_laws", INTERPHASE_LAW_STYLES("right", Right), INTERPHASE_LAW_STYLES("gains_energy", GainsEnergy),
                INTERPHASE_LAW_STYLES("no_answer_at_rest", NoAnswerAtRest),
                INTERPHASE_LAW_STYLES("pushes_friction", PushesFriction),
                INTERPHASE_LAW_STYLES("without_range", WithoutRange), INTERPHASE_LAW_STYLES("too_far", TooFar),
                INTERPHASE_LAW_STYLES("no_force_at_contact", NoForceAtContact))
