// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "FixedList.H"
#include "fvMesh.H"
#include "mapDistributeBase.H"

#include <vector>

namespace interstice
{

/// N numbers a cell, travelling together.
template<unsigned N>
using Packed = Foam::FixedList<Foam::scalar, N>;

/// The cells of this rank and, behind them, copies of the cells of other ranks that share a
/// point with them, also through cyclic patches.
///
/// Compact index: [0, nCells) own cells, [nCells, size()) ghosts. All members that move data are
/// collective. The mesh must not change.
class CellHalo
{
public:
    /// Two cells that share a face, the second one perhaps a ghost.
    struct Link
    {
        Foam::label cell; ///< own
        Foam::label other; ///< compact; own for an internal face
        Foam::scalar conductance; ///< |S|/d of the face [m]
        bool internal; ///< false: coupled, listed on the other side as well
    };

    explicit CellHalo(const Foam::fvMesh& mesh);

    Foam::label nCells() const { return nCells_; }
    Foam::label size() const { return map_->constructSize(); }

    /// Compact indices of a cell and all cells that share a point with it, the cell itself first.
    const Foam::labelListList& neighbourhood() const { return neighbourhood_; }

    /// One link a face: internal faces once, coupled faces once on either side.
    const std::vector<Link>& links() const { return links_; }

    /// Own cells of which other ranks have copies. Local.
    const Foam::labelList& shared() const { return shared_; }

    /// Own values, data[0..nCells), to the ghosts: data becomes size() long.
    template<class T>
    void toGhosts(Foam::List<T>& data) const;

    /// Ghost values are added to the cells they are copies of: data becomes nCells() long.
    template<unsigned N>
    void addGhosts(Foam::List<Packed<N>>& data) const;

private:
    struct Keep
    {
        template<class T>
        const T& operator()(const T& value) const { return value; }
    };
    struct Add
    {
        template<class T>
        void operator()(T& sum, const T& value) const
        {
            for (unsigned n = 0; n < T::max_size(); ++n)
            {
                sum[n] += value[n];
            }
        }
    };

    void link(const Foam::fvMesh& mesh, const Foam::globalIndex& numbering,
        const Foam::List<Foam::Map<Foam::label>>& compact);

    Foam::label nCells_;
    Foam::labelListList neighbourhood_;
    Foam::labelList shared_;
    std::unique_ptr<Foam::mapDistributeBase> map_;
    std::vector<Link> links_;
};

template<class T>
void CellHalo::toGhosts(Foam::List<T>& data) const
{
    if (Foam::Pstream::parRun())
    {
        map_->distribute(data, Keep());
    }
}

template<unsigned N>
void CellHalo::addGhosts(Foam::List<Packed<N>>& data) const
{
    if (Foam::Pstream::parRun())
    {
        Foam::mapDistributeBase::distribute(Foam::Pstream::defaultCommsType,
            Foam::List<Foam::labelPair>(), nCells_, map_->constructMap(), false, map_->subMap(),
            false, data, Add(), Keep(), Packed<N>(Foam::Zero));
    }
}

} // namespace interstice
