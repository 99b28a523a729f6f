# SPDX-License-Identifier: GPL-3.0-or-later
"""A die filling that is stopped in the middle and goes on takes the path of the one that was not.

The shoe moves by LIGGGHTS' own clock, parcels hold each other and the walls by friction with a history,
the air lags behind. The run is stopped at an output, by SIGTERM, SIGINT and SIGUSR1, by SIGKILL, and by
SIGKILL while a checkpoint is written. On one rank, what goes on must be the same to 1e-12 m after 100 DEM
steps; it is the same to the last bit, as long as one looks.

On several ranks forces are summed in another order, and a difference in the last digit grows with each
collision. How far that takes two runs apart is measured: the twin, not stopped, on another number of
ranks. A run that was stopped at an output may be ten times as far away as that one is at the end.

Powder that is light for its fluid is seen by it late, by a time that a run carries on: here grains of
2500 kg/m3 in water. With another time in the checkpoint the path is another one.

A checkpoint lists neighbours anew. After a signal that is at a time when the other run did not, and a
parcel that touches two triangles of a wall may find the other one first, with its own history of sliding:
a thousandth of a parcel's radius is allowed.
"""
import signal

from hardCase import main
from filling import SIGNALS, Filling

BEFORE = 0.06  # the shoe is over the die [s]
INTERVAL = 4e-4  # of outputs: 4 coupling steps, more than 100 DEM steps [s]
OUTPUTS = 6
SERIAL = 1e-12  # [m]
RADIUS = 0.4e-3  # of a parcel [m]
SIGNALLED = 1e-3*RADIUS
LIGHT = ("particleDensity=2500", "airDensity=1000", "airViscosity=1e-3")
LIGHT_INTERVAL = 2e-4  # [s]


def judgeEnd(bench, run, twin, bound, outputs):
    """Distance to the twin at the first output after the start, and at the end; nothing may be lost."""
    for when, output in (("after 100 DEM steps", outputs[0]), ("at the end", outputs[-1])):
        bench.atMost(run, f"apart {when} [m]", bound, run.apart(twin, output))
    bench.equal(run, "lines that tell of lost parcels", 0, run.log.count("LOST"), 0)


def atOutput(bench, twin, times, bound):
    run = twin.copy("stopped at an output").forget(times[1]).run()
    judgeEnd(bench, run, twin, bound, times[2:])


def bySignal(bench, base, twin, times, number):
    run = base.copy(f"stopped by {SIGNALS[number]}")
    code = run.runUntil(lambda: len(run.whole()) > 2, number)
    bench.equal(run, "exit code", 128 + number, code, 0)
    bench.atLeast(run, "lines that tell of the checkpoint", 1,
                  run.log.count(f"Stopped by {SIGNALS[number]} at"))
    last = run.whole()[-1]
    bench.atMost(run, "stopped before the end, at [s]", float(times[-2]), float(last))
    run.run()
    judgeEnd(bench, run, twin, SIGNALLED, [t for t in times if float(t) > float(last)])


def byKill(bench, base, twin, times, bound):
    run = base.copy("killed")
    run.runUntil(lambda: len(run.whole()) > 3, signal.SIGKILL)
    bench.equal(run, "times written before", 0, 0 if len(run.whole()) > 3 else 1, 0)
    goesOn = run.whole()[-1]
    run.run()
    judgeEnd(bench, run, twin, bound, [t for t in times if float(t) > float(goesOn)])


def torn(bench, twin, times, bound):
    """As a kill leaves it: the particles half written, no record, a field missing."""
    run = twin.copy("killed while writing").forget(times[3])
    half = run.powder(times[3])/"dem.restart"
    half.write_bytes(half.read_bytes()[:1000])
    (run.powder(times[3])/"checkpoint").unlink()
    (run.parts()[-1]/times[3]/"U").unlink()
    run.run()
    said = f"The time folder {times[3]} was not written to its end"
    bench.atLeast(run, "lines that tell of the torn folder", 1, run.log.count(said))
    bench.atLeast(run, "torn folders that were set aside", 1,
                  sum((part/f"{times[3]}.incomplete").is_dir() for part in run.parts()))
    judgeEnd(bench, run, twin, bound, times[3:])


def onOtherRanks(bench, twin, times, growth, other):
    run = twin.copy(f"{twin.ranks} ranks, then {other}").forget(times[1]).decompose(other).run()
    judgeEnd(bench, run, twin, growth, times[2:])


def lightPowder(bench):
    base = Filling.poured(bench.work/"light", bench.solver, *LIGHT).decompose(bench.ranks)
    twin = base.until(4*LIGHT_INTERVAL, LIGHT_INTERVAL).copy("light powder").run()
    bench.equal(twin, "lines that tell of light powder", 1, twin.log.count(" is light: "), 0)
    times = twin.whole()[-4:]
    run = twin.copy("light powder, stopped").forget(times[1]).run()
    bench.equal(run, "lines that tell of light powder", 1, run.log.count(" is light: "), 0)
    bench.atMost(run, "apart at the end [m]", SERIAL, run.apart(twin, times[-1]))

    late = twin.copy("light powder, seen later").forget(times[1])
    late.scale(times[1], "lag", 1.4)
    late.run()
    bench.atLeast(late, "must be another path: apart at the end [m]", 10*SERIAL,
                  late.apart(twin, times[-1]))


def verify(bench):
    start = Filling.poured(bench.work, bench.solver).until(BEFORE, BEFORE).run()
    base = start.copy("base").decompose(bench.ranks)
    base.until(BEFORE + OUTPUTS*INTERVAL, INTERVAL)
    twin = base.copy("not stopped").run()
    times = [t for t in twin.whole() if float(t) > 0.5*BEFORE]
    bench.equal(twin, "outputs", OUTPUTS, len(times) - 1, 0)

    other = 1 if bench.ranks > 1 else 2
    elsewhere = base.copy(f"not stopped, {other} ranks").decompose(other).run()
    apart = elsewhere.apart(twin, times[-1])
    bench.atMost(elsewhere, "apart at the end, of a parcel's radius", 1e-6, apart/RADIUS)
    growth = 10*apart
    bound = SERIAL if bench.ranks == 1 else growth

    atOutput(bench, twin, times, bound)
    for number in SIGNALS:
        bySignal(bench, base, twin, times, number)
    byKill(bench, base, twin, times, bound)
    torn(bench, twin, times, bound)
    onOtherRanks(bench, twin, times, growth, other)
    lightPowder(bench)


if __name__ == "__main__":
    main(verify)
