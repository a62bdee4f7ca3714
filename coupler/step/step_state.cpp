// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/step_state.hpp"

#include <iomanip>
#include <istream>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace interphase {

namespace {

/// Hands every number of a state to `visit(name, number)`; the one place that names them.
template <class State, class Visit>
void visit_columns(State& state, const Visit& visit)
{
    const auto visit_vector = [&](const std::string& name, auto& vector) {
        for (int axis = 0; axis < 3; ++axis)
            visit(name + "_" + "xyz"[axis], vector[axis]);
    };
    visit("time", state.time);
    visit("duration", state.duration);
    visit("mass", state.mass);
    visit_vector("mean_velocity", state.mean_velocity);
    visit("kinetic_energy", state.kinetic_energy);
    visit_vector("mean_pressure_gradient", state.mean_pressure_gradient);
    visit("weight_gradient", state.weight_gradient);
    visit("highest_pressure_gradient", state.highest_pressure_gradient);
    visit_vector("where", state.where);
    visit("fastest", state.fastest);
    visit_vector("fastest_at", state.fastest_at);
    visit("fastest_id", state.fastest_id);
    visit("gas_speed", state.gas_speed);
    visit("largest_crossing", state.largest_crossing);
    visit("largest_wave_crossing", state.largest_wave_crossing);
}

void set(StepState& state, const std::string& column, double value)
{
    bool found = false;
    visit_columns(state, [&](const std::string& name, auto& number) {
        if (name != column) return;
        number = static_cast<std::decay_t<decltype(number)>>(value);
        found = true;
    });
    if (!found) throw std::runtime_error("a series of steps has no column '" + column + "'");
}

}  // namespace

void write_names(std::ostream& to)
{
    const StepState any;
    visit_columns(any, [&](const std::string& name, const auto&) { to << name << ' '; });
    to << '\n';
}

void write(const StepState& state, std::ostream& to)
{
    std::ostringstream line;
    line << std::setprecision(12);
    visit_columns(state, [&](const std::string&, const auto& number) { line << number << ' '; });
    to << line.str() << '\n';
}

std::vector<StepState> read_states(std::istream& from)
{
    std::string line;
    std::getline(from, line);
    std::istringstream names(line);
    std::vector<std::string> columns;
    for (std::string name; names >> name;)
        columns.push_back(name);

    std::vector<StepState> states;
    while (std::getline(from, line)) {
        std::istringstream numbers(line);
        StepState state;
        for (const std::string& column : columns) {
            std::string number;  // not read as a double, which would refuse "nan" and "inf"
            if (!(numbers >> number)) throw std::runtime_error("a series of steps has a short line: " + line);
            set(state, column, std::stod(number));
        }
        states.push_back(state);
    }
    return states;
}

}  // namespace interphase
