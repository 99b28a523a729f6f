// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/dem/LiggghtsInstance.hpp"

#include "coupling/laws/InputError.hpp"

#include <lammps.h>

#include <input.h>
#include <integrate.h>
#include <library.h>
#include <timer.h>
#include <update.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <fstream>

namespace interstice::dem
{

namespace
{

/// How many steps a LIGGGHTS run may have: the largest int.
constexpr LAMMPS_NS::bigint longestRun = 2147483647;

int rankIn(MPI_Comm communicator)
{
    int rank = 0;
    MPI_Comm_rank(communicator, &rank);
    return rank;
}

/// Rank 0's answer, on all ranks.
bool agreed(bool answer, MPI_Comm communicator)
{
    int flag = answer ? 1 : 0;
    MPI_Bcast(&flag, 1, MPI_INT, 0, communicator);
    return flag == 1;
}

bool canWrite(const std::string& path)
{
    return std::ofstream(path, std::ios::app).good();
}

void requireWritable(const std::string& path, const std::string& key, MPI_Comm communicator)
{
    const bool first = rankIn(communicator) == 0;
    if (!path.empty() && !agreed(first && canWrite(path), communicator))
    {
        throw InputError(
            {"LIGGGHTS must be able to write its output.", "no file can be written at " + path,
             "a file in a folder that exists", key, "Make the folder, or name another file."});
    }
}

void requireNames(const std::map<std::string, std::string>& variables)
{
    for (const auto& [name, text] : variables)
    {
        const bool valid = !name.empty()
            && std::all_of(name.begin(), name.end(), [](unsigned char c)
                           { return std::isalnum(c) || c == '_'; });
        if (!valid || text.empty())
        {
            throw InputError(
                {"A variable for the LIGGGHTS script needs a plain name and a value.",
                 "name '" + name + "', value '" + text + "'",
                 "letters, digits and underscores; a value that is not empty", "",
                 "Rename the variable or give it a value."});
        }
    }
}

} // namespace

LiggghtsInstance::LiggghtsInstance(MPI_Comm communicator, const DemOptions& options)
{
    requireNames(options.variables);
    requireWritable(options.logFile, "DemOptions::logFile", communicator);
    requireWritable(options.screenFile, "DemOptions::screenFile", communicator);

    MPI_Comm_dup(communicator, &communicator_);
    const bool first = rankIn(communicator_) == 0;
    screen_ = std::make_unique<ScreenStream>(first, options.screenFile);
    open(options);
}

void LiggghtsInstance::open(const DemOptions& options)
{
    std::vector<std::string> words{"liggghts", "-screen", "none", "-echo", "both", "-log",
                                   options.logFile.empty() ? "none" : options.logFile};
    for (const auto& [name, text] : options.variables)
    {
        words.insert(words.end(), {"-var", name, text});
    }
    std::vector<char*> arguments;
    for (std::string& word : words)
    {
        arguments.push_back(word.data());
    }

    const LiggghtsAtWork guard(*screen_, "opening");
    void* handle = nullptr;
    lammps_open(static_cast<int>(arguments.size()), arguments.data(), communicator_, &handle);
    lammps_ = static_cast<LAMMPS_NS::LAMMPS*>(handle);

    // From here on a screen exists on every rank; without one LIGGGHTS crashes on a mesh.
    lammps_->screen = screen_->file();
}

LiggghtsInstance::~LiggghtsInstance()
{
    {
        const LiggghtsAtWork guard(*screen_, "closing");
        lammps_close(lammps_);
    }
    MPI_Comm_free(&communicator_);
}

void LiggghtsInstance::requireFile(const std::string& path, const std::string& kind) const
{
    const bool first = rankIn(communicator_) == 0;
    if (!agreed(first && std::ifstream(path).good(), communicator_))
    {
        throw InputError(
            {"The " + kind + " cannot be read.", "no readable file at " + path, "", "",
             "Correct the path; it counts from the folder in which the program runs."});
    }
}

void LiggghtsInstance::runScript(const std::string& path)
{
    requireFile(path, "LIGGGHTS script");
    const LiggghtsAtWork guard(*screen_, "running script " + path);
    lammps_file(lammps_, path.c_str());
}

void LiggghtsInstance::command(const std::string& text)
{
    const LiggghtsAtWork guard(*screen_, "executing the command: " + text);
    lammps_command(lammps_, text.c_str());
}

void LiggghtsInstance::announceRun()
{
    LAMMPS_NS::Update& update = *lammps_->update;
    update.whichflag = 1;
    update.firststep = firstStep_;
    update.beginstep = firstStep_;
    update.laststep = firstStep_ + longestRun;
    update.endstep = update.laststep;
}

void LiggghtsInstance::setUp()
{
    const LiggghtsAtWork guard(*screen_, "setting up the DEM");
    LAMMPS_NS::Update& update = *lammps_->update;
    if (running_)
    {
        // init() would forget the time since the last set-up: a run that ends adds it, ours does not.
        update.update_time();
    }
    running_ = true;
    firstStep_ = update.ntimestep;
    announceRun();
    update.nsteps = longestRun;

    lammps_->init();
    update.integrate->setup();
    lammps_->timer->init();
    lammps_->timer->barrier_start(TIME_LOOP);

    update.whichflag = 0;
}

double LiggghtsInstance::time() const
{
    const LAMMPS_NS::Update& update = *lammps_->update;
    return update.atime + static_cast<double>(update.ntimestep - update.atimestep)*update.dt;
}

void LiggghtsInstance::setClock(double time, double timeStep)
{
    LAMMPS_NS::Update& update = *lammps_->update;
    update.dt = timeStep;
    update.timestep_set = true;
    update.atime = time;
    update.atimestep = update.ntimestep;
}

void LiggghtsInstance::goOn(long steps)
{
    const LiggghtsAtWork guard(*screen_, "advancing");
    announceRun();
    lammps_->update->nsteps = static_cast<int>(steps);
    lammps_->update->integrate->run(static_cast<int>(steps));
    lammps_->update->whichflag = 0;
}

} // namespace interstice::dem
