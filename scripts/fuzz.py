"""Runs the libFuzzer targets one after the other and adds what they did to docs/fuzzing.md.

Usage: fuzz.py --build DIR --core DIR --page FILE --seconds N [TARGET ...]
"""

import argparse
import os
import re
import resource
import subprocess
import sys
from pathlib import Path

# One input: 256 MB, and 1 s of an ordinary build, which the sanitizers make ten.
LIMITS = ["-timeout=10", "-malloc_limit_mb=256", "-rss_limit_mb=768"]
# Cheap inputs first; a quarantine of ordinary size and watching stacks after their return cost a quarter of the time.
EFFORT = ["-entropic_scale_per_exec_time=1"]
SANITIZERS = "quarantine_size_mb=16:detect_stack_use_after_return=0"
HEAD = """# Fuzzing

Written by `make fuzz`, which adds to it; `make fuzz FUZZ="session tracker" SECONDS=600` picks targets and how long. Every target
(core-native/fuzz/targets) takes any bytes and checks what it promises: no crash, no hang over a second, no allocation over 256 MB, nothing
that is not finite; under the address and undefined-behaviour sanitizers. An input may be refused. The tests replay each target's corpus
and every input that once broke a promise (core-native/fuzz/regressions).

Counts add up over all runs, whatever the code was at the time.

| target | executions | processor hours | a second | inputs that once broke something |
|---|--:|--:|--:|--:|
"""
ROW = re.compile(r"\| (\w+) \| ([\d,]+) \| ([\d.]+) \|")


def known(page):
    """Executions and hours by target, as the page has them."""
    rows = (ROW.match(line) for line in page.read_text(encoding="utf-8").splitlines()) if page.exists() else ()
    return {row[1]: (int(row[2].replace(",", "")), float(row[3])) for row in rows if row}


def write(page, totals, core):
    lines = []
    for target, (executions, hours) in sorted(totals.items()):
        broken = core / "fuzz" / "regressions" / target
        count = len(list(broken.iterdir())) if broken.is_dir() else 0
        rate = executions / (3600 * hours) if hours > 0 else 0
        lines.append(f"| {target} | {executions:,} | {hours:.3f} | {rate:,.0f} | {count} |\n")
    page.write_text(HEAD + "".join(lines), encoding="utf-8")


def run(target, arguments):
    """Returns executions, processor hours and whether the target came through."""
    found = arguments.build / "found" / target
    found.mkdir(parents=True, exist_ok=True)
    inputs = [arguments.core / "fuzz" / kind / target for kind in ("corpus", "regressions")]
    words = arguments.core / "fuzz" / "dictionaries" / f"{target}.dict"
    dictionary = [f"-dict={words}"] if words.exists() else []
    command = [arguments.build / "fuzz" / f"fuzz_{target}", f"-max_total_time={arguments.seconds}", *LIMITS, *EFFORT, *dictionary,
               "-print_final_stats=1", "-verbosity=0", f"-artifact_prefix={arguments.build}/{target}-", found,
               *(path for path in inputs if path.is_dir())]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    environment = os.environ | {"TMPDIR": "/dev/shm", "ASAN_OPTIONS": SANITIZERS}
    process = subprocess.run(["nice", *map(str, command)], stderr=subprocess.PIPE, text=True, errors="replace", env=environment, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    executions = re.search(r"number_of_executed_units: (\d+)", process.stderr)
    if process.returncode != 0:
        print(process.stderr[-6000:])
    hours = (after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime) / 3600
    return int(executions[1]) if executions else 0, hours, process.returncode == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", required=True, type=Path)
    parser.add_argument("--core", required=True, type=Path)
    parser.add_argument("--page", required=True, type=Path)
    parser.add_argument("--seconds", required=True, type=int)
    parser.add_argument("targets", nargs="+")
    arguments = parser.parse_args()
    broken = []
    for target in arguments.targets:
        print(f"{target} ...", end=" ", flush=True)
        executions, hours, held = run(target, arguments)
        print(f"{executions:,} executions, {60 * hours:.1f} processor minutes" + ("" if held else "; BROKEN"), flush=True)
        totals = known(arguments.page)
        before = totals.get(target, (0, 0.0))
        write(arguments.page, totals | {target: (before[0] + executions, before[1] + hours)}, arguments.core)
        if not held:
            broken.append(target)
    if broken:
        sys.exit(f"fuzz: {', '.join(broken)} broke a promise; the input is in {arguments.build}")


if __name__ == "__main__":
    main()
