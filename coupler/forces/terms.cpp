// SPDX-License-Identifier: GPL-3.0-or-later
#include "forces/terms.hpp"

#include <stdexcept>

#include "base/text.hpp"
#include "forces/saffman_mei_lift/saffman_mei_lift.hpp"
#include "forces/virtual_mass/virtual_mass.hpp"
#include "forces/viscous_stress/viscous_stress.hpp"

namespace interphase {

namespace {

template <class AnyTerm>
std::unique_ptr<Term> make()
{
    return std::make_unique<AnyTerm>();
}

}  // namespace

const std::vector<OptionalTerm>& optional_terms()
{
    static const std::vector<OptionalTerm> terms{
        {"viscousStress", make<ViscousStress>, "the gas's viscous stress on the volume of the particles"},
        {"saffmanMeiLift", make<SaffmanMeiLift>, "lift on a sphere in shear, Saffman with Mei's correction"},
        {"virtualMass", make<VirtualMass>, "inertia of the gas that a sphere has to push aside"},
    };
    return terms;
}

std::vector<std::string> names_of_optional_terms()
{
    std::vector<std::string> names;
    for (const OptionalTerm& term : optional_terms())
        names.emplace_back(term.name);
    return names;
}

Terms make_terms(const std::vector<std::string>& names)
{
    for (const std::string& name : names)
        if (!is_among(name, names_of_optional_terms())) throw std::out_of_range("no interphase term is called " + name);
    Terms terms;
    for (const OptionalTerm& term : optional_terms())
        if (is_among(std::string(term.name), names)) terms.push_back(term.make());
    return terms;
}

}  // namespace interphase
