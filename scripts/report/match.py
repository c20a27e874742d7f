"""Figures 6.5 to 6.7."""

import matplotlib.pyplot as plt
import numpy as np

from data import feet, group, numbers
from pictures import draw_match, pose_of
from style import FEET, legend_below, save, table


PLANS = {"6.5": ("torgersen-lab", "1", "room 1"), "6.7": ("sample-room", "sample", "the 19 by 22 ft room")}


def draw_matches(tables, out):
    poses, readings = group(tables.rows("match-poses"), "figure"), group(tables.rows("match-readings"), "figure")
    figure, axes = plt.subplots(1, 2, figsize=(11, 6.2))
    for panel, (name, (plan, room, title)) in zip(axes, PLANS.items()):
        draw_match(panel, tables.room(plan, room), poses[name], readings[name])
        best = next(row for row in poses[name] if row["kind"] == "best")
        panel.set_title(f"Figure {name}: {title}, objective {float(best['objective_m']) / FEET:.2f} ft")
    legend_below(figure, axes[1], 6)
    return save(figure, out, "match", "Real and simulated readings at the matched pose in two rooms")


def draw_surface(figure, panel, rows, truth, levels):
    x, y, value = feet(rows, "x_m"), feet(rows, "y_m"), feet(rows, "objective_m")
    columns, lines = np.unique(x.round(3)), np.unique(y.round(3))
    grid = np.full((len(lines), len(columns)), np.nan)
    grid[np.searchsorted(lines, y.round(3)), np.searchsorted(columns, x.round(3))] = value
    filled = panel.contourf(columns, lines, grid, levels=levels, cmap="viridis_r", extend="max")
    panel.plot(*truth[:2], "*", color="white", mec="black", ms=13, label="true position")
    i, j = np.unravel_index(np.nanargmin(grid), grid.shape)
    panel.plot(columns[j], lines[i], "x", color="#d55e00", ms=8, mew=2, label="lowest")
    panel.set_aspect("equal")
    panel.set_xlabel("x, ft")
    panel.set_ylabel("y, ft")
    panel.grid(False)
    return filled


def draw_surfaces(tables, out):
    surface, poses = group(tables.rows("match-surface"), "figure", "world"), group(tables.rows("match-poses"), "figure")
    figure, axes = plt.subplots(1, 4, figsize=(15, 4.6), width_ratios=[13, 13, 19, 19])
    levels = np.arange(0.0, 8.01, 0.5)
    for panel, (name, world) in zip(axes, [(n, w) for n in PLANS for w in ("bare", "furnished")]):
        truth = pose_of(next(row for row in poses[name] if row["kind"] == "true"))
        filled = draw_surface(figure, panel, surface[name, world], truth, levels)
        panel.set_title(f"{'Figure 6.6: room 1' if name == '6.5' else '19 by 22 ft room'}, {world}")
    figure.colorbar(filled, ax=axes, label="objective (5.1), ft", ticks=range(0, 9), shrink=0.85)
    legend_below(figure, axes[0], 2)
    return save(figure, out, "error-surface", "Objective over the floor of two rooms at the true heading, bare and furnished")


def section(tables, out):
    matches, surfaces = draw_matches(tables, out), draw_surfaces(tables, out)
    rows = []
    share = {}
    for (world, room), places in sorted(group([r for r in tables.rows("match-places") if r["variant"] == "as printed"],
                                              "world", "room").items()):
        alone = numbers(places, "rivals") == 0
        near = numbers(places, "rivals_near") == 0
        share[world, room] = near.mean()
        rows.append([f"{world}, room {room}", str(len(places)), f"{100 * alone.mean():.0f} %", f"{100 * near.mean():.0f} %",
                     f"{np.median(feet(places, 'lowest_error_m')):.2f}", f"{np.median(feet(places, 'lowest_error_near_m')):.2f}"])
    bare = np.mean([value for (world, _), value in share.items() if world == "bare"])
    furnished = np.mean([value for (world, _), value in share.items() if world == "furnished"])
    text = f"""
## A match, and the error over the floor (figures 6.5 to 6.7)

{matches}

Diamonds are what the belt read (two passes, averaged), squares and circles what the plan says it would read at the matched
pose. Diamonds without a partner are furniture that no plan knows, as the shelves in the thesis's corners.

{surfaces}

White: fewer than four readings to compare, which the method discards. The thesis shows one valley and one minimum. Over
many places it depends on what stands about. One minimum: no other one farther than 2 ft away that rises above the lowest by
less than a quarter of what the median point does; "within 5 ft" looks
only where the method looks.

{table(["world", "places", "one minimum in the room", "one within 5 ft", "lowest, ft off (median)", "lowest within 5 ft"], rows)}

Thesis and ours agree in bare rooms. In the furnished ones, most of all in room 5 where furniture takes up much of the floor, a
pose that happens to make four readings fit rivals the true one: equation (5.1) divides by the number of readings that have a
partner, so few good partners beat many fair ones.
"""
    return text, [("The error surface has one minimum", "shown for one place in a small room",
                   f"within the method's bounds at {100 * bare:.0f} % of places in bare rooms, {100 * furnished:.0f} % in furnished ones",
                   bare > 0.75)]
