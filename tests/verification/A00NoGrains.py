# SPDX-License-Identifier: GPL-3.0-or-later
"""Air alone, in a coupled run whose powder has not come yet: a uniform stream stays uniform and
needs no pressure; and between two plates, pulled along them, the air takes Poiseuille's parabola
u = g z (h - z)/(2 nu), the same for any step. Its second differences leave 1/n^2 with n cells."""
from harness.bench import main
from harness.case import Box, Case
from harness.laws import Air, Powder

SPEED = 0.3
ROUND_OFF = 1e-12
HEIGHT, CELLS, PULL, NU = 2e-3, 20, 0.05, 1.5e-5  # [m], across, [m/s2], [m2/s]


def parabola(bench, deltaT):
    cell = HEIGHT/CELLS
    box = Box((4*cell, 4*cell, HEIGHT), (4, 4, CELLS),
              ("periodic", "periodic", ("noSlip", "noSlip")))
    powder = Powder(40e-6, 7360.0, Air(1.2, 1.2*NU))
    run = bench.run(Case(f"plates, dt {deltaT:g} s", box, powder, airGravity=(PULL, 0, 0),
                         slices="x", deltaT=deltaT, endTime=0.5), impulse=0)
    exact = [PULL/(2*NU)*z*(HEIGHT - z) for z in ((i + 0.5)*cell for i in range(CELLS))]
    speeds = [u[0] for u in run.field("U")[::16]]
    bench.equal(run, "velocity off Poiseuille's, of the largest", 0,
                max(abs(u - e) for u, e in zip(speeds, exact))/max(exact), 1.05/CELLS**2)


def verify(bench):
    for cut in ("x", "z"):
        box = Box((0.004, 0.004, 0.02), (4, 4, 20), ("slip", "periodic", ("inlet", "outlet")))
        run = bench.run(Case(f"stream, cut in {cut}", box, U=(0, 0, SPEED), slices=cut,
                             deltaT=1e-4, endTime=2e-3), impulse=0)
        off = max(abs(u - v) for cell in run.field("U") for u, v in zip(cell, (0, 0, SPEED)))
        bench.atMost(run, "change of velocity [m/s]", ROUND_OFF, off)
        bench.atMost(run, "pressure [Pa]", ROUND_OFF, max(map(abs, run.pressureLayers())))
        bench.atMost(run, "void fraction below one", 0, 1 - min(run.field("voidFraction")))
    for deltaT in (1e-3, 1e-2):
        parabola(bench, deltaT)


if __name__ == "__main__":
    main(verify)
