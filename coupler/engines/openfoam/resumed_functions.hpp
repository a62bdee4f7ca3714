// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "Time.H"

namespace interphase {

/// Function objects in a run that goes on from a later time than the one at which its case starts.
///
/// They begin as in a start of OpenFOAM at that time: with the sums that they had made until then lost, and in new
/// files, in folders of postProcessing/ with that time. They were executed at that time before, and are due again when
/// they would have been in a run that was not stopped.

/// After the clock is set, once: OpenFOAM takes this step for the one at which the run starts, and writes fields from
/// here on as writeControl and writeInterval are now.
void start_here(Foam::Time& time);

/// In the first call of Foam::Time::run(): makes them.
bool make_functions_here(Foam::Time& time);

/// Moves folders of postProcessing/ that an earlier part of the run made from the present time on into another folder,
/// whose name is given back; those of the present time are copied, as results that were sampled then are in them as
/// well as rows from then on. Empty where there are none. On the first rank only; a std::exception where that fails.
std::string put_later_output_aside(const Foam::Time& time);

/// Function objects of the case that are on and may sum up over time: "name (type)", separated by commas.
std::string functions_with_sums(const Foam::Time& time);

}  // namespace interphase
