# SPDX-License-Identifier: GPL-3.0-or-later
"""How the pictures of the cases look, and where they lie."""
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

ink, blue, red, green, grey = "#22303c", "#2166ac", "#b2182b", "#1b7837", "0.45"
mm = 1e3
plt.rcParams.update({"font.size": 10, "axes.edgecolor": ink, "axes.labelcolor": ink,
                     "axes.spines.top": False, "axes.spines.right": False, "text.color": ink,
                     "xtick.color": ink, "ytick.color": ink, "savefig.dpi": 160})


def save(fig, folder, name):
    """As pictures/name in the folder of a run, and says so."""
    (folder/"pictures").mkdir(exist_ok=True)
    fig.savefig(folder/"pictures"/name)
    plt.close(fig)
    print(f"picture: pictures/{name}")
