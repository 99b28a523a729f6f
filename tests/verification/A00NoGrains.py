# SPDX-License-Identifier: GPL-3.0-or-later
"""Air alone, in a coupled run whose powder has not come yet: a uniform stream stays uniform and
needs no pressure."""
from harness.bench import main
from harness.case import Box, Case

SPEED = 0.3
ROUND_OFF = 1e-12


def verify(bench):
    for cut in ("x", "z"):
        box = Box((0.004, 0.004, 0.02), (4, 4, 20), ("slip", "periodic", ("inlet", "outlet")))
        run = bench.run(Case(f"stream, cut in {cut}", box, U=(0, 0, SPEED), slices=cut,
                             deltaT=1e-4, endTime=2e-3), impulse=0)
        off = max(abs(u - v) for cell in run.field("U") for u, v in zip(cell, (0, 0, SPEED)))
        bench.atMost(run, "change of velocity [m/s]", ROUND_OFF, off)
        bench.atMost(run, "pressure [Pa]", ROUND_OFF, max(map(abs, run.pressureLayers())))
        bench.atMost(run, "void fraction below one", 0, 1 - min(run.field("voidFraction")))


if __name__ == "__main__":
    main(verify)
