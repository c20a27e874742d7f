"""Reads the CSV tables that the project's tools write, and says clearly what a table lacks."""

import csv
import itertools


class Row(dict):
    """Cells by column; a column that the table lacks ends the program with its name."""

    def __init__(self, cells, path):
        super().__init__(cells)
        self.path = path

    def __missing__(self, column):
        raise SystemExit(f"{self.path}: has no column '{column}', only {', '.join(self)}; make it again with the tool as it is now")


def read(path):
    """The rows below the head line; lines that start with # are left out."""
    with open(path, encoding="utf-8", newline="") as file:
        lines = csv.reader(line for line in file if not line.startswith("#"))
        columns = next(lines, None)
        if columns is None:
            raise SystemExit(f"{path}: is empty")
        rows = []
        for number, cells in zip(itertools.count(2), lines):
            if len(cells) != len(columns):
                raise SystemExit(f"{path}: row {number} has {len(cells)} cells where the head has {len(columns)}")
            rows.append(Row(zip(columns, cells), path))
        return rows
