# SPDX-License-Identifier: GPL-3.0-or-later
"""What a run cannot go on from is refused in one sentence, on all ranks, and with a non-zero exit: a
checkpoint that is torn, of another case or of another powder, one whose air or powder is missing, and a
script that does not read it."""
import re

from hardCase import main
from filling import ROOT, Filling

TIME = 2e-4  # at which the run was stopped [s]


def cut(path, size):
    path.write_bytes(path.read_bytes()[:size])


def truncatedParticles(run, name):
    cut(run.powder(name)/"dem.restart", 5000)
    return "A run goes on from a checkpoint that is whole", "other bytes than were written"


def truncatedRecord(run, name):
    cut(run.powder(name)/"checkpoint", 300)
    return "A run goes on from a checkpoint that is whole", "ends too early"


def earlierVersion(run, name):
    record = run.powder(name)/"checkpoint"
    record.write_text(re.sub(r"\nlag [^\n]*", "", record.read_text()))
    return "A run goes on from a checkpoint that this version wrote", "no entry lag"


def withoutEffects(run, name):
    record = run.powder(name)/"checkpoint"
    record.write_text(re.sub(r"\neffects\s*{[^}]*}", "", record.read_text()))
    return "A run goes on from a checkpoint that this version wrote", "no entry effects"


def noPowder(run, name):
    for file in run.powder(name).iterdir():
        file.unlink()
    run.powder(name).rmdir()
    return "A run goes on from a checkpoint that is whole", "no powder in"


def noFlux(run, name):
    (run.parts()[-1]/name/"alphaPhi").unlink()
    return "A run goes on from a checkpoint that is whole", "no field alphaPhi"


def anotherPowder(run, name):
    run.set("system/caseParameters", "coarseGraining", "10")
    return "with the case and the powder that it began with", "coarseGraining 20"


def anotherCase(run, name):
    """Of the same powder: the record tells of a mesh with one cell less."""
    record = run.powder(name)/"checkpoint"
    record.write_text(re.sub(r"(\ncells +)(\d+)", lambda m: m[1] + str(int(m[2]) - 1),
                             record.read_text()))
    return "with the case and the powder that it began with", "constant/polyMesh"


def ownScript(run, old, new):
    """The scripts in the case's folder, which come first, with another text."""
    for file in (ROOT/"liggghts_scripts").glob("*.in"):
        text = file.read_text()
        if file.name == "dieFilling.in":
            assert old in text
            text = text.replace(old, new)
        (run.folder/file.name).write_text(text)


def otherScript(run, name):
    ownScript(run, "${resume} == 1", "${resume} == 2")
    return "must read the particles of its checkpoint", 'if "${resume} == 1"'


def runAfterReading(run, name):
    """LIGGGHTS forgets at a run what no fix has claimed: what the air is owed."""
    ownScript(run, 'if "${resume} == 0" then "run 0"', "run 0")
    return "momentum owed to the air", "no run may follow read_restart"


def tornStart(run, name):
    (run.powder(name)/"checkpoint").unlink()
    start = f"startTime;\nstartTime {name}"
    run.set("system/controlDict", "startFrom", start)
    return "A run starts from the folder of a time", "that is whole"


def noSuchStart(run, name):
    run.set("system/controlDict", "startFrom", f"startTime;\nstartTime {1.5*TIME:g}")
    return "A run starts from the folder of a time", f"no folder {1.5*TIME:g}"


def verify(bench):
    whole = Filling.poured(bench.work, bench.solver).decompose(bench.ranks)
    whole.until(TIME, TIME).run()
    name = whole.whole()[-1]
    whole.until(2*TIME, TIME)
    for fault in (truncatedParticles, truncatedRecord, earlierVersion, withoutEffects, noPowder, noFlux,
                  anotherPowder, anotherCase, otherScript, runAfterReading, tornStart, noSuchStart):
        run = whole.copy(fault.__name__)
        words = fault(run, name)
        said = run.refused()
        bench.equal(run, "words missing from the error", 0, sum(w not in said for w in words), 0)
        bench.equal(run, "times it is told", 1, said.count("ERROR"), 0)


if __name__ == "__main__":
    main(verify)
