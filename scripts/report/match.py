"""Figures 6.5 to 6.7."""

import matplotlib.pyplot as plt
import numpy as np

from data import feet, group, numbers
from pictures import draw_match, pose_of
from style import FEET, save, table


def draw_matches(tables, out):
    poses, readings = group(tables.rows("match-poses"), "figure"), group(tables.rows("match-readings"), "figure")
    figure, axes = plt.subplots(1, 2, figsize=(11, 5.6))
    for panel, name in zip(axes, ("6.5", "6.7")):
        room = poses[name][0]["room"]
        draw_match(panel, tables.room("torgersen-lab", room), poses[name], readings[name])
        best = next(row for row in poses[name] if row["kind"] == "best")
        panel.set_title(f"Figure {name}: match in room {room} (objective {float(best['objective_m']) / FEET:.2f} ft)")
    handles, labels = axes[1].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=len(labels))
    return save(figure, out, "match", "Real and simulated readings at the matched pose in rooms 1 and 5")


def draw_surfaces(tables, out):
    surface, poses = group(tables.rows("match-surface"), "figure", "variant"), group(tables.rows("match-poses"), "figure")
    figure, axes = plt.subplots(1, 2, figsize=(11, 4.8))
    for panel, name in zip(axes, ("6.5", "6.7")):
        rows = surface[name, "as printed"]
        x, y, value = feet(rows, "x_m"), feet(rows, "y_m"), feet(rows, "objective_m")
        columns, lines = np.unique(x.round(3)), np.unique(y.round(3))
        grid = np.full((len(lines), len(columns)), np.nan)
        grid[np.searchsorted(lines, y.round(3)), np.searchsorted(columns, x.round(3))] = value
        levels = np.linspace(0, np.nanpercentile(grid, 95), 16)
        filled = panel.contourf(columns, lines, grid, levels=levels, cmap="viridis_r", extend="max")
        figure.colorbar(filled, ax=panel, label="objective (5.1), ft")
        x, y, _ = pose_of(next(row for row in poses[name] if row["kind"] == "true"))
        panel.plot(x, y, "*", color="white", mec="black", ms=13, label="true position")
        i, j = np.unravel_index(np.nanargmin(grid), grid.shape)
        panel.plot(columns[j], lines[i], "x", color="#d55e00", ms=8, mew=2, label="lowest")
        panel.set_aspect("equal")
        panel.set_xlabel("x, ft")
        panel.set_ylabel("y, ft")
        panel.grid(False)
        room = poses[name][0]["room"]
        panel.set_title(f"{'Figure 6.6' if name == '6.5' else 'The same'} in room {room}: error over the floor")
        panel.legend(loc="upper right", labelcolor="black", frameon=True)
    return save(figure, out, "error-surface", "Objective over the floor of rooms 1 and 5 at the true heading")


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

The thesis shows one valley and one minimum. Over many places it depends on what stands about. One minimum: no other one
farther than 2 ft away that rises above the lowest by less than a quarter of what the median point does; "within 5 ft" looks
only where the method looks.

{table(["world", "places", "one minimum in the room", "one within 5 ft", "lowest, ft off (median)", "lowest within 5 ft"], rows)}

Thesis and ours agree in bare rooms. In the furnished ones, most of all in room 5 where furniture takes up much of the floor, a
pose that happens to make four readings fit rivals the true one: equation (5.1) divides by the number of readings that have a
partner, so few good partners beat many fair ones.
"""
    return text, [("The error surface has one minimum", "shown for one place in a small room",
                   f"within the method's bounds at {100 * bare:.0f} % of places in bare rooms, {100 * furnished:.0f} % in furnished ones",
                   bare > 0.8)]
