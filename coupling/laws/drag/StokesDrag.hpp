// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/laws/DragLaw.hpp"

namespace interstice
{

/// Drag of a lone sphere in creeping flow; knows neither inertia nor neighbours.
///
///     C_D Re = 24,   B = 18 mu/d^2
///
/// Valid for Re < 0.1 and a void fraction near one. Linear in the slip, hence the law of tests
/// with a closed solution.
///
/// G.G. Stokes, Trans. Camb. Phil. Soc. 9 (1851) 8-106.
class StokesDrag final : public DragLaw
{
public:
    double coefficientPerVolume(const LocalFlow& flow) const override;
};

} // namespace interstice
