"""What a run of the report takes."""

from data import numbers
from style import table

NAMES = {"match": "match and error surface", "single-room": "six rooms", "sensor-count": "how many sensors", "weights": "weight of walls",
         "walks": "walks from room to room", "lights": "fluorescent lights", "ablations": "what each part of the tracker buys",
         "robustness": "one nuisance at a time", "recovery": "recovery"}


def section(tables, out):
    rows = tables.rows("times")
    wall, processor = numbers(rows, "wall_s"), numbers(rows, "processor_s")
    lines = [[NAMES[row["experiment"]], f"{w:.0f} s", f"{p:.0f} s", f"{100 * p / processor.sum():.0f} %"]
             for row, w, p in zip(rows, wall, processor)]
    lines.append(["all", f"{wall.sum() / 60:.1f} min", f"{processor.sum() / 60:.1f} min", ""])
    text = f"""
## What this run took

{table(["experiment", "by the clock", "of processors", "share"], lines)}

On two cores with nothing else to do the clock shows little more than half of what the processors do.
"""
    return text, []
