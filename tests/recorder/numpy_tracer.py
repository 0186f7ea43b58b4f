"""An example for app/recorder/relief_recorder.py: a tracer on arrays, correct but for the map, which it reads from the
bottom row up (--correct: it does not).

    numpy_tracer.py MAP.pgm RAYS.csv HITS.csv [--correct]
"""

import os
import re
import sys

import numpy as np

sys.path.insert(0, os.environ["RELIEF_RECORDER"])
import relief_recorder  # noqa: E402


def read_map(path):
    with open(path, "rb") as file:
        data = file.read()
    header = re.match(rb"P5\s(\d+)\s(\d+)\s65535\s", data)
    width, height = int(header[1]), int(header[2])
    codes = np.frombuffer(data[header.end():], dtype=">u2", count=width * height)
    return codes.reshape(height, width) / 65535


def sampled(heights, s, t):
    x, y = np.floor(s - 0.5), np.floor(t - 0.5)
    u, v = s - 0.5 - x, t - 0.5 - y
    i, j = x.astype(int) % heights.shape[1], y.astype(int) % heights.shape[0]
    right, below = (i + 1) % heights.shape[1], (j + 1) % heights.shape[0]
    above = heights[j, i] * (1 - u) + heights[j, right] * u
    return above * (1 - v) + (heights[below, i] * (1 - u) + heights[below, right] * u) * v


def trace(heights, rays, steps=4096, halvings=30):
    s0, t0, a, b = rays.T

    def solid(descent):
        return sampled(heights, s0 + descent * a, t0 + descent * b) >= 1 - descent

    low = np.zeros(len(rays))
    found = solid(low)
    high = low.copy()
    for n in range(1, steps + 1):
        high = np.where(found, high, n / steps)
        low = np.where(found, low, (n - 1) / steps)
        found |= solid(high)
    for _ in range(halvings):
        middle = 0.5 * (low + high)
        inside = solid(middle)
        low, high = np.where(inside, low, middle), np.where(inside, middle, high)
    return np.where(found, high, np.nan)


def main(arguments):
    heights = read_map(arguments[0])
    if "--correct" not in arguments:
        heights = heights[::-1]
    rays = np.array(relief_recorder.read_rays(arguments[1]))
    relief_recorder.write_hits(arguments[2], trace(heights, rays))


main(sys.argv[1:])
