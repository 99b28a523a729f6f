#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the program fillingModel prints and ends with, on the example table beside it.

usage: commandLine.py <program> <example.csv>
"""
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM, EXAMPLE = (str(Path(word).resolve()) for word in sys.argv[1:3])
POWDER = ["--particleDensity", "8000", "--dieLength", "8e-3"]
INSIDE = POWDER + ["--shoeSpeed", "0.12", "--dieDepth", "5e-3"]


def number(label, text):
    """The first number behind a label."""
    return float(re.search(re.escape(label) + r"\s+(-?[\d.e+-]+)", text).group(1))


class CommandLine(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.model = str(self.folder / "model.json")

    def run_(self, *words, code=0):
        done = subprocess.run([PROGRAM, *words], capture_output=True, text=True)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        self.assertEqual(bool(done.stderr), code != 0, done.stderr)
        return done.stderr if code else done.stdout

    def says(self, text, *parts):
        for part in parts:
            self.assertIn(part, text)

    def fit(self):
        return self.run_("fit", EXAMPLE, "--output", self.model)

    def test_fit_prints_every_table(self):
        text = self.run_("fit", EXAMPLE, "--leaveOut", "each")
        self.says(text, "99 variants of 297 packings in 20 series", "status is not ok: 1",
                  "above 0.012000", "below 0.004000", "8 series", "R^2", "covariance", "Residuals",
                  "Left out: (d_p/h_D)_crit", "Left out: filling ratio", "Eq 21",
                  "left out: 8 rows below and 30 above")
        # The table is made of Eq 21 with a scatter of 1 percentage point.
        self.assertAlmostEqual(number("N_v    ", text.split("95 % interval")[1]), 1.77e-4, delta=1e-5)
        self.assertRegex(text, r"1[012] of 12 are within 2 combined standard errors")

    def test_fit_checks_on_another_table(self):
        lines = Path(EXAMPLE).read_text().splitlines()
        other = self.folder / "other.csv"
        other.write_text("\n".join(lines[:2] + [line for line in lines if ",7360,0.125," in line]))
        text = self.run_("fit", EXAMPLE, "--leaveOut", str(other))
        self.says(text, "1 of 1 series have a critical size between two sizes")

    def test_fit_at_another_threshold_and_measure(self):
        self.says(self.run_("fit", EXAMPLE, "--threshold", "0.8"), "80 % of the die", "beware")
        self.says(self.run_("fit", EXAMPLE, "--measure", "fillingRatioPased", code=1),
                  "no column fillingRatioPased", "Is fillingRatioPassed meant?")

    def test_fit_weighs_by_errors_from_few_packings_only_if_told(self):
        self.assertEqual(self.run_("fit", EXAMPLE).count("    not weighted: "), 2)
        self.assertEqual(self.run_("fit", EXAMPLE, "--trustErrors").count("    weighted by"), 2)

    def test_fit_refuses_bad_tables(self):
        lines = Path(EXAMPLE).read_text().splitlines()
        for body, part in [([], "no row to fit"), (lines[2:4], "too few series"),
                           ([lines[2].replace("0.", "O.", 1)], "column shoeSpeed"),
                           ([line for line in lines if ",7360," in line], "too few series")]:
            bad = self.folder / "bad.csv"
            bad.write_text("\n".join(lines[:2] + body))
            self.says(self.run_("fit", str(bad), code=1), part, "bad.csv")
        self.says(self.run_("fit", "none.csv", code=1), "cannot be opened", "none.csv")
        self.says(self.run_("fit", EXAMPLE, "--output", "/no/such/folder/m.json", code=1),
                  "cannot be written")

    def test_a_table_without_critical_sizes_gives_the_plane_of_the_filling_ratio(self):
        ended = subprocess.run([PROGRAM, "fit", EXAMPLE, "--threshold", "0.999"], capture_output=True, text=True)
        self.assertEqual(ended.returncode, 1)
        self.says(ended.stderr, "too few series")
        self.says(ended.stdout, "filling ratio = s0", "R^2", "Left out: filling ratio")

    def test_predict_gives_the_critical_size(self):
        self.says(self.fit(), "Model written to")
        text = self.run_("predict", self.model, *INSIDE)
        # Eq 21 at N_v 65.72, rho_p/rho_g 6530.6: 0.007309, 36.5 um.
        self.assertAlmostEqual(number("d_90", text), 36.5, delta=0.7)
        self.says(text, "95 % interval", "of the plane", "of one more series", "1.7894e-05 Pa s")
        self.assertNotIn("filling ratio", text)

    def test_predict_gives_the_filling_ratio_of_a_size(self):
        self.fit()
        text = self.run_("predict", self.model, *INSIDE, "--particleDiameter", "30e-6")
        self.assertAlmostEqual(number("filling ratio", text), 0.9 + 90*(0.006 - 0.007309), delta=0.02)
        self.says(text, "counts as full no")
        text = self.run_("predict", self.model, *INSIDE, "--particleDiameter", "40e-6")
        self.says(text, "counts as full yes")
        text = self.run_("predict", self.model, *INSIDE, "--particleDiameter", "36.8e-6")
        self.says(text, "not certain")

    def test_invert_undoes_predict(self):
        self.fit()
        text = self.run_("invert", self.model, "--for", "shoeSpeed", *POWDER, "--dieDepth", "5e-3",
                         "--particleDiameter", "35e-6")
        self.says(text, "largest shoe speed", "full at this shoe speed and below")
        speed = number("shoeSpeed", text)
        text = self.run_("invert", self.model, "--for", "particleDiameter", *POWDER,
                         "--shoeSpeed", str(speed), "--dieDepth", "5e-3")
        self.says(text, "smallest particle diameter", "and above")
        self.assertAlmostEqual(number("particleDiameter", text), 35, delta=0.01)
        text = self.run_("invert", self.model, "--for", "dieDepth", *POWDER, "--shoeSpeed", str(speed),
                         "--particleDiameter", "35e-6", "--extrapolate")
        self.says(text, "deepest die depth", "and below")
        self.assertAlmostEqual(number("dieDepth", text), 5000, delta=1)

    def test_extrapolation_is_refused_and_can_be_asked_for(self):
        self.fit()
        fast = POWDER + ["--shoeSpeed", "0.3", "--dieDepth", "5e-3"]
        self.says(self.run_("predict", self.model, *fast, code=1), "extrapolate", "N_v 164.301",
                  "54.767 to 82.1504", "82.2 above, 300 % of the width", "--extrapolate")
        self.says(self.run_("predict", self.model, *fast, "--extrapolate"), "WARNING", "N_v 164.301",
                  "d_90", "further off than any point")
        self.says(self.run_("predict", self.model, *INSIDE, "--particleDiameter", "90e-6", code=1),
                  "d_p/h_D 0.018")
        deep = ["--for", "dieDepth", *POWDER, "--shoeSpeed", "0.12", "--particleDiameter", "60e-6"]
        self.says(self.run_("invert", self.model, *deep, code=1), "h_D", "0.005 m only")
        self.says(self.run_("invert", self.model, *deep, "--extrapolate"), "WARNING", "deepest")

    def test_compare_shows_both_models(self):
        self.fit()
        self.says(self.run_("compare", self.model), "0.00256", "0.000177202", "-1.05607e-06",
                  "12 of 12 series are in the range of Eq 21")

    def test_wrong_and_torn_models(self):
        self.fit()
        whole = Path(self.model).read_text()
        Path(self.model).write_text(whole[:len(whole)//2])
        for words in [("compare", self.model), ("predict", self.model, *INSIDE), ("compare", EXAMPLE)]:
            self.says(self.run_(*words, code=1), "not a whole filling model")
        self.says(self.run_("compare", "none.json", code=1), "cannot be opened")

    def test_usage(self):
        for words, part in [
                ([], "fillingModel fit TABLE.csv"), (["ft", EXAMPLE], "Did you mean fit?"),
                (["fit"], "names no file"), (["fit", EXAMPLE, EXAMPLE], "two files"),
                (["fit", EXAMPLE, "--treshold", "0.9"], "Did you mean --threshold?"),
                (["fit", EXAMPLE, "--threshold"], "has no value"),
                (["fit", EXAMPLE, "--threshold", "90"], "not a fraction"),
                (["fit", EXAMPLE, "--threshold", "nan"], "number above zero"),
                (["fit", EXAMPLE, "--threshold", "0.9", "--threshold", "0.8"], "given twice"),
                (["predict", "m.json", *POWDER], "no --shoeSpeed"),
                (["predict", "m.json", *POWDER, "--shoeSpeed", "-1"], "--shoeSpeed"),
                (["invert", "m.json", *INSIDE], "quantity to invert for"),
                (["invert", "m.json", "--for", "dieDeph", *POWDER], "Did you mean dieDepth?"),
                (["invert", "m.json", "--for", "shoeSpeed", *INSIDE], "is given as well"),
                (["invert", "m.json", "--for", "particleDiameter", *POWDER, "--shoeSpeed", "1"],
                 "no --dieDepth")]:
            self.says(self.run_(*words, code=2), part)
        self.says(self.run_("--help"), "--particleDiameter", "1.7894e-05 unless given")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
