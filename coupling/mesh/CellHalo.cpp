// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/mesh/CellHalo.hpp"

#include "CPCCellToCellStencil.H"
#include "globalIndex.H"
#include "surfaceFields.H"
#include "syncTools.H"

namespace interstice
{

using namespace Foam;

CellHalo::CellHalo(const fvMesh& mesh)
:
    nCells_(mesh.nCells())
{
    // OpenFOAM's stencil numbers cells and boundary faces together; cells alone are wanted here.
    const CPCCellToCellStencil stencil(mesh);
    const globalIndex& withFaces = stencil.globalNumbering();
    const globalIndex numbering(nCells_);
    labelList cellsOf(Pstream::nProcs());
    forAll(cellsOf, proc)
    {
        cellsOf[proc] = numbering.localSize(proc);
    }

    neighbourhood_.setSize(nCells_);
    forAll(stencil, celli)
    {
        DynamicList<label> cells(27);
        for (const label id : stencil[celli])
        {
            const label proc = withFaces.whichProcID(id);
            const label local = withFaces.toLocal(proc, id);
            if (local < cellsOf[proc])
            {
                cells.append(numbering.toGlobal(proc, local));
            }
        }
        neighbourhood_[celli].transfer(cells);
    }

    List<Map<label>> compact;
    map_ = std::make_unique<mapDistributeBase>(numbering, neighbourhood_, compact);
    link(mesh, numbering, compact);

    labelHashSet shared;
    forAll(map_->subMap(), proc)
    {
        if (proc != Pstream::myProcNo())
        {
            shared.insert(map_->subMap()[proc]);
        }
    }
    shared_ = shared.sortedToc();
}

void CellHalo::link(const fvMesh& mesh, const globalIndex& numbering,
    const List<Map<label>>& compact)
{
    const surfaceScalarField conductance(mesh.magSf()*mesh.nonOrthDeltaCoeffs());
    forAll(mesh.neighbour(), facei)
    {
        links_.push_back({mesh.owner()[facei], mesh.neighbour()[facei], conductance[facei],
            true});
    }

    labelList ids(nCells_);
    forAll(ids, celli)
    {
        ids[celli] = numbering.toGlobal(celli);
    }
    labelList across;
    syncTools::swapBoundaryCellList(mesh, ids, across);
    for (const fvPatch& patch : mesh.boundary())
    {
        if (!patch.coupled())
        {
            continue;
        }
        const scalarField& g = conductance.boundaryField()[patch.index()];
        forAll(patch, i)
        {
            const label id = across[patch.start() + i - mesh.nInternalFaces()];
            const label proc = numbering.whichProcID(id);
            const label local = numbering.toLocal(proc, id);
            const label other = proc == Pstream::myProcNo() ? local : compact[proc][local];
            links_.push_back({patch.faceCells()[i], other, g[i], false});
        }
    }
}

} // namespace interstice
