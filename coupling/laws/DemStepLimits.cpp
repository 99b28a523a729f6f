// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/laws/DemStepLimits.hpp"

#include "coupling/laws/TimeScales.hpp"
#include "coupling/laws/sphereVolume.hpp"

#include <algorithm>
#include <limits>

namespace interstice
{

namespace
{

constexpr double infinite = std::numeric_limits<double>::infinity();

double ofType(const std::vector<double>& values, std::size_t type)
{
    return values[std::min(type, values.size() - 1)];
}

struct Material
{
    Material(const ContactMaterials& all, std::size_t type)
        : youngs(ofType(all.youngsModulus, type)), poisson(ofType(all.poissonsRatio, type))
    {
    }

    /// 1/Y* and 1/G* of a contact are sums over its two sides [1/Pa].
    double normalCompliance() const
    {
        return (1 - poisson*poisson)/youngs;
    }
    double shearCompliance() const
    {
        return 2*(2 - poisson)*(1 + poisson)/youngs;
    }

    double youngs;
    double poisson;
};

} // namespace

double DemStepLimits::longestStep() const
{
    return std::min({0.5*rayleigh, 0.5*hertz, dashpot});
}

DemStepLimits demStepLimits(
    const ContactMaterials& materials, double radius, double density, double speed)
{
    const double mass = sphereVolume(2*radius)*density;
    DemStepLimits limits{infinite, infinite, infinite};
    for (std::size_t one = 0; one < materials.ofParticles.size(); ++one)
    {
        if (!materials.ofParticles[one])
        {
            continue;
        }
        const Material particle(materials, one);
        limits.rayleigh = std::min(
            limits.rayleigh, rayleighTime(radius, density, particle.youngs, particle.poisson));
        for (std::size_t other = 0; other < materials.ofParticles.size(); ++other)
        {
            const Material partner(materials, other);
            const double modulus = 1/(particle.normalCompliance() + partner.normalCompliance());
            limits.hertz = std::min(limits.hertz, hertzTime(mass/2, radius/2, modulus, speed));
            if (materials.rough)
            {
                const double shear = 1/(particle.shearCompliance() + partner.shearCompliance());
                limits.dashpot = std::min(limits.dashpot,
                    tangentialDampingTime(
                        mass/2, radius/2, modulus, shear, materials.restitution, speed));
            }
        }
    }
    return limits;
}

} // namespace interstice
