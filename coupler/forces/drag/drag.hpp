// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "forces/drag/cluster_length.hpp"
#include "forces/drag/drag_counts.hpp"
#include "forces/drag/drag_law.hpp"
#include "forces/term.hpp"

namespace interphase {

/// Drag by a law: the rate k that stands for a whole step (rate_over_step.hpp), of the gas as it would be without the
/// particle (forces/self_disturbance). It acts last, since the slip half way
/// through the step depends on what the other terms do.
class Drag : public Term {
public:
    explicit Drag(const DragLaw& law) : law_(law) {}

    Needs needs() const override;
    void act(const ParticleInGas& at, Response& response) override;

    /// k [kg/s] of a tracked particle, were the voidage and the slip's speed [m/s] these.
    double rate_at(const ParticleInGas& at, double voidage, double slip_speed) const;

    std::vector<Count> counts() const override
    {
        return {{beyond_drag_range, beyond_range_, departure_}, {self_disturbance_limited, limited_}};
    }

    void keep(Archive& archive) override
    {
        archive.keep_share("beyond_range", beyond_range_);
        archive.keep_share("departure", departure_);
        archive.keep_share("limited", limited_);
    }

private:
    /// What a law may ask for beside voidage and Reynolds number.
    DragState asked_for(const ParticleInGas& at) const;

    /// How far the law's factor is from that of a law whose range holds the state: Wen and Yu's, else Ergun's; its own
    /// size where neither's does.
    double departure(const DragState& state) const;

    const DragLaw& law_;
    const DragLaw *wen_yu_ = find_drag_law("WenYu"), *ergun_ = find_drag_law("Ergun");
    mutable ClusterLength cluster_length_;
    long beyond_range_ = 0;
    double departure_ = 0;  ///< summed over those beyond the range
    long limited_ = 0;
};

}  // namespace interphase
