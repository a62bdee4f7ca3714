// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/mean_fields.hpp"

namespace interphase {

namespace {

/// A smaller share of a cell is what round-off leaves of a diffused sphere that is elsewhere.
constexpr double least_solid_fraction = 1e-12;

}  // namespace

MeanFields::MeanFields(const MeshView& mesh)
    : mesh_(mesh), voidage_(mesh.size(), 1), gas_(mesh.size(), 3), solids_(mesh.size(), 3)
{}

void MeanFields::add(double time, const Scalars& voidage, const Scalars& velocity,
                     const std::vector<CellSolids>& solids)
{
    const std::size_t n = mesh_.size();
    const Scalars alike(n, 1.0);
    voidage_.add(voidage, alike);
    gas_.add(velocity, alike);

    Scalars weights(n, 0.0), of_solids(3 * n, 0.0);
    for (std::size_t c = 0; c < n; ++c) {
        if (solids[c].volume <= least_solid_fraction * mesh_.volume[c]) continue;
        weights[c] = solids[c].volume;
        set_vector_at(of_solids, c, to_vector(solids[c].flow) / solids[c].volume);
    }
    solids_.add(of_solids, weights);

    if (samples_ == 0) first_ = time;
    last_ = time;
    ++samples_;
}

std::vector<CellField> MeanFields::fields() const
{
    return {{"meanVoidage", voidage_.mean(), 0, false},
            {"varianceVoidage", voidage_.variance(), 0, false},
            {"meanU", gas_.mean(), 1, true},
            {"varianceU", gas_.variance(), 2, true},
            {"meanSolidsU", solids_.mean(), 1, true},
            {"varianceSolidsU", solids_.variance(), 2, true}};
}

void MeanFields::describe(const std::string& group, Results& results) const
{
    results.describe(group, "mean_fields_samples", samples_);
    if (samples_ == 0) return;
    results.describe(group, "mean_fields_first", first_);
    results.describe(group, "mean_fields_last", last_);
}

void MeanFields::keep(Archive& archive)
{
    archive.keep("voidage", voidage_);
    archive.keep("gas", gas_);
    archive.keep("solids", solids_);
    archive.keep("samples", samples_);
    archive.keep("first", first_);
    archive.keep("last", last_);
}

}  // namespace interphase
