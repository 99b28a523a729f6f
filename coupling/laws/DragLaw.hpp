// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace interstice
{

/// The air around one particle: all that a drag law needs to know.
struct LocalFlow
{
    double slip; ///< |u - v| [m/s], u the interstitial gas velocity, v the particle's.
    double voidFraction; ///< Share of the volume that is gas, in (0, 1].
    double diameter; ///< Of the sphere, or of the sphere of equal volume [m].
    double density; ///< Of the gas [kg/m3].
    double viscosity; ///< Of the gas, dynamic [Pa s].

    /// Reynolds number of the interstitial slip; the void fraction is not in it.
    double reynolds() const noexcept { return density * slip * diameter / viscosity; }

    /// Share of the volume that is grains. Never negative, so that a void fraction which
    /// round-off has lifted above one does not reach a square root or a logarithm.
    double solidFraction() const noexcept { return voidFraction < 1 ? 1 - voidFraction : 0; }
};

/// Drag of a particle among its neighbours.
///
/// A law gives B = beta/alpha_p [kg/m3/s], the momentum exchange coefficient per volume of
/// particle, for which
///
///     F = V_p B (u - v)      drag force on one particle [N]
///     f = alpha_p B (u - v)  drag force per bed volume [N/m3]
///
/// belong to model A: the particle feels -V_p grad(p) besides (Zhou, Kuang, Chu & Yu, J. Fluid
/// Mech. 661 (2010) 482-510). A drag coefficient C_D corresponds to
///
///     B = 3/4 C_D rho |u - v|/d = 3/4 (C_D Re) mu/d^2
///
/// and laws use the second form, which stays finite when the slip vanishes.
class DragLaw
{
public:
    virtual ~DragLaw() = default;

    /// B [kg/m3/s]. Pure; raises no floating-point exception for a void fraction in [0.2, 1]
    /// and a slip of zero or of any Reynolds number from 1e-12 to 1e6.
    virtual double coefficientPerVolume(const LocalFlow& flow) const = 0;
};

/// Choices that only some laws know; the others ignore them.
struct DragOptions
{
    /// Sphericity of the grains, in (0, 1]; 1 for spheres. Read by GidaspowHuilin.
    double sphericity = 1;

    /// Stretch the Gidaspow-Huilin blend so that it runs from exactly 0 to exactly 1.
    /// Off reproduces the published formula, whose ends leak by up to 0.6 %.
    bool cleanBlend = false;
};

/// One line of the table of laws.
struct DragLawEntry
{
    std::string name; ///< As written in an input file.
    std::string description; ///< One sentence for lists and messages.
    std::string reference; ///< The publication.
};

/// The laws that can be made; the first is the default.
const std::vector<DragLawEntry>& dragLaws();

/// Makes a law by the name it has in dragLaws().
///
/// @param where file and key the name was read from, for the message
/// @throws InputError for an unknown name (the message lists the known ones) and for a
///         sphericity outside (0, 1]
std::unique_ptr<DragLaw> makeDragLaw(
    const std::string& name, const DragOptions& options = {}, const std::string& where = {});

} // namespace interstice
