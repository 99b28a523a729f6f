// SPDX-License-Identifier: GPL-3.0-or-later
// What the LIGGGHTS script defined.
#include "coupling/dem/DemEngineImplementation.hpp"

#include <domain.h>
#include <fix_gravity.h>
#include <fix_property_global.h>
#include <force.h>
#include <modify.h>
#include <pair_gran.h>

#include <algorithm>
#include <cstring>
#include <functional>

namespace interstice
{

namespace
{

bool anyFix(LAMMPS_NS::LAMMPS& lammps, const std::function<bool(const LAMMPS_NS::Fix&)>& is)
{
    const LAMMPS_NS::Modify& modify = *lammps.modify;
    return std::any_of(modify.fix, modify.fix + modify.nfix,
        [&is](const LAMMPS_NS::Fix* fix) { return is(*fix); });
}

// Of a granular pair style: normal, tangential, cohesion, rolling, surface. LIGGGHTS names a model of each by six bits of
// one number, which are zero where there is none (contact_models.h).
bool contactPart(LAMMPS_NS::LAMMPS& lammps, int place)
{
    constexpr int bits = 6;
    auto* pair = dynamic_cast<LAMMPS_NS::PairGran*>(lammps.force->pair);
    return pair && ((pair->hashcode() >> (bits*place)) & ((1 << bits) - 1)) != 0;
}

} // namespace

bool DemEngine::hasBox() const
{
    return implementation_->liggghts.lammps().domain->box_exist != 0;
}

bool DemEngine::hasIntegrator() const
{
    return anyFix(implementation_->liggghts.lammps(),
        [](const LAMMPS_NS::Fix& fix) { return fix.time_integrate != 0; });
}

bool DemEngine::hasCohesion() const
{
    return contactPart(implementation_->liggghts.lammps(), 2);
}

bool DemEngine::hasRollingFriction() const
{
    return contactPart(implementation_->liggghts.lammps(), 3);
}

bool DemEngine::hasWalls() const
{
    return anyFix(implementation_->liggghts.lammps(),
        [](const LAMMPS_NS::Fix& fix) { return std::strncmp(fix.style, "wall/gran", 9) == 0; });
}

DemBox DemEngine::box() const
{
    const LAMMPS_NS::Domain& domain = *implementation_->liggghts.lammps().domain;
    DemBox box;
    for (int k = 0; k < 3; ++k)
    {
        box.low[k] = domain.boxlo[k];
        box.high[k] = domain.boxhi[k];
        box.periodic[k] = domain.periodicity[k] != 0;
    }
    return box;
}

Vector3 DemEngine::gravity() const
{
    const LAMMPS_NS::Modify& modify = *implementation_->liggghts.lammps().modify;
    Vector3 sum{};
    for (int i = 0; i < modify.nfix; ++i)
    {
        if (auto* gravity = dynamic_cast<LAMMPS_NS::FixGravity*>(modify.fix[i]))
        {
            Vector3 one{};
            gravity->get_gravity(one.data());
            for (int k = 0; k < 3; ++k)
            {
                sum[k] += one[k];
            }
        }
    }
    return sum;
}

std::vector<double> DemEngine::materialProperty(const std::string& name) const
{
    const LAMMPS_NS::Modify& modify = *implementation_->liggghts.lammps().modify;
    for (int i = 0; i < modify.nfix; ++i)
    {
        auto* property = dynamic_cast<LAMMPS_NS::FixPropertyGlobal*>(modify.fix[i]);
        const auto has = [&](const char* shape)
        { return property && property->check_fix(name.c_str(), shape, 0, 0, "", false); };
        int count = 0;
        if (has("scalar"))
        {
            count = 1;
        }
        else if (has("vector"))
        {
            count = property->size_vector;
        }
        else if (has("matrix"))
        {
            count = property->size_array_rows*property->size_array_cols;
        }
        if (count > 0)
        {
            return {property->get_values(), property->get_values() + count};
        }
    }
    return {};
}

} // namespace interstice
