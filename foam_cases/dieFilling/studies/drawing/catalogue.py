# SPDX-License-Identifier: GPL-3.0-or-later
"""Which figures there are, the number of each in Materials 18 (2025) 3261, and the study that gives it.

What draws them is imported when it is needed: matplotlib takes a second, which `figures --list` and
bad input need not wait for.
"""
import importlib
from dataclasses import dataclass

SIZE, DENSITY, SPEED = "particleDiameter", "particleDensity", "shoeSpeed"
FILLING, FLOW, FORCE = "fillingRatioPassed", "meanFlowRate", "forceNumberMean"

# Short words for axes, where the case's own are sentences.
WORDS = {
    FILLING: dict(kind="measure", text="filling ratio", symbol="δ", unit="1", shown="%"),
    FLOW: dict(kind="measure", text="volume flow rate", symbol="Q", unit="m3/s", shown="mm3/s"),
    FORCE: dict(kind="measure", text=r"force number $G_p/F_\mathrm{drag}$", symbol="", unit="1"),
    SIZE: dict(kind="parameter", symbol="d_p", unit="m"),
    DENSITY: dict(kind="parameter", symbol="ρ_p", unit="kg/m3"),
    SPEED: dict(kind="parameter", symbol="v", unit="m/s"),
    "dieDepth": dict(kind="parameter", symbol="h_D", unit="m"),
}


def name(table):
    """Gives the columns of a table their short words."""
    table.about.update(WORDS)


@dataclass
class Lines:
    """A measure against a group: a line for each value of one parameter, a panel for each of another."""
    number: str
    text: str
    y: str
    x: str
    lines: str
    panels: str
    study: str = "filling.yaml"
    fromZero: bool = True

    def draw(self, table, chosen):
        import panels
        return panels.draw(table, self, chosen.where)


@dataclass
class Scatter:
    """A measure against another, all variants; a mark for each value of a parameter."""
    number: str
    text: str
    y: str
    x: str
    marks: str
    study: str = "filling.yaml"

    def draw(self, table, chosen):
        import panels
        return panels.scatter(table, self, chosen.where)


@dataclass
class OfItsOwn:
    """Drawn by a file of its name."""
    number: str
    text: str
    file: str
    study: str

    def draw(self, table, chosen):
        return importlib.import_module(self.file).draw(table, chosen, self.study)


@dataclass
class Sections:
    number: str
    text: str
    air: bool = False
    study: str = "sections.yaml"

    def draw(self, table, chosen):
        import velocitySections
        return (velocitySections.air if self.air else velocitySections.powder)(table, chosen, self.study)

    def numbers(self, table, chosen):
        """Path of a table to the figure, if there is one."""
        import airNumbers
        import velocitySections
        if not self.air:
            return []
        return [airNumbers.write(chosen.out/"airSections.csv",
                                 velocitySections.numbers(table, chosen, self.study))]


@dataclass
class Critical:
    number: str
    text: str
    study: str = "criticalSize.yaml"
    predicted: bool = False

    def draw(self, table, chosen):
        import criticalSize
        series = criticalSize.modelOf(table, chosen, self.study)
        return (criticalSize.predicted if self.predicted else criticalSize.draw)(series)


FIGURES = {
    "fillingOverSize": Lines("5", "filling ratio against d_p/h_D", FILLING, "dpOverHd", SPEED, DENSITY),
    "fillingOverReynolds": Lines("6", "filling ratio against v rho_g L_D/mu_g", FILLING, "shoeReynolds",
                                 SIZE, DENSITY),
    "fillingOverDensity": Lines("7", "filling ratio against rho_p/rho_g", FILLING, "densityRatio", SIZE,
                                SPEED),
    "powderSections": Sections("8", "powder in the die, coloured by speed, while the shoe crosses it"),
    "fillingOverForce": Scatter("9", "filling ratio against force number G_p/F_drag", FILLING, FORCE,
                                SIZE),
    "airSections": Sections("10", "air in the die, its speed and streamlines, and airSections.csv", True),
    "flowOverSize": Lines("11", "volume flow rate against d_p/h_D", FLOW, "dpOverHd", SPEED, DENSITY),
    "flowOverReynolds": Lines("12", "volume flow rate against v rho_g L_D/mu_g", FLOW, "shoeReynolds",
                              SIZE, DENSITY),
    "flowOverDensity": Lines("13", "volume flow rate against rho_p/rho_g", FLOW, "densityRatio", SIZE,
                             SPEED),
    "forceOverSize": Lines("14", "force number against d_p/h_D", FORCE, "dpOverHd", SPEED, DENSITY),
    "forceOverDensity": Lines("15", "force number against rho_p/rho_g", FORCE, "densityRatio", SIZE,
                              SPEED),
    "fillingOverCavity": Lines("16", "filling ratio against L_D/h_D", FILLING, "LdOverHd", "dieDepth",
                               SPEED, "cavity.yaml", False),
    "surface": OfItsOwn("17", "surface in the die, for each k", "surface", "coarseGraining.yaml"),
    "criticalSize": Critical("18", "critical d_p/h_D against v rho_g L_D/mu_g, beside Eq 21"),
    "predicted": Critical("19", "critical d_p/h_D, predicted against measured", predicted=True),
    "fillingOverTime": OfItsOwn("-", "not of that study: filling ratio and powder flow over time", "fillingOverTime",
                                "coarseGraining.yaml"),
    "airSensitivity": OfItsOwn("-", "not of that study: filling ratio with and without air against d_p", "airSensitivity",
                               "airSensitivity.yaml"),
}
