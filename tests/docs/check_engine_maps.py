#!/usr/bin/env python3
"""Reads maps for engines as another program would: by FORMATS.md alone, with its own decoder of PNG and its own tracer.

    check_engine_maps.py SOURCES BIN

Every sidecar, and the same JSON in the picture, must be valid by engine_map.schema.json. Cones of 8 and 16 bits are decoded and traced by
the shader's loop: no ray may pass the surface, which is sampled densely along it, and nearly all must come close to it. A map rounded to the
nearest code must let a ray pass, so that the check itself is checked. Without python3-jsonschema the schema is not checked.
"""
import json
import math
import os
import random
import struct
import subprocess
import sys
import tempfile
import zlib

try:
    import jsonschema
except ImportError:
    jsonschema = None
    print("python3-jsonschema is not there: sidecars are not validated")

root, relief = os.path.abspath(sys.argv[1]), os.path.join(os.path.abspath(sys.argv[2]), "relief")
schema = json.load(open(os.path.join(root, "algorithms/scenario/engine_map.schema.json"), encoding="utf-8"))
validator = None
if jsonschema:
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
faults = []


def png(path):
    """Returns width, height, the channels as rows of numbers x, and the text chunk Description."""
    data = open(path, "rb").read()
    at, packed, text = 8, b"", None
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, bits, colour = struct.unpack(">IIBB", body[:10])
        elif kind == b"IDAT":
            packed += body
        elif kind == b"tEXt" and body.startswith(b"Description\0"):
            text = body[12:].decode()
        at += 12 + length
    count = {0: 1, 2: 3, 6: 4}[colour]
    size = bits // 8
    raw, pixel = zlib.decompress(packed), count * size
    line = width * pixel
    before, rows = bytearray(line), []
    for y in range(height):
        kind, now = raw[y * (line + 1)], bytearray(raw[y * (line + 1) + 1:(y + 1) * (line + 1)])
        for i in range(line):
            a, b, c = now[i - pixel] if i >= pixel else 0, before[i], before[i - pixel] if i >= pixel else 0
            p = a + b - c
            paeth = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]
            now[i] = (now[i] + (0, a, b, (a + b) // 2, paeth)[kind]) & 255
        rows.append(now)
        before = now
    most = 2 ** bits - 1
    value = (lambda row, i: row[i]) if size == 1 else (lambda row, i: row[2 * i] * 256 + row[2 * i + 1])
    return width, height, [[[value(row, x * count + c) / most for x in range(width)] for row in rows] for c in range(count)], text


class Map:
    def __init__(self, path):
        self.notes = json.load(open(path + ".json", encoding="utf-8"))
        self.width, self.height, channels, text = png(os.path.join(os.path.dirname(path), self.notes["files"][0]["name"]))
        own = json.loads(text)
        own.pop("level", None)
        if own != self.notes:
            faults.append(f"{path}: the picture's metadata are not those of the sidecar")
        by_role = {role: channels["RGBA".index(letter)] for letter, role in self.notes["channels"].items()}
        self.codes = by_role.get("cone")
        self.heights = by_role.get("height") or [[1 - x for x in row] for row in by_role["depth"]]

    def fetch(self, channel, u, v, nearest=False):
        wrap = (lambda i, n: i % n) if self.notes["wrap"] == "repeat" else (lambda i, n: min(max(i, 0), n - 1))
        s, t = u * self.width, v * self.height
        if nearest:
            return channel[wrap(math.floor(t), self.height)][wrap(math.floor(s), self.width)]
        i, j = math.floor(s - 0.5), math.floor(t - 0.5)
        a, b = s - 0.5 - i, t - 0.5 - j
        at = lambda x, y: channel[wrap(y, self.height)][wrap(x, self.width)]
        return (1 - b) * ((1 - a) * at(i, j) + a * at(i + 1, j)) + b * ((1 - a) * at(i, j + 1) + a * at(i + 1, j + 1))

    def ratio(self, x):
        scale = self.notes["cone"]["scale"]
        return {"ratio": scale * x, "sqrt-ratio": scale * x * x, "slope": 1 / (scale * x) if x > 0 else 1e30}[self.notes["cone"]["unit"]]

    def trace(self, u, v, du, dv, nearest, steps=400):
        """The loop of FORMATS.md. Returns the descent at which it ends, and the height above the surface there."""
        length = {"uv": math.hypot(du, dv), "width": math.hypot(du, dv * self.height / self.width)}[self.notes["cone"]["length"]]
        down = 0.0
        for _ in range(steps):
            above = 1 - down - self.fetch(self.heights, u + du * down, v + dv * down)
            if above <= 0 or down >= 1:
                break
            ratio = self.ratio(self.fetch(self.codes, u + du * down, v + dv * down, nearest))
            down = min(1.0, down + above * ratio / (ratio + length))
        return down, 1 - down - self.fetch(self.heights, u + du * down, v + dv * down)

    def passed(self, u, v, du, dv, end):
        """How deep the ray was below the surface before its end, at places 1/16 of a texel apart."""
        places = max(8, int(16 * end * math.hypot(du * self.width, dv * self.height)))
        deepest = 0.0
        for n in range(places):
            down = end * n / places
            deepest = max(deepest, self.fetch(self.heights, u + du * down, v + dv * down) - (1 - down))
        return deepest


maps_made = []
with tempfile.TemporaryDirectory() as folder:
    def made(name, *arguments):
        maps_made.append(name)
        path = os.path.join(folder, name)
        done = subprocess.run([relief, "map", "-q", *arguments, "-o", path], capture_output=True, text=True)
        if done.returncode != 0:
            faults.append(f"{arguments}: {done.stderr}")
        if validator:
            for error in validator.iter_errors(json.load(open(path + ".json", encoding="utf-8"))):
                faults.append(f"{name}: {'/'.join(map(str, error.path))}: {error.message}")
        return path

    bricks = ["--relief", "bricks:32x24"]
    for number, arguments in enumerate([["max-pyramid"], ["mean-pyramid"], ["euclidean"], ["refined"], ["refined-sampled"],
                                        ["relaxed-cone", "--convention", "policarpo"], ["cone-dummer", "--convention", "dummer"],
                                        ["cone", "--pack", "R=apex,G=cone", "--surface", "columns"], ["normals", "--green", "down"], ["heights"],
                                        ["cone", "--mips", "3", "--zero-level", "0.5"], ["relaxed-cone-robust"]]):
        made(f"kind{number}.png", *arguments, *bricks)
        made(f"kind{number}.exr", *arguments, *bricks)

    traced = 0
    draw = random.Random(5)
    for number, (options, wrap) in enumerate([(["--bits", "8", "--unit", "sqrt-ratio"], "repeat"), (["--bits", "8", "--unit", "slope", "--white", "deep"], "clamp"),
                                              (["--bits", "16", "--unit", "ratio", "--length", "width"], "repeat")]):
        map = Map(made(f"cone{number}.png", "cone", *bricks, "--address", wrap, *options))
        far = 0
        for n in range(60):
            u, v, run, turn = draw.random(), draw.random(), 2 ** draw.uniform(-4, 1), draw.uniform(0, 2 * math.pi)
            ray = (u, v, run * math.cos(turn), run * math.sin(turn))
            end, above = map.trace(*ray, nearest=n % 2 == 1)
            depth = map.passed(*ray, end)
            traced += 1
            if depth > 1e-6:
                faults.append(f"{options}: the ray {ray} passes the surface by {depth}")
            far += above > 0.02
        if far > 6:
            faults.append(f"{options}: {far} of 60 rays end far above the surface")

    # The first step over a texel whose cone was rounded up ends behind the spike.
    width = 4096
    heights = ",".join("1" if x == width // 2 else "0" for x in range(width))
    spike = os.path.join(folder, "spike.pgm")
    with open(spike, "w") as file:
        file.write(f"P2 {width} 1 255\n" + heights.replace(",", " ").replace("1", "255") + "\n")
    deepest = {}
    for rounding in ("outward", "nearest"):
        map = Map(made(f"{rounding}.png", "cone", spike, "--bits", "8", "--unit", "ratio", "--address", "clamp", "--rounding", rounding))
        deepest[rounding] = 0.0
        for x in range(0, width // 2, 16):
            u = (x + 0.5) / width
            away = 0.5 + 0.5 / width - u
            ray = (u, 0.5, away / 0.002, 0.0)
            end, _ = map.trace(*ray, nearest=False, steps=1)
            at_spike = 1 - away / ray[2] if end * ray[2] > away else 1.0
            deepest[rounding] = max(deepest[rounding], 1 - at_spike)
    if not deepest["outward"] == 0 < deepest["nearest"]:
        faults.append(f"rays that pass the spike: {deepest}")

print("\n".join(faults))
print(f"{len(maps_made)} maps read, {traced} rays traced: {len(faults)} faults")
sys.exit(1 if faults else 0)
