# SPDX-License-Identifier: GPL-3.0-or-later
"""Powder and air in a section of the die while the shoe crosses it: a row of panels for each place of
the shoe, a column for each value of what varies."""
import functools
from dataclasses import dataclass

import matplotlib.pyplot as plt
import numpy as np

import airNumbers
import figures as engine
import keptRuns
import runFolder
import section
from badInput import BadInput
from section import MM

WIDE = 7.2  # of a printed page [in]
ACROSS = 4  # columns that a page can hold
# Name, words, and how far the shoe has come then [m].
PLACES = (
    ("frontOverMiddle", "front wall over\nthe die's middle", lambda d: 0.5*d["dieLength"] - d["shoeXHigh"]),
    ("frontCrossed", "front wall has\ncrossed the die", lambda d: d["dieLength"] - d["shoeXHigh"]),
    ("rearArrives", "rear wall arrives\nat the die", lambda d: -d["shoeXLow"]),
)


@dataclass
class Shot:
    """A run at one place of its shoe."""
    d: dict
    t: float
    air: str
    powder: str

    @property
    def travel(self):
        return runFolder.shoeAt(self.d, self.t)

    def cells(self):
        return cells(self.air)


@functools.lru_cache(maxsize=None)
def cells(path):
    return runFolder.cells(path)[1:]


def shots(home, study):
    """Of one run, one for each place."""
    d = runFolder.derived(home)
    names = [nearest(d, home, place(d), study) for _, _, place in PLACES]
    return [Shot(d, float(name), *files)
            for name, files in zip(names, keptRuns.converted(home, names))]


def nearest(d, home, travel, study):
    """Name of the instant at which the shoe had come closest to there: to within half a wall."""
    off = lambda name: abs(runFolder.shoeAt(d, float(name)) - travel)
    name = min(keptRuns.times(home), key=off, default=None)
    if name is None or off(name) > 0.5*d["shoeWallThickness"]:
        found = f"at {MM*runFolder.shoeAt(d, float(name)):.3g} mm" if name else "missing"
        raise BadInput(f"the instant for a shoe that has come {MM*travel:.3g} mm is {found} in {home}; "
                       f"choose 'pictures' as the study {study} does.")
    return name


def columns(table, chosen, study):
    """What varies, if anything, and [(value of it, parameters, [shots of each packing])]."""
    kept = keptRuns.found(table, chosen, study)
    varied = sorted({key for one, _ in kept for key in keptRuns.differing(kept[0][0], one)})
    if len(varied) > 1:
        at = "shoeSpeed" if "shoeSpeed" in varied else varied[0]
        raise BadInput(f"{', '.join(varied)} vary in the kept runs of {table.name}, and one may: choose "
                       f"by --where {at}=VALUE.")
    key = varied[0] if varied else None
    found = {}
    for one, home in kept:
        found.setdefault(one[key] if key else "", (one, []))[1].append(shots(home, study))
    if len(found) > ACROSS:
        raise BadInput(f"{key} has {len(found)} values in the kept runs of {table.name}, and {ACROSS} "
                       f"fit on a page: choose rows by --where.")
    return key, [(value, *found[value]) for value in sorted(found)]


def numbers(table, chosen, study):
    """Rows of the csv: means over packings."""
    rows = []
    key, all_ = columns(table, chosen, study)
    for _, parameters, packings in all_:
        for number, (name, *_) in enumerate(PLACES):
            here = [packing[number] for packing in packings]
            rows.append({**{word: parameters[word] for word in
                            dict.fromkeys(("particleDiameter", "shoeSpeed", key)) if word},
                         "shoeIs": name, "shoeTravel": here[0].travel, "time": here[0].t,
                         "packings": len(here), **averaged(here)})
    return rows


def averaged(here):
    return airNumbers.averaged([airNumbers.of(shot.d, *shot.cells()) for shot in here])


def sheet(table, key, all_, draw, label):
    """The grid; draw(axes, shots of all packings) draws one panel and returns what has colours."""
    wide = (WIDE - 0.8)/max(len(all_), 3)  # of a panel
    fig, axes = plt.subplots(len(PLACES), len(all_), sharex=True, sharey=True, squeeze=False,
                             figsize=(max(0.8 + wide*len(all_), engine.WIDTH),
                                      1.1 + len(PLACES)*(0.4 + 0.8*wide)), layout="constrained")
    for column, (value, _, packings) in enumerate(all_):
        for row in range(len(PLACES)):
            coloured = draw(axes[row, column], [packing[row] for packing in packings])
        if key:
            name = axes[0, column].get_title()
            axes[0, column].set_title(f"{table.nameOf(key, value)}\n{name}", fontsize=8)
    for panels, (_, words, _) in zip(axes, PLACES):
        panels[0].set_ylabel(f"{words}\n$z$ [mm]", fontsize=8)
    for panel in axes[-1]:
        panel.set_xlabel("$x$ [mm]")
    fig.colorbar(coloured, ax=axes, location="bottom", label=label, shrink=0.6, aspect=40, extend="max")
    return fig


def frame(axes, shot, title=""):
    """Walls and the view: the die, and as much of the shoe above it."""
    d = shot.d
    section.walls(axes, d, shot.t)
    length, depth = MM*d["dieLength"], MM*d["dieDepth"]
    axes.set(xlim=(-0.25*length, 1.25*length), ylim=(-depth - section.FLOOR, 0.8*depth), aspect="equal")
    axes.set_title(f"$x_s$ = {MM*shot.travel:.1f} mm, $t$ = {MM*shot.t:.0f} ms{title}", fontsize=7)


def fastest(speeds):
    """End of a colour scale: what one in a hundred exceeds, with two digits."""
    all_ = np.concatenate(speeds)
    top = float(f"{np.percentile(all_, 99):.1e}") if len(all_) else 0
    return top or 1.0


def inView(d, x):
    return ((x[:, 0] > -0.25*d["dieLength"]) & (x[:, 0] < 1.25*d["dieLength"])
            & (x[:, 2] < 0.8*d["dieDepth"]))


def powder(table, chosen, study):
    key, all_ = columns(table, chosen, study)
    drawn = [shot for *_, packings in all_ for shot in packings[0]]
    clouds = {shot.powder: runFolder.parcels(shot.powder) for shot in drawn}
    top = fastest([np.linalg.norm(clouds[shot.powder][1]["U"], axis=1)[
        inView(shot.d, clouds[shot.powder][0])] for shot in drawn])

    def panel(axes, shots):
        frame(axes, shots[0])
        return section.parcels(axes, *clouds[shots[0].powder], fastest=top, cmap="viridis",
                               edgecolor="white", lw=0.2, rasterized=True)

    return sheet(table, key, all_, panel, "speed of the parcels [m/s]")


def air(table, chosen, study):
    key, all_ = columns(table, chosen, study)
    drawn = [shot for *_, packings in all_ for shot in packings[0]]
    speeds = []
    for shot in drawn:
        centres, data = shot.cells()
        free = inView(shot.d, centres) & (data["solid"][:, 0] < 0.5)
        speeds.append(np.linalg.norm(data["U"][free], axis=1))
    top = fastest(speeds)

    def panel(axes, shots):
        frame(axes, shots[0], "\n" + told(averaged(shots)))
        return flow(axes, *shots[0].cells(), top)

    return sheet(table, key, all_, panel, f"speed of the air [m/s] (orange: void fraction "
                 f"{airNumbers.BULK:g})")


def told(means):
    if means["meanVorticity"] is None:
        return "no free air in the die"
    error = means["meanVorticity.error"]
    return (rf"mean $|\omega_y|$ = {means['meanVorticity']:.0f}"
            + (rf" $\pm$ {error:.0f}" if error is not None else "")
            + f" s$^{{-1}}$\n$u_\\mathrm{{max}}$ = {means['peakAirSpeed']:.2f} m/s")


def flow(axes, centres, data, top):
    """Speed as colour, streamlines, and the surface of the powder's bulk."""
    level = np.abs(centres[:, 1]) < np.abs(centres[:, 1]).min() + 1e-7
    level &= centres[:, 1] <= centres[np.argmin(np.abs(centres[:, 1])), 1] + 1e-7
    x, column = lines(MM*centres[level, 0])
    z, row = lines(MM*centres[level, 2])

    def plane(values, empty):
        filled = np.full((len(z), len(x)), empty, float)
        filled[row, column] = values[level]
        return filled

    blocked = plane(data["solid"][:, 0] >= 0.5, 1) > 0
    axes.set_facecolor("0.64")  # of solid cells: about as the shoe's walls
    u, w = (plane(data["U"][:, axis], 0) for axis in (0, 2))
    coloured = axes.pcolormesh(x, z, np.ma.masked_where(blocked, np.hypot(u, w)), cmap="viridis", vmin=0,
                               vmax=top, shading="nearest", rasterized=True, zorder=0)
    streamlines(axes, x, z, u, w, blocked)
    bulk = np.ma.masked_where(blocked, plane(data["voidFraction"][:, 0], 1))
    axes.contour(x, z, bulk, [airNumbers.BULK], colors="#D55E00", linewidths=1.2, zorder=3)
    return coloured


def lines(values):
    """Along an axis: where the mesh has cells, ascending, and the number of the line on which each cell lies. VTK's
    numbers of 4 bytes make those of one line differ."""
    order = np.argsort(values)
    gaps = np.diff(values[order])
    number = np.empty(len(values), int)
    number[order] = np.concatenate([[0], np.cumsum(gaps > 0.01*gaps.max())])
    return np.bincount(number, values)/np.bincount(number), number


def streamlines(axes, x, z, u, w, blocked):
    """On a regular grid, which matplotlib needs, of half a cell."""
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    step = 0.5*np.diff(z).min()
    xs, zs = np.arange(left, right, step), np.arange(low, high, step)
    even = lambda values: bilinear(x, z, values, xs, zs)
    solid = even(blocked.astype(float)) > 0.5
    axes.streamplot(xs, zs, np.ma.masked_where(solid, even(u)), np.ma.masked_where(solid, even(w)),
                    color="white", linewidth=0.5, arrowsize=0.5, density=1.4, zorder=1)
    axes.set(xlim=(left, right), ylim=(low, high))


def bilinear(x, z, values, xs, zs):
    along = np.array([np.interp(xs, x, row) for row in values])
    return np.array([np.interp(zs, z, column) for column in along.T]).T
