// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coupling/dem/DemEngine.hpp"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace interstice::test
{

/// A script of this folder.
inline std::string script(const std::string& name)
{
    return std::string(INTERSTICE_DEM_SCRIPTS) + "/" + name;
}

inline DemOptions optionsFor(std::map<std::string, std::string> variables = {})
{
    variables["scripts"] = INTERSTICE_DEM_SCRIPTS;
    DemOptions options;
    options.logFile = "";
    options.screenFile = "screen.liggghts";
    options.variables = std::move(variables);
    return options;
}

/// A script that has run, ready for the air. Collective.
inline std::unique_ptr<DemEngine> coupledScene(
    const std::string& name, const std::map<std::string, std::string>& variables = {})
{
    auto dem = std::make_unique<DemEngine>(MPI_COMM_WORLD, optionsFor(variables));
    dem->runScript(script(name));
    dem->couple();
    return dem;
}

struct Grain
{
    Vector3 position{};
    Vector3 velocity{};
    double mass = 0;

    bool operator==(const Grain& other) const
    {
        return position == other.position && velocity == other.velocity && mass == other.mass;
    }
};

/// All particles of all ranks by id, on every rank. Collective.
inline std::map<int, Grain> everyGrain(const DemEngine& dem)
{
    const ParticleView here = dem.particles();
    std::vector<double> mine;
    for (int i = 0; i < here.count; ++i)
    {
        mine.push_back(here.id[i]);
        mine.insert(mine.end(), here.position[i], here.position[i] + 3);
        mine.insert(mine.end(), here.velocity[i], here.velocity[i] + 3);
        mine.push_back(here.mass[i]);
    }
    int ranks = 0;
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    const int size = static_cast<int>(mine.size());
    std::vector<int> sizes(ranks);
    std::vector<int> offsets(ranks + 1, 0);
    MPI_Allgather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, MPI_COMM_WORLD);
    for (int rank = 0; rank < ranks; ++rank)
    {
        offsets[rank + 1] = offsets[rank] + sizes[rank];
    }
    std::vector<double> all(offsets[ranks]);
    MPI_Allgatherv(mine.data(), size, MPI_DOUBLE, all.data(), sizes.data(), offsets.data(),
                   MPI_DOUBLE, MPI_COMM_WORLD);

    std::map<int, Grain> grains;
    for (std::size_t at = 0; at < all.size(); at += 8)
    {
        Grain& grain = grains[static_cast<int>(all[at])];
        grain.position = {all[at + 1], all[at + 2], all[at + 3]};
        grain.velocity = {all[at + 4], all[at + 5], all[at + 6]};
        grain.mass = all[at + 7];
    }
    return grains;
}

} // namespace interstice::test
