"""Reads the tables that echoway_report leaves."""

import json
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

import numpy as np

from style import FEET

sys.path.append(str(Path(__file__).resolve().parents[1]))
import tables  # noqa: E402


class Tables:
    def __init__(self, folder, echoway, maps):
        self.folder, self.echoway, self.maps = Path(folder), echoway, Path(maps)

    def rows(self, name):
        return tables.read(self.folder / f"{name}.csv")

    def room(self, building, room):
        """A room's walls and all-reflective lines in its own frame, feet."""
        text = subprocess.run([self.echoway, "describe", self.maps / building], check=True, capture_output=True, text=True)
        found = next(r for r in json.loads(text.stdout)["rooms"] if r["id"] == room)
        x, y, turn = found["frame"]
        back = np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
        place = {kind: [(back @ (np.array(line).T - [[x], [y]])).T / FEET for line in found[kind]]
                 for kind in ("walls", "reflectors")}
        place["doors"] = []
        return place


def group(rows, *keys):
    groups = defaultdict(list)
    for row in rows:
        groups[tuple(row[key] for key in keys) if len(keys) > 1 else row[keys[0]]].append(row)
    return groups


def feet(rows, column="error_m"):
    return np.array([float(row[column]) for row in rows]) / FEET


def numbers(rows, column):
    return np.array([float(row[column]) for row in rows])
