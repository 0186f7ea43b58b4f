#!/usr/bin/env python3
"""Measures how time, memory and bytes read grow with the sides of map and picture, and with threads and ranks.

    tests/benchmarks/sizes.py [--build build] [--chart FILE.svg] [--largest-map N] [--largest-picture N]

Prints the tables and the fitted laws as Markdown and draws the chart. A map is held in memory up to 16,384 texels a
side, and read by tiles within 1,024 MB from 1,024 a side. Times are processor seconds of all threads, which other
programs on the machine change little. Pictures are medians of three rounds, of a single one from 8,192 a side. A warm
frame has 800 x 600 pixels and is one of eight after the first two, at 16,384 a side of 40; the least of as many
rounds. Needs 21 GB of disk below --work for a map of 65,536,
17 GB of memory for a picture of 32,768 (reports are of pictures in one piece), and about an hour; nothing else should
run meanwhile.
"""
import argparse
import json
import math
import os
import pathlib
import shutil
import statistics
import subprocess
import tempfile

BOUND_MB = 1024  # of maps that are read by tiles
LARGEST_IN_MEMORY = 16384
SMALLEST_BY_TILES = 1024
VIEW = ["--camera", "elevation=30,azimuth=25,distance=1.2,fov=40", "--tracer", "max-pyramid", "--filter", "trilinear"]


def run(command):
    """Runs a command and returns its seconds, processor seconds and peak of memory in MB."""
    started = os.times().elapsed
    with subprocess.Popen(command, stdout=subprocess.DEVNULL) as process:
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise SystemExit(f"{' '.join(map(str, command))}: exit status {process.returncode}")
    return {
        "seconds": os.times().elapsed - started,
        "processor": usage.ru_utime + usage.ru_stime,
        "memory": usage.ru_maxrss / 1024,
    }


class Measurement:
    def __init__(self, options):
        self.relief = str(pathlib.Path(options.build) / "bin" / "relief")
        self.folder = pathlib.Path(options.work)

    def render(self, side, *arguments, threads=2, ranks=1):
        """Medians over the rounds of one rendering, with what its report says."""
        rounds = 3 if side < 8192 else 1
        results = []
        for _ in range(rounds):
            report = self.folder / "report.json"
            command = [self.relief, "render", *map(str, arguments), *VIEW, "--threads", str(threads),
                       "-o", str(self.folder / "picture.tif"), "-q"]
            if ranks > 1:  # several processes write no report
                launcher = ["mpirun", "--oversubscribe", "--allow-run-as-root", "--bind-to", "none", "-n", str(ranks)]
                results.append(run([*launcher, *command]))
                continue
            result = run([*command, "--report", str(report)])
            said = json.loads(report.read_text())
            result["load"] = said["seconds"]["load"]
            result["render"] = said["seconds"]["render"]
            counters = said["counters"]
            result["steps"] = counters["steps"] / max(1, counters["rays traced"])
            if "tiles" in said:
                result["read"] = said["tiles"]["bytes"] / 1e6
            results.append(result)
        (self.folder / "picture.tif").unlink()
        return {name: statistics.median(one[name] for one in results) for name in results[0]}

    def warm(self, side, *arguments):
        """Processor seconds of a frame after the first two, without opening the map."""
        rounds = 3 if side < 8192 else 1
        # Opening a large map in memory takes so long that its noise would be several frames.
        frames = 40 if side == LARGEST_IN_MEMORY else 8
        def path(count):
            folder = self.folder / "frames"
            taken = run([self.relief, "render", *map(str, arguments), *VIEW, "--size", "800x600", "--to", "azimuth=25.1",
                         "--frames", str(count), "-o", str(folder), "-q"])
            shutil.rmtree(folder)
            return taken["processor"]
        least = [min(path(count) for _ in range(rounds)) for count in (2, frames + 2)]
        return (least[1] - least[0]) / frames

    def maps(self, largest):
        side = 256
        heights = self.folder / "map.tif"
        while side <= largest:
            made = run([self.relief, "make", "fractal", "--size", str(side), "--tiled", "-o", str(heights), "-q"])
            row = {"side": side, "file": heights.stat().st_size / 1e6, "make": made["seconds"],
                   "make memory": made["memory"]}
            if side <= LARGEST_IN_MEMORY:
                held = self.render(side, heights, "--size", "800x600")
                yield {**row, "held": "in memory", **held, "warm": self.warm(side, heights)}
            if side >= SMALLEST_BY_TILES:
                bound = ("--memory", BOUND_MB)
                held = self.render(side, heights, *bound, "--size", "800x600")
                yield {**row, "held": "by tiles", **held, "warm": self.warm(side, heights, *bound)}
            heights.unlink()
            side *= 2

    def pictures(self, largest):
        side = 256
        while side <= largest:
            row = self.render(side, "--relief", "hills:1024", "--size", str(side))
            yield {"side": side, **row}
            side *= 2

    def shares(self):
        for threads, ranks in ((1, 1), (2, 1), (1, 2), (1, 4)):
            row = self.render(2048, "--relief", "hills:1024", "--size", "2048", threads=threads, ranks=ranks)
            yield {"threads": threads, "ranks": ranks, **row}


def line_through(points):
    """Least squares: slope, intercept and the share of the variance that the line explains."""
    xs, ys = zip(*points)
    mean_x, mean_y = statistics.fmean(xs), statistics.fmean(ys)
    across = sum((x - mean_x) ** 2 for x in xs)
    slope = sum((x - mean_x) * (y - mean_y) for x, y in points) / across
    spread = sum((y - mean_y) ** 2 for y in ys)
    left = sum((y - mean_y - slope * (x - mean_x)) ** 2 for x, y in points)
    return slope, mean_y - slope * mean_x, 1 - left / spread if spread > 0 else 1.0


def law(name, rows, key):
    """The better of a power of the side and a line over its logarithm, and where single doublings depart from it."""
    rows = [row for row in rows if row[key] > 0]  # a warm frame is a difference of two noisy times
    if len(rows) < 3:
        return f"- {name}: too few sizes to fit."
    points = [(math.log2(row["side"]), row[key]) for row in rows]
    power, _, fits_power = line_through([(x, math.log2(y)) for x, y in points])
    rise, _, fits_log = line_through(points)
    mean = statistics.fmean(y for _, y in points)
    if fits_log > fits_power:
        text = f"grows by {rise:.3g} ({100 * rise / mean:.0f}% of the mean) with each doubling of the side (R² {fits_log:.3f})"
    else:
        text = f"grows as side^{power:.2f} (R² {fits_power:.3f})"
    doublings = [(rows[n]["side"], rows[n + 1]["side"], math.log2(rows[n + 1][key] / rows[n][key]))
                 for n in range(len(rows) - 1)]
    bends = [f"{low} to {high}: side^{local:.2f}" for low, high, local in doublings if abs(local - power) > 0.35]
    return f"- {name}: {text}" + (f"; single doublings that depart: {', '.join(bends)}" if bends else "") + "."


def table(columns, rows):
    lines = ["| " + " | ".join(title for title, _, _ in columns) + " |",
             "| " + " | ".join("---" if form is None else "--:" for _, _, form in columns) + " |"]
    for row in rows:
        cells = [("" if key not in row else str(row[key]) if form is None else format(row[key], form))
                 for _, key, form in columns]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)


COLORS = {"in memory": "#0072b2", "by tiles": "#d55e00", "picture": "#009e73"}


def panel(rows_of, key, title, left, width=300, height=230):
    """One log-log plot as SVG elements."""
    rows_of = {name: [row for row in rows if row[key] > 0] for name, rows in rows_of.items()}
    rows = [row for rows in rows_of.values() for row in rows]
    xs = [math.log2(row["side"]) for row in rows]
    ys = [math.log10(row[key]) for row in rows]
    low_x, high_x = min(xs), max(xs)
    low_y, high_y = math.floor(min(ys)), math.ceil(max(ys))
    at = lambda x, y: (left + 45 + (x - low_x) / (high_x - low_x) * width,
                       40 + (high_y - y) / max(1, high_y - low_y) * height)
    out = [f'<text x="{left + 45}" y="22" font-size="14" font-weight="bold">{title}</text>']
    for y in range(low_y, high_y + 1):
        (x0, y0), (x1, _) = at(low_x, y), at(high_x, y)
        out.append(f'<path d="M{x0:.1f} {y0:.1f}H{x1:.1f}" stroke="#ccc"/>')
        label = f"{10 ** y:g}" if y < 4 else f"{10 ** (y - 3):g}k"
        out.append(f'<text x="{x0 - 6:.1f}" y="{y0 + 4:.1f}" text-anchor="end">{label}</text>')
    for x in range(int(low_x), int(high_x) + 1, 2):
        (x0, y0) = at(x, low_y)
        out.append(f'<text x="{x0:.1f}" y="{y0 + 16:.1f}" text-anchor="middle">{2 ** x}</text>')
    for name, rows in rows_of.items():
        points = [at(math.log2(row["side"]), math.log10(row[key])) for row in rows]
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        out.append(f'<polyline points="{path}" fill="none" stroke="{COLORS[name]}" stroke-width="2"/>')
        out += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{COLORS[name]}"/>' for x, y in points]
    return out


def chart(maps, pictures):
    parts = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1110 330" font-family="sans-serif" font-size="12">',
             '<rect width="1110" height="330" fill="white"/>']
    parts += panel(maps, "warm", "Map side: warm frame, processor s", 0)
    parts += panel(maps, "memory", "Map side: peak memory, MB", 370)
    parts += panel({"picture": pictures}, "processor", "Picture side: processor s", 740)
    for n, name in enumerate([*maps, "picture"]):
        x = 45 + 250 * n
        words = {"picture": "a map of 1024 x 1024 in memory"}.get(name, f"map {name}")
        parts.append(f'<rect x="{x}" y="306" width="12" height="12" fill="{COLORS[name]}"/>'
                     f'<text x="{x + 18}" y="316">{words}</text>')
    return "\n".join([*parts, "</svg>", ""])


def main():
    root = pathlib.Path(__file__).resolve().parents[2]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default=str(root / "build"))
    parser.add_argument("--work", help="folder for maps and pictures (a temporary one)")
    parser.add_argument("--chart", default=str(root / "app/manual/pictures/sizes.svg"))
    parser.add_argument("--largest-map", type=int, default=65536)
    parser.add_argument("--largest-picture", type=int, default=32768)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(dir=options.work) as folder:
        options.work = folder
        measure = Measurement(options)
        maps = list(measure.maps(options.largest_map))
        pictures = list(measure.pictures(options.largest_picture))
        shares = list(measure.shares())
    held = {name: [row for row in maps if row["held"] == name] for name in ("in memory", "by tiles")}
    print(table([("map side", "side", "d"), ("map", "held", None), ("file, MB", "file", ".1f"),
                 ("load, s", "load", ".3f"), ("first picture, s", "processor", ".3f"), ("warm frame, s", "warm", ".3f"),
                 ("steps per ray", "steps", ".1f"), ("tiles read, MB", "read", ".1f"), ("peak, MB", "memory", ".0f"),
                 ("make, s", "make", ".1f"), ("make: peak, MB", "make memory", ".0f")], maps), end="\n\n")
    print(table([("picture side", "side", "d"), ("processor, s", "processor", ".3f"), ("in all, s", "seconds", ".2f"),
                 ("peak, MB", "memory", ".0f")], pictures), end="\n\n")
    print(table([("threads", "threads", "d"), ("ranks", "ranks", "d"), ("in all, s", "seconds", ".2f"),
                 ("processor, s", "processor", ".2f"), ("peak of a process, MB", "memory", ".0f")], shares), end="\n\n")
    for name, rows in held.items():
        print(law(f"warm frame over the side of a map {name}", rows, "warm"))
        print(law(f"first picture over the side of a map {name}", rows, "processor"))
        print(law(f"peak of memory over the side of a map {name}", rows, "memory"))
    print(law("tiles read over the side of the map", held["by tiles"], "read"))
    print(law("steps per ray over the side of the map", held["by tiles"], "steps"))
    print(law("processor seconds over the side of the picture", pictures, "processor"))
    print(law("peak of memory over the side of the picture", pictures, "memory"))
    pathlib.Path(options.chart).write_text(chart(held, pictures))


if __name__ == "__main__":
    main()
