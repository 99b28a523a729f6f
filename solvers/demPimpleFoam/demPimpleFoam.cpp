// SPDX-License-Identifier: GPL-3.0-or-later
//
// demPimpleFoam: powder (LIGGGHTS) in air (volume-averaged Navier-Stokes, PIMPLE).
//
//     d(alpha)/dt + div(alpha U) = 0
//     d(alpha U)/dt + div(alpha U U) = -alpha grad(p) + div(alpha tau) - K/rho (U - U_s) + alpha g
//
// with alpha div(tau) instead if the powder feels viscous stresses, V div(tau) each particle.
// Air that may be compressed takes in alpha/p0 dp/dt besides (isothermal, p small beside p0).
//
// Model A of Zhou, Kuang, Chu & Yu, J. Fluid Mech. 661 (2010) 482-510: the air loses what drag gives
// to the powder, and the powder feels -V grad(p) besides. p is the pressure over the density.

#include "AirFlow.hpp"
#include "RunLog.hpp"
#include "Session.hpp"
#include "StopRequest.hpp"

using namespace Foam;

static int run(argList& args)
{
    interstice::Session session(args);
    Time& runTime = session.time();
    fvMesh& mesh = session.mesh();

    interstice::StageClock clock;
    interstice::AirFlow air(mesh, clock);
    interstice::CoupledPowder powder(mesh, {air.density(), air.nu(), air.driven()}, clock);
    if (powder.resumed())
    {
        air.resume();
    }
    else
    {
        air.start(powder.onMesh(), powder.solids());
    }
    if (!powder.movesAir())
    {
        air.hold();
    }
    interstice::RunLog log(runTime, powder, clock);
    interstice::StopRequest stop;
    bool stopped = false;

    try
    {
        while (!(stopped = stop.came()) && runTime.run())
        {
            powder.chooseTimeStep(air.courant());
            ++runTime;

            if (powder.hasAir())
            {
                powder.toAir(air.U(), air.nu());
                if (powder.movesAir())
                {
                    air.solve(powder.onMesh(), powder.solids(), powder.feelsViscosity());
                }
                powder.fromAir(air.U(), air.nu(), air.stressGradient());
            }
            else
            {
                powder.fall();
            }

            log.step(air.report());
            log.write();
        }
    }
    catch (const interstice::RunFailure&)
    {
        log.lastGood();
        throw;
    }
    if (stopped)
    {
        log.stopped(stop.name());
        return stop.exitCode();
    }
    log.end();
    return 0;
}

int main(int argc, char* argv[])
{
    return interstice::Session::guard(run, argc, argv);
}
