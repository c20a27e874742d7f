"""Puts into docs/leaving-out.md what a run measured: leaving_out.py BENCHMARK.json ECHOWAY PAGE.md

The page keeps its own words; what stands between its marker lines is written anew."""

import json
import subprocess
import sys
from pathlib import Path

import machine
import pages

MAPS = ("sample-room", "two-rooms", "torgersen-lab", "similar-rooms", "westport-house")
IN_FULL = "torgersen-lab"
TARGET = "leaving-out"


def left_out(echoway, name):
    """The lines that `echoway describe --left-out` prints."""
    command = [echoway, "describe", f"maps/{name}", "--left-out"]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()


def medians(report):
    """Nanoseconds an expectation by benchmark; the median of its repetitions."""
    rows = json.loads(Path(report).read_text(encoding="utf-8"))["benchmarks"]
    return {row["run_name"]: 1e9 * row["s_per_expectation"] for row in rows if row.get("aggregate_name") == "median"}


def times(report):
    table = ["| building | whole room | places, lists made as they come | | places, lists known | |", "|---|--:|--:|--:|--:|--:|"]
    nanoseconds = medians(report)
    for name in MAPS:
        room, comes, stays = (nanoseconds[f"left_out/{kind}/{name}"] for kind in ("room", "comes", "stays"))
        table.append(f"| `maps/{name}` | {room:.0f} ns | {comes:.0f} ns | {room / comes:.1f} times as fast | {stays:.0f} ns | {room / stays:.1f} times as fast |")
    return table + ["", f"Processor time on {machine.name()}."]


def block(lines):
    return ["```", *lines, "```"]


def summaries(echoway):
    text = []
    for name in MAPS:
        lines = left_out(echoway, name)
        first = next(i for i, line in enumerate(lines) if line.startswith("Left out altogether"))
        text += [f"`maps/{name}`:", "", *block(lines[first:]), ""]
    return text[:-1]


def main():
    report, echoway, path = sys.argv[1:]
    page = Path(path)
    text = page.read_text(encoding="utf-8")
    text = pages.put(text, "table", TARGET, block(left_out(echoway, IN_FULL)))
    text = pages.put(text, "times", TARGET, times(report))
    text = pages.put(text, "summaries", TARGET, summaries(echoway))
    page.write_text(text, encoding="utf-8")


main()
