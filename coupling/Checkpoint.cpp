// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/Checkpoint.hpp"

#include "coupling/laws/InputError.hpp"

#include "IStringStream.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "PstreamReduceOps.H"
#include "SHA1.H"
#include "StringStream.H"
#include "dictionary.H"

#include <cmath>
#include <fstream>
#include <sstream>

namespace interstice
{

using namespace Foam;

namespace
{

const char* const recordName = "checkpoint";
const char* const particlesName = "dem.restart";

fileName folderIn(const fileName& timeFolder)
{
    return timeFolder/"uniform"/"powder";
}

// Of the first rank, known on all.
fileName folderOf(const Time& time)
{
    string folder = folderIn(time.timePath());
    Pstream::scatter(folder);
    return fileName(folder);
}

std::string contents(const fileName& path)
{
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

word digestOf(const fileName& path)
{
    const std::string bytes = contents(path);
    SHA1 sha;
    sha.append(bytes.data(), bytes.size());
    return word(sha.digest().str());
}

List<vector> toFoam(const Triangle& triangle)
{
    List<vector> nodes(3);
    forAll(nodes, i)
    {
        nodes[i] = vector(triangle[i][0], triangle[i][1], triangle[i][2]);
    }
    return nodes;
}

Triangle toTriangle(const List<vector>& nodes)
{
    Triangle triangle{};
    forAll(nodes, i)
    {
        triangle[i] = {nodes[i].x(), nodes[i].y(), nodes[i].z()};
    }
    return triangle;
}

/// While it lives, OpenFOAM writes all digits of a number: a dictionary keeps vectors as text.
class AllDigits
{
public:
    AllDigits() : before_(IOstream::defaultPrecision(17)) {}
    ~AllDigits() { IOstream::defaultPrecision(before_); }
    AllDigits(const AllDigits&) = delete;
    AllDigits& operator=(const AllDigits&) = delete;

private:
    unsigned before_;
};

dictionary written(const DemClockAndWalls& dem)
{
    dictionary dict;
    dict.add("stepsDone", double(dem.stepsDone));
    dict.add("time", dem.time);
    dict.add("timeStep", dem.timeStep);
    dictionary walls;
    for (const auto& [id, marker] : dem.walls)
    {
        dictionary wall;
        wall.add("number", marker.number);
        wall.add("nodes", toFoam(marker.atRest));
        wall.add("velocities", toFoam(marker.velocities));
        walls.add(word(id), wall);
    }
    dict.add("walls", walls);
    return dict;
}

DemClockAndWalls readDem(const dictionary& dict)
{
    DemClockAndWalls dem;
    dem.stepsDone = std::llround(dict.get<scalar>("stepsDone"));
    dem.time = dict.get<scalar>("time");
    dem.timeStep = dict.get<scalar>("timeStep");
    const dictionary& walls = dict.subDict("walls");
    for (const word& id : walls.toc())
    {
        const dictionary& wall = walls.subDict(id);
        dem.walls[id] = {int(wall.get<label>("number")), toTriangle(wall.get<List<vector>>("nodes")),
            toTriangle(wall.get<List<vector>>("velocities"))};
    }
    return dem;
}

InputError torn(const fileName& folder, const std::string& found)
{
    return InputError({"A run goes on from a checkpoint that is whole.", found,
        "the files as they were written", folder,
        "Copy them anew, or delete this time folder to go on from the one before."});
}

// A record that an earlier version wrote may lack an entry.
void require(bool found, const dictionary& record, const word& key)
{
    if (!found)
    {
        throw InputError({"A run goes on from a checkpoint that this version wrote.", "no entry " + key,
            "all entries of a checkpoint", record.name(),
            "Go on with the version that wrote it, or begin anew."});
    }
}

template<class Type>
Type entry(const dictionary& record, const word& key)
{
    require(record.found(key), record, key);
    return record.get<Type>(key);
}

const dictionary& part(const dictionary& record, const word& key)
{
    require(record.isDict(key), record, key);
    return record.subDict(key);
}

} // namespace

fileName Checkpoint::particlesOf(const Time& time)
{
    return folderOf(time)/particlesName;
}

fileName Checkpoint::begin(const Time& time)
{
    const fileName folder = folderOf(time);
    if (Pstream::master())
    {
        mkDir(folder);
        rm(folder/recordName);
    }
    // No rank may write into the time folder before it can be told from a whole one.
    returnReduce(0, sumOp<label>());
    return folder/particlesName;
}

void Checkpoint::complete(const Time& clock) const
{
    const fileName folder = folderOf(clock);
    returnReduce(0, sumOp<label>()); // all ranks have written
    if (!Pstream::master())
    {
        return;
    }
    const AllDigits precise;
    dictionary dict;
    dict.add("time", time);
    dict.add("start", start);
    dict.add("deltaT", deltaT);
    dict.add("timeIndex", timeIndex);
    dict.add("response", response);
    dict.add("lag", lag);
    dict.add("initialMass", initialMass);
    dict.add("lost", double(lost));
    dictionary numbers;
    for (const auto& [key, largest] : effects)
    {
        numbers.add(word(key), largest);
    }
    dict.add("effects", numbers);
    dict.add("dem", written(dem));
    dict.add("particles", double(particles));
    dict.add("mass", mass);
    dict.add("coarseGraining", coarseGraining);
    dict.add("cells", cells);
    dict.add("bounds", bounds);
    dict.add("owed", owed);
    dict.add("digest", string(digestOf(folder/particlesName)));
    {
        OFstream file(folder/"checkpoint.new");
        dict.write(file, false);
    }
    mv(folder/"checkpoint.new", folder/recordName);
}

std::optional<Checkpoint> Checkpoint::of(const Time& clock)
{
    const fileName folder = folderOf(clock);
    string text;
    string digest;
    if (Pstream::master() && isFile(folder/recordName))
    {
        text = contents(folder/recordName);
        digest = digestOf(folder/particlesName);
    }
    Pstream::scatter(text);
    Pstream::scatter(digest);
    if (text.empty())
    {
        return std::nullopt;
    }
    const auto last = text.rfind("digest"); // the last entry
    if (last == std::string::npos || text.find(';', last) == std::string::npos)
    {
        throw torn(folder/recordName, "a file that ends too early");
    }
    IStringStream stream(text);
    dictionary record(stream);
    record.name() = folder/recordName;
    if (entry<string>(record, "digest") != digest)
    {
        throw torn(folder/particlesName, "other bytes than were written");
    }
    Checkpoint c;
    c.time = entry<scalar>(record, "time");
    c.start = entry<scalar>(record, "start");
    c.deltaT = entry<scalar>(record, "deltaT");
    c.timeIndex = entry<label>(record, "timeIndex");
    c.response = entry<scalar>(record, "response");
    c.lag = entry<scalar>(record, "lag");
    c.initialMass = entry<scalar>(record, "initialMass");
    c.lost = std::llround(entry<scalar>(record, "lost"));
    const dictionary& numbers = part(record, "effects");
    for (const word& key : numbers.toc())
    {
        c.effects[key] = entry<scalar>(numbers, key);
    }
    c.dem = readDem(part(record, "dem"));
    c.particles = std::llround(entry<scalar>(record, "particles"));
    c.mass = entry<scalar>(record, "mass");
    c.coarseGraining = entry<scalar>(record, "coarseGraining");
    c.cells = entry<label>(record, "cells");
    c.bounds = entry<boundBox>(record, "bounds");
    c.owed = entry<vector>(record, "owed");
    return c;
}

wordList Checkpoint::setAsideIncomplete(const fileName& casePath)
{
    wordList names;
    if (Pstream::master())
    {
        DynamicList<word> found;
        for (const instant& time : TimePaths::findTimes(casePath))
        {
            const fileName folder = folderIn(casePath/time.name());
            if (isDir(folder) && !isFile(folder/recordName))
            {
                found.append(time.name());
            }
        }
        names = found;
    }
    Pstream::scatter(names);
    for (const word& name : names)
    {
        const fileName aside = casePath/(name + ".incomplete");
        if (isDir(casePath/name))
        {
            rmDir(aside, true);
            mv(casePath/name, aside);
        }
    }
    returnReduce(0, sumOp<label>()); // all ranks have renamed
    return names;
}

void Checkpoint::requireSame(const Checkpoint& now) const
{
    const auto require = [](bool same, const char* what, auto before, auto found, const char* where)
    {
        if (!same)
        {
            OStringStream wanted;
            wanted << what << ' ' << before << ", as when the checkpoint was written";
            OStringStream have;
            have << what << ' ' << found;
            throw InputError({"A run goes on with the case and the powder that it began with.",
                have.str(), wanted.str(), where,
                "Resume with the same mesh and powder, or start anew from time 0."});
        }
    };
    const double size = bounds.mag();
    require(cells == now.cells, "cells", label(cells), label(now.cells), "constant/polyMesh");
    require(mag(bounds.min() - now.bounds.min()) + mag(bounds.max() - now.bounds.max())
            < 1e-6*size, "a mesh within", bounds, now.bounds, "constant/polyMesh");
    require(coarseGraining == now.coarseGraining, "coarseGraining", coarseGraining,
        now.coarseGraining, "constant/couplingProperties, powder");
    require(particles == now.particles, "particles", double(particles), double(now.particles),
        "the LIGGGHTS script of the powder");
    require(std::abs(mass - now.mass) <= 1e-9*mass, "a mass [kg] of", mass, now.mass,
        "the LIGGGHTS script of the powder");
    require(mag(owed - now.owed) <= 1e-9*mag(owed), "momentum owed to the air [N s]", owed, now.owed,
        "the LIGGGHTS script of the powder: no run may follow read_restart");
}

} // namespace interstice
