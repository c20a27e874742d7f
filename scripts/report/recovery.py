"""How long until a wearer who was carried off is found again."""

import matplotlib.pyplot as plt
import numpy as np

from data import group, numbers
from style import METHODS, NAMES, legend_below, save, table

BUILDINGS = {"similar-rooms": "similar rooms (4 rooms)", "torgersen-lab": "the lab (7 rooms)", "office": "random offices (9 rooms)",
             "westport-house": "Westport House (7 levels)"}
SHOWN = ("thesis", "tracker without hints", "tracker")
LONGEST = 90.0


def draw(groups, out):
    figure, axes = plt.subplots(1, len(BUILDINGS), figsize=(13, 3.6), sharey=True)
    for panel, (building, title) in zip(axes, BUILDINGS.items()):
        for method in SHOWN:
            found = numbers(groups[building, method], "found_s")
            times = np.sort(found[(found >= 0) & (found <= LONGEST)])
            share = 100 * np.arange(1, len(times) + 1) / len(found)
            panel.step(np.r_[0, times, LONGEST], np.r_[0, share, share[-1] if len(share) else 0], where="post", **METHODS[method])
        panel.set_xlim(0, LONGEST)
        panel.set_ylim(0, 102)
        panel.set_title(title)
        panel.set_xlabel("seconds after being carried off")
    axes[0].set_ylabel("wearers found again, %")
    legend_below(figure, axes[0], 3)
    return save(figure, out, "recovery", "Share of wearers found again in time, by building")


def section(tables, out):
    groups = group(tables.rows("recovery"), "building", "method")
    rows = []
    for building, title in BUILDINGS.items():
        for method in SHOWN:
            found = numbers(groups[building, method], "found_s")
            times = np.where(found < 0, np.inf, found)
            median = np.sort(times)[len(times) // 2]
            rows.append([f"{title}: {NAMES[method]}", str(len(found)), *(f"{100 * np.mean(times <= s):.0f} %" for s in (10, 20, 40, 80)),
                         "-" if np.isinf(median) else f"{median:.0f} s"])
    every = {method: np.concatenate([numbers(groups[b, method], "found_s") for b in BUILDINGS]) for method in SHOWN}

    def within(method, seconds):
        return np.mean((every[method] >= 0) & (every[method] <= seconds))

    text = f"""
## Recovery

The wearer walks for 25 s, is carried blindfold to a random place of the building, facing anywhere, and walks on. Found again: the
right room and within a metre, for three seconds; the time is when that began. Furnished worlds.

{draw(groups, out)}

{table(["", "walks", "in 10 s", "20 s", "40 s", "80 s", "median"], rows)}

"Perhaps a more profound limitation is the system's inability to recover from a wrong match" (chapter 7). The thesis's method
looks only around its last match, so it finds the wearer again by luck alone. The tracker searches the building when the fit
fails; within 40 s it has found {100 * within("tracker", 40):.0f} % with steps and gyroscope and {100 * within("tracker without hints", 40):.0f} %
by echoes alone, of all buildings together.
"""
    return text, [("It cannot recover from a wrong match", "chapter 7",
                   f"found again: {100 * np.mean(every['thesis'] >= 0):.0f} % with the thesis's method, {100 * np.mean(every['tracker'] >= 0):.0f} % with the tracker",
                   np.mean(every["thesis"] >= 0) < 0.5)]
