// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/laws/DragLaw.hpp"

namespace interstice
{

/// Drag of a lone sphere; does not know its neighbours.
///
///     C_D Re = 24 (1 + 0.15 Re^0.687)   Re <= 1000
///     C_D    = 0.44                     Re >  1000
///     Re     = rho |u - v| d/mu
///
/// L. Schiller & A. Naumann, Z. Ver. Dtsch. Ing. 77 (1933) 318-320.
class SchillerNaumannDrag final : public DragLaw
{
public:
    double coefficientPerVolume(const LocalFlow& flow) const override;
};

} // namespace interstice
