"""Compares the simulated world with measurements and with computed waveforms, and writes docs/simulator-validation.md
and its picture.

Usage: validate_simulator.py [--echoway PROGRAM] [--tests PROGRAM] [--out FOLDER]
"""

import argparse
import json
import math
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

ROOT = Path(__file__).resolve().parent.parent
DATA = ROOT / "core-native/test/data"
CORRIDOR_MAP = DATA / "sonar-corridor/traced-map"
CORRIDOR_BEARINGS = [-90.0, -37.5, -22.5, -7.5, 7.5, 22.5, 37.5, 90.0]
CORRIDOR_LIMIT = 5.0  # Metres; both robots call everything beyond "no echo".
RING_LIMIT = 5.0
NEAR_WALL = 0.25  # A reading this near to the wall along the axis is "at the wall", metres.
JUMP = 0.3  # Metres between successive readings of one sensor.
INCIDENCE = [(0, 5), (5, 10), (10, 15), (15, 25), (25, 40), (40, 55), (55, 70), (70, 90)]
DEFAULT_SEEDS = range(1, 9)
DRAWN_SEEDS = range(101, 117)
# A robot has no arms, and nobody walked about.
# The ring's own kind of sensor: a small disc at 40 kHz, whose beam is several times as wide as the belt's. Disc, air and noise
# are those of common modules; the margin is set so that the share of missing echoes is right.
RING_SENSOR = ["--world", "frequency_khz=40", "--world", "transducer_radius_mm=6.5", "--world", "absorption_db_per_m=1.2",
               "--world", "range_noise=0.002", "--world", "timer_tick_us=17.5", "--world", "plane_margin_db=20"]
RING_SPEED = 0.1  # Metres a second: four rounds in the ten minutes of the whole recording.
BARE = ["--world", "furniture_per_m2=0", "--world", "posts_per_m2=0"]
ROBOT = ["--world", "arms=0", "--world", "people_per_100m2=0"]


@dataclass
class Pose:
    time: float
    x: float
    y: float
    heading: float


def simulate(echoway, building, room, poses, bearings, radius, limit, seed, drawn=False, more=()):
    """Ranges of one scan at each pose, rows by pose, NaN where there is no echo."""
    with tempfile.TemporaryDirectory() as folder:
        at = Path(folder) / "at.csv"
        with open(at, "w", encoding="utf-8") as file:
            file.write("time_s,room,x_m,y_m,heading_deg\n")
            file.writelines(f"{p.time:.3f},{room},{p.x:.4f},{p.y:.4f},{p.heading:.3f}\n" for p in poses)
        command = [echoway, "simulate", "--building", building, "--at", at, "--radius", str(radius), "--seed", str(seed),
                   "--bearings", ",".join(map(str, bearings)), "--out", Path(folder) / "scan", *ROBOT, *more]
        subprocess.run(command + (["--draw-world"] if drawn else []), check=True)
        lines = (Path(folder) / "scan.scans.csv").read_text(encoding="utf-8").splitlines()
    cells = [line.split(",")[2] for line in lines if line[:1].isdigit()]
    ranges = np.array([float(cell) if cell else np.nan for cell in cells]).reshape(len(poses), len(bearings))
    ranges[ranges >= limit] = np.nan
    return ranges


def share(mask):
    return float(np.mean(mask)) if np.size(mask) else math.nan


def jumps(ranges):
    """Of successive readings of a sensor: share that jump, share that come or go, median difference."""
    before, after = ranges[:-1], ranges[1:]
    both = ~np.isnan(before) & ~np.isnan(after)
    step = np.abs(after - before)[both]
    return {
        "jump": share(step > JUMP),
        "toggle": share(np.isnan(before) != np.isnan(after)),
        "same": share(step == 0.0),
        "scatter": float(np.median(step)),
    }


# The corridor.


def read_corridor():
    ranges = np.loadtxt(DATA / "sonar-corridor/measurement.txt")
    track = np.loadtxt(DATA / "sonar-corridor/poses.txt")
    moved = np.r_[True, np.abs(np.diff(track[:, 1:], axis=0)).sum(axis=1) > 0]  # Standing still repeats readings.
    poses = [Pose((row[0] - track[0, 0]) / 1e3, row[1] / 1e3, row[2] / 1e3, row[3] / 10) for row in track[moved]]
    measured = ranges[moved, 1:] / 1e3
    measured[measured >= CORRIDOR_LIMIT] = np.nan
    return poses, measured


def read_walls(folder, shortest):
    walls = []
    for file in folder.glob("room-*.room"):
        for line in file.read_text(encoding="utf-8").splitlines():
            words = line.split("#")[0].split()
            if len(words) == 5 and words[0] == "1":
                ax, ay, bx, by = map(float, words[1:])
                if math.hypot(bx - ax, by - ay) >= shortest:
                    walls.append((ax, ay, bx, by))
    return np.array(walls)


def cast(walls, x, y, angle):
    """Distance to the wall that the axis meets, and the angle of incidence in degrees."""
    ax, ay, bx, by = walls.T
    dx, dy = math.cos(angle), math.sin(angle)
    ex, ey = bx - ax, by - ay
    denominator = dx * ey - dy * ex
    with np.errstate(divide="ignore", invalid="ignore"):
        t = ((ax - x) * ey - (ay - y) * ex) / denominator
        u = ((ax - x) * dy - (ay - y) * dx) / denominator
    t[~((t > 0) & (u >= 0) & (u <= 1))] = np.inf
    hit = int(np.argmin(t))
    along = abs(dx * ex[hit] + dy * ey[hit]) / math.hypot(ex[hit], ey[hit])
    return t[hit], math.degrees(math.asin(min(1.0, along)))


def corridor_geometry(poses):
    walls = read_walls(CORRIDOR_MAP, shortest=0.3)
    return np.array([[cast(walls, p.x, p.y, math.radians(p.heading + b)) for b in CORRIDOR_BEARINGS] for p in poses])


def corridor_statistics(ranges, geometry):
    wall, incidence = geometry[..., 0], geometry[..., 1]
    rows = []
    for low, high in INCIDENCE:
        chosen = (incidence >= low) & (incidence < high) & (wall < CORRIDOR_LIMIT - NEAR_WALL)
        reading, truth = ranges[chosen], wall[chosen]
        rows.append([
            share(np.isnan(reading)),
            share(reading < truth - NEAR_WALL),
            share(np.abs(reading - truth) <= NEAR_WALL),
            share(reading > truth + NEAR_WALL),
        ])
    return np.array(rows), {"missing": share(np.isnan(ranges)), **jumps(ranges)}


def draw_corridor(poses, measured, simulated, file):
    walls = read_walls(CORRIDOR_MAP, shortest=0.0)
    figure, panels = plt.subplots(1, 2, figsize=(15, 9), sharex=True, sharey=True, layout="constrained")
    for panel, ranges, title in zip(panels, (measured, simulated), ("measured", "simulated"), strict=True):
        panel.plot(walls[:, [0, 2]].T, walls[:, [1, 3]].T, color="0.6", lw=1)
        panel.plot([p.x for p in poses], [p.y for p in poses], color="#0072b2", lw=1.5)
        angle = np.radians(np.array([p.heading for p in poses])[:, None] + np.array(CORRIDOR_BEARINGS))
        x = np.array([p.x for p in poses])[:, None] + ranges * np.cos(angle)
        y = np.array([p.y for p in poses])[:, None] + ranges * np.sin(angle)
        panel.plot(x.ravel(), y.ravel(), ".", color="#d55e00", ms=3)
        panel.set_title(title)
        panel.set_xlabel("x, m")
        panel.set_aspect("equal")
    panels[0].set_ylabel("y, m")
    figure.savefig(file, dpi=80)


# The ring.


def read_ring():
    ranges = np.loadtxt(DATA / "ultrasound-ring/first-1000-scans.csv", delimiter=",", skiprows=1)
    ranges[ranges >= RING_LIMIT] = np.nan
    return ranges


def wall_following(width, height, off, speed, rate, count):
    """A robot that goes round a room at a fixed distance from its walls, corners rounded."""
    radius = 0.5
    x0, y0, x1, y1 = off, off, width - off, height - off
    outline = []
    for (cx, cy), first in (((x1 - radius, y0 + radius), -90), ((x1 - radius, y1 - radius), 0),
                            ((x0 + radius, y1 - radius), 90), ((x0 + radius, y0 + radius), 180)):
        for angle in np.radians(np.linspace(first, first + 90, 16)):
            outline.append((cx + radius * math.cos(angle), cy + radius * math.sin(angle)))
    outline = np.array(outline + outline[:1])
    arc = np.r_[0, np.cumsum(np.hypot(*np.diff(outline, axis=0).T))]
    s = (np.arange(count) * speed / rate) % arc[-1]
    x, y = np.interp(s, arc, outline[:, 0]), np.interp(s, arc, outline[:, 1])
    ahead = (s + 0.05) % arc[-1]
    heading = np.degrees(np.arctan2(np.interp(ahead, arc, outline[:, 1]) - y, np.interp(ahead, arc, outline[:, 0]) - x))
    return [Pose(i / rate, x[i], y[i], heading[i]) for i in range(count)]


def write_box_room(folder, width, height):
    (folder / "building.cfg").write_text("units m\n", encoding="utf-8")
    corners = [(0, 0), (width, 0), (width, height), (0, height)]
    lines = ["4 0 0"] + [f"1 {a[0]} {a[1]} {b[0]} {b[1]}" for a, b in zip(corners, corners[1:] + corners[:1], strict=True)]
    (folder / "room-box.room").write_text("\n".join(lines) + "\n", encoding="utf-8")


def ring_statistics(ranges):
    return {"missing": share(np.isnan(ranges)), **jumps(ranges), "near": share(ranges[~np.isnan(ranges)] < 1.0)}


def simulate_ring(echoway, seeds, drawn, more=()):
    results = []
    for seed in seeds:
        size = np.random.default_rng(seed).uniform([4.5, 3.5], [7.5, 6.0])
        with tempfile.TemporaryDirectory() as folder:
            write_box_room(Path(folder), *size)
            poses = wall_following(*size, off=0.75, speed=RING_SPEED, rate=9.0, count=1000)
            bearings = [15.0 * i for i in range(24)]
            ranges = simulate(echoway, folder, "box", poses, bearings, 0.3, RING_LIMIT, seed, drawn, more)
        results.append(ring_statistics(ranges))
    return results


# Computed waveforms.


def waveform_agreement(tests):
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.json"
        subprocess.run([tests, "--gtest_filter=*AgainstWaveforms*", f"--gtest_output=json:{report}"], check=True,
                       stdout=subprocess.DEVNULL)
        suites = json.loads(report.read_text(encoding="utf-8"))["testsuites"]
    rows = {}
    for suite in suites:
        for test in suite["testsuite"]:
            row = rows.setdefault(test["value_param"], {})
            row.update({key: float(value) for key, value in test.items() if key.startswith("measured_")})
    return rows


# The page.


def percent(value):
    return "-" if math.isnan(value) else f"{100 * value:.0f}"


def spread(values):
    values = np.array(values)
    return f"{percent(np.percentile(values, 10))} to {percent(np.percentile(values, 90))}"


def corridor_table(measured, default, drawn):
    lines = ["| incidence, degrees | readings | | none | short | at the wall | beyond |", "|---|---|---|---|---|---|---|"]
    for i, (low, high) in enumerate(INCIDENCE):
        count = measured["counts"][i]
        lines.append(f"| {low}-{high} | {count} | measured | " + " | ".join(percent(v) for v in measured["rows"][i]) + " |")
        mean = np.mean([rows[i] for rows in default], axis=0)
        lines.append("| | | simulated | " + " | ".join(percent(v) for v in mean) + " |")
        drawn_cells = [spread([rows[i][k] for rows in drawn]) for k in range(4)]
        lines.append("| | | drawn worlds | " + " | ".join(drawn_cells) + " |")
    return "\n".join(lines)


def summary_table(names, measured, default, drawn, own=None):
    heads = ["measured", "simulated", "drawn worlds"] + (["ring's own sensor"] if own else [])
    lines = ["| | " + " | ".join(heads) + " |", "|---" * (len(heads) + 1) + "|"]
    for key, (name, unit) in names.items():
        scale = 1e3 if unit == "mm" else 1e2

        def shown(value, scale=scale):
            return f"{scale * value:.0f}"

        def mean(runs, key=key):
            return np.mean([run[key] for run in runs])

        low, high = np.percentile([run[key] for run in drawn], [10, 90])
        cells = [shown(measured[key]), shown(mean(default)), f"{shown(low)} to {shown(high)}"]
        if own:
            cells.append(shown(mean(own)))
        lines.append(f"| {name}, {unit} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


SUMMARY = {
    "missing": ("readings without an echo", "%"),
    "jump": (f"successive readings of a sensor more than {JUMP} m apart", "%"),
    "toggle": ("successive readings of which one is missing", "%"),
    "same": ("successive readings that are equal", "%"),
    "scatter": ("median difference of successive readings", "mm"),
}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--echoway", default=ROOT / "build/bin/echoway")
    parser.add_argument("--tests", default=ROOT / "build/bin/echoway_tests")
    parser.add_argument("--out", type=Path, default=ROOT / "docs")
    options = parser.parse_args()

    poses, measured = read_corridor()
    geometry = corridor_geometry(poses)
    rows, totals = corridor_statistics(measured, geometry)
    wall, incidence = geometry[..., 0], geometry[..., 1]
    counts = [int(((incidence >= a) & (incidence < b) & (wall < CORRIDOR_LIMIT - NEAR_WALL)).sum()) for a, b in INCIDENCE]

    def corridor(seed, drawn):
        return simulate(options.echoway, CORRIDOR_MAP, "corridor", poses, CORRIDOR_BEARINGS, 0.0, CORRIDOR_LIMIT, seed,
                        drawn, BARE)

    scans = [corridor(seed, False) for seed in DEFAULT_SEEDS]
    default = [corridor_statistics(scan, geometry) for scan in scans]
    drawn = [corridor_statistics(corridor(seed, True), geometry) for seed in DRAWN_SEEDS]
    draw_corridor(poses, measured, scans[0], options.out / "simulator-validation.png")
    apart = np.abs(np.mean([d[0] for d in default], axis=0) - rows)

    ring = ring_statistics(read_ring())
    ring_default = simulate_ring(options.echoway, DEFAULT_SEEDS, False)
    ring_drawn = simulate_ring(options.echoway, DRAWN_SEEDS, True)
    ring_own = simulate_ring(options.echoway, DEFAULT_SEEDS, False, RING_SENSOR)

    waveforms = waveform_agreement(options.tests)
    waveform_lines = ["| disc and margin | half-angle, computed | simulated | farthest apart in range, mm |", "|---|---|---|---|"]
    for case, row in waveforms.items():
        waveform_lines.append(f"| {case} | {row['measured_computed_deg']:.1f} | {row['measured_simulated_deg']:.1f} | "
                              f"{row['measured_range_mm']:.0f} |")

    template = (ROOT / "scripts/simulator-validation.md.in").read_text(encoding="utf-8")
    page = template.format(
        corridor_table=corridor_table({"rows": rows, "counts": counts}, [d[0] for d in default], [d[0] for d in drawn]),
        corridor_apart=f"{100 * apart.mean():.0f}",
        corridor_worst=f"{100 * apart.max():.0f}",
        corridor_summary=summary_table(SUMMARY, totals, [d[1] for d in default], [d[1] for d in drawn]),
        ring_summary=summary_table({**SUMMARY, "near": ("echoes nearer than 1 m", "%")}, ring, ring_default, ring_drawn,
                                   ring_own),
        waveform_table="\n".join(waveform_lines),
        default_seeds=len(DEFAULT_SEEDS),
        drawn_seeds=len(DRAWN_SEEDS),
    )
    (options.out / "simulator-validation.md").write_text(page, encoding="utf-8")


if __name__ == "__main__":
    main()
