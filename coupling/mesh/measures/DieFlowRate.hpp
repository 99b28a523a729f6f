// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/mesh/measures/DieCavity.hpp"
#include "coupling/mesh/measures/PowderMeasure.hpp"

#include <deque>

namespace interstice
{

/// Volume flow rate of powder into a die: solid volume, without the pores.
///
///     Q(t) = [V(t) - V(t - window)]/window                                        [m3/s]
///
/// the mean of dV/dt over the window that ends at t; V as in DieCavity. Steps need not fit into
/// the window: V between two steps is interpolated. Until a whole window has passed, Q is the
/// mean since the start and does not count for the maximum.
///
/// Usage
///
///     dieFlowRate
///     {
///         type    dieFlowRate;
///         die     { low (0 0 -0.005); high (0.008 0.008 0); }
///         window  2e-3;
///     }
///
/// Property | Description                          | Unit | Default
/// die      | see DieCavity                        |      | required
/// window   | time over which the rate is averaged | s    | required
class DieFlowRate final : public PowderMeasure
{
public:
    TypeName("dieFlowRate");

    DieFlowRate(const word& name, const Foam::Time& time, const Foam::dictionary& dict);

    bool read(const Foam::dictionary& dict) override;

private:
    struct Sample
    {
        double time;
        double volume;
    };

    std::vector<double> measure(const PowderState& powder) override;
    double rate() const;

    std::unique_ptr<DieCavity> die_;
    double window_ = 0;
    std::deque<Sample> past_; // the first one is at least a window old, if any is
    double maximum_ = 0;
    double timeOfMaximum_ = 0;
};

} // namespace interstice
