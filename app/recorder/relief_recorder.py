"""Records what a tracer does, for `relief diagnose` and for the window of Reliefscope (Ctrl+T). Python 3.8, no packages.

    with Recorder("hits.csv", "steps.csv", width, height) as recorder:
        for ray in read_rays("rays.csv"):
            recorder.ray(ray)
            ...                                    # in the loop:  recorder.step(start, end, height_at_end)
            recorder.hit(descent)                  # or miss(), or limit()

Tracers that work on arrays write only their answers: write_hits("hits.csv", descents). Shaders that include
relief_recorder.glsl leave a buffer: write_buffer(bytes, read_rays("rays.csv"), "hits.csv", "steps.csv", width, height).

lambda, here `descent`, is 0 in the polygon's plane (height 1) and 1 at the bottom of the relief (height 0). The ray is at
s = s0 + lambda a, t = t0 + lambda b, texels; texel (i, j) has its centre at (i + 1/2, j + 1/2).
"""

import math
import struct

_HITS = "outcome,lambda,s,t,steps\n"
_STEPS = "ray,number,phase,level,i,j,k,lambda_in,lambda_out,z_in,z_out,value,decision,lambda_after,kind"


def read_rays(path):
    """Returns the rays that `relief export rays` has written, as tuples (s0, t0, a, b)."""
    with open(path, encoding="utf-8") as file:
        if file.readline().strip() != "s0,t0,a,b":
            raise ValueError(path + ": is not a file of rays")
        return [tuple(map(float, line.split(","))) for line in file if line.strip()]


def write_hits(path, descents, steps=None):
    """Writes an answer per ray: lambda of the hit, or None or NaN for a miss."""
    with open(path, "w", encoding="utf-8") as file:
        file.write(_HITS)
        for number, descent in enumerate(descents):
            count = int(steps[number]) if steps is not None else 0
            if descent is None or math.isnan(descent):
                file.write(f"miss,,,,{count}\n")
            else:
                file.write(f"hit,{float(descent)!r},,,{count}\n")


def _step_line(ray, numbers, names, start, end, height, size, own=()):
    """Returns the line of a step. numbers: of the ray and of the step; names: phase and decision; size: of the map."""
    s0, t0, a, b = ray
    i = math.floor(s0 + end * a) % size[0]
    j = math.floor(t0 + end * b) % size[1]
    cells = [*numbers, names[0], 0, i, j, 0, start, end, 1 - start, 1 - end, height, names[1], end, "point", *own]
    return ",".join(str(cell) for cell in cells) + "\n"


class Recorder:
    """Writes hits, and steps if a file is named for them. width, height: of the height map, texels. own: names of further
    columns of the steps; the window shows them."""

    def __init__(self, hits, steps, width, height, own=()):
        self._hits = open(hits, "w", encoding="utf-8")
        self._steps = open(steps, "w", encoding="utf-8") if steps else None
        self._size = (width, height)
        self._own = len(own)
        self._number = -1
        self._hits.write(_HITS)
        if self._steps:
            self._steps.write(",".join([_STEPS, *own]) + "\n")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        self._hits.close()
        if self._steps:
            self._steps.close()

    def ray(self, ray):
        """Begins a ray."""
        self._ray = ray
        self._number += 1
        self._count = 0
        self._at = self._value = 0.0

    def step(self, start, end, height, own=()):
        """The search has looked at the surface at lambda = end, found the height there, and moved on to it from start."""
        self._write("search", "advance", start, end, height, own)
        self._at, self._value = end, height

    def hit(self, descent):
        """The answer: lambda of the hit."""
        self._write("refine", "hit", min(self._at, descent), descent, self._value)
        s0, t0, a, b = self._ray
        # As floats of Python: repr() writes the type of NumPy's numbers, too.
        numbers = map(float, (descent, s0 + descent * a, t0 + descent * b))
        self._hits.write(f"hit,{','.join(map(repr, numbers))},{self._count}\n")

    def miss(self):
        """The answer: there is no hit."""
        self._none("miss")

    def limit(self):
        """The answer: the largest number of steps was reached."""
        self._none("limit")

    def _none(self, outcome):
        self._write("search", outcome, self._at, self._at, self._value)
        self._hits.write(f"{outcome},,,,{self._count}\n")

    def _write(self, phase, decision, start, end, height, own=()):
        self._count += 1
        if not self._steps:
            return
        numbers = (self._number, self._count)
        cells = [*own] + [""] * (self._own - len(own))
        self._steps.write(_step_line(self._ray, numbers, (phase, decision), start, end, height, self._size, cells))


def write_buffer(data, rays, hits, steps, width, height):
    """Writes the files from the bytes of the shader's buffer (relief_recorder.glsl). Steps are those of the ray that the
    shader was told to record. Raises ValueError if an answer is missing, or a step for which the buffer had no room."""
    capacity, count, chosen, answers = struct.unpack_from("<4i", data)
    records = list(struct.iter_unpack("<4f", data[16:16 + 16 * capacity]))
    wants_steps = bool(steps) and chosen >= 0
    if answers != len(rays):
        raise ValueError(f"the buffer is for {answers} rays, not for {len(rays)}")
    wanted = answers + (count if wants_steps else 0)
    if len(records) < wanted:
        raise ValueError(f"the buffer has {len(records)} records, but the answers and steps need {wanted}")
    outcomes = records[:answers]
    log = records[answers:answers + count]
    for number, record in enumerate(outcomes):
        if record[0] not in (1.0, 2.0, 3.0):
            raise ValueError(f"ray {number} has no answer")
    with Recorder(hits, None, width, height) as recorder:
        for number, ray in enumerate(rays):
            recorder.ray(ray)
            outcome, descent, taken, _ = outcomes[number]
            recorder._count = int(taken) - 1
            if outcome == 1.0:
                recorder.hit(descent)
            elif outcome == 3.0:
                recorder.limit()
            else:
                recorder.miss()
    if not wants_steps:
        return
    with open(steps, "w", encoding="utf-8") as file:
        file.write(_STEPS + "\n")
        for number, (start, end, value, decision) in enumerate(log):
            name = {0.0: "advance", 1.0: "hit", 2.0: "miss", 3.0: "limit"}[decision]
            numbers = (chosen, number + 1)
            file.write(_step_line(rays[chosen], numbers, ("search", name), start, end, value, (width, height)))
