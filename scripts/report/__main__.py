"""Draws docs/report from the tables of echoway_report.

Usage: report --tables DIR --out DIR [--echoway PROGRAM] [--maps DIR] [--quick]
"""

import argparse
from pathlib import Path

import ablations
import cost
import lights
import match
import recovery
import robustness
import sensor_count
import single_room
import walks
import weights
from data import Tables
from published import SECONDS_A_MATCH
from style import table

SECTIONS = (match, single_room, sensor_count, weights, walks, lights, ablations, robustness, recovery, cost)

HEAD = """<!-- Written by `make report`; do not edit. -->
# Chapter 6 again

The experiments of the thesis's chapter 6, run afresh with its method and with Echoway's tracker, side by side; then what the thesis
could not try: what each part of the tracker buys, one nuisance at a time, recovery. `make report` runs all of it from seeds and writes
this page and its pictures; `make report QUICK=1` takes a quarter of the walks.{quick}

- **The world** is the simulator (`docs/simulator.md`), which shares no acoustics with either method. *Bare*: rooms without furniture and
  people; *furnished*: ordinary rooms with what no plan shows. Noise, drop-outs and the wearer's body are in both. The thesis
  measured in a real lab; its rooms are reconstructed from its text (`docs/formats.md`), so equal figures would be chance. What can be
  compared is which is worse, and by about how much.
- **The thesis's method** is `--method thesis` (`docs/thesis-method.md`); *as printed* takes equation (5.1) to the letter.
- **The tracker** is `docs/tracker.md`, *with steps and gyroscope* of a phone in the pocket, or by *echoes alone*.

Feet, as in the thesis. A match took the thesis {seconds:.0f} s; here a firing takes either method well under a millisecond.

## What the thesis found, and what happens here

{findings}
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--tables", required=True, type=Path)
    parser.add_argument("--out", required=True, type=Path)
    parser.add_argument("--echoway", default="build/bin/echoway")
    parser.add_argument("--maps", default="maps")
    parser.add_argument("--quick", action="store_true")
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    for old in arguments.out.glob("*.png"):
        old.unlink()
    tables = Tables(arguments.tables, arguments.echoway, arguments.maps)
    texts, findings = [], []
    for part in SECTIONS:
        text, found = part.section(tables, arguments.out)
        texts.append(text.strip() + "\n")
        findings += found
    rows = [[thesis, own, here, "yes" if holds else "**no**"] for thesis, own, here, holds in findings]
    head = HEAD.format(findings=table(["finding", "the thesis", "here", "holds"], rows, right=False), seconds=SECONDS_A_MATCH,
                       quick=" **This is a quick run.**" if arguments.quick else "")
    (arguments.out / "README.md").write_text(head + "\n" + "\n".join(texts), encoding="utf-8")


if __name__ == "__main__":
    main()
