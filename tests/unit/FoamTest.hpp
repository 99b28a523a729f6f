// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace Foam
{
class Time;
}

namespace interstice
{

/// The clock of the case a test was started in (interstice_test(... CASE ...)), for making a mesh:
///
///     Foam::fvMesh mesh(Foam::IOobject(Foam::fvMesh::defaultRegion, "0", foamTime()));
///
/// Throws std::logic_error in a test that was started without a case.
Foam::Time& foamTime();

} // namespace interstice
