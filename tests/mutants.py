#!/usr/bin/env python3
"""Mutation testing: puts faults of one line into the sources and reports those that no test detects.

    tests/mutants.py FOLDER N SEED [RULE]      called by: tests/run --mutants N [--seed S] [--rule RULE]

Faults are drawn by the rules of mutant_sources.py, or by one of them, from the .cpp and .h files of algorithms/, app/ and ui/.
All are compiled into one build, each on a condition: a + b becomes (reliefFaults.on[7] ? a - b : a + b), and a test runs with
fault 7 if RELIEF_FAULTS=7 is in its environment. A fault that does not compile in this form (in a constant expression, say)
is replaced by another.

FOLDER receives a copy of the sources with the faults (source/), their build (source/build/) and the results, in seed-SEED.jsonl
(with a rule, seed-SEED-RULE.jsonl): the draw, then one line for each fault. An interrupted run resumes from there, unless the
sources have changed.

Each fault is tried with the tests whose files match it by name, then with those of the same folder or related by name, until one
fails. The undetected faults are then switched on together and all tests are run once; the suites that fail are run again with
each fault separately. A suite that passes with all faults is assumed to pass with each. If faults mask each other this is wrong,
so the number of survivors may be too high. Suites that fail without any fault notice nothing.
"""

import hashlib
import json
import os
import re
import resource
import subprocess
import sys
import time
from pathlib import Path

sys.dont_write_bytecode = True
from mutant_sources import ROOT, Draw, sources, write_copy

# Timeout of a suite in seconds: a fault may cause an endless loop. Without a fault no suite takes a third of it. Set
# when configuring, because a test's own TIMEOUT overrides ctest's --timeout.
PATIENCE = 300
# Limit of a process's address space, in bytes.
MEMORY = 16 << 30
# The tests that are tried first with faults of each folder.
TESTS = {"algorithms": "algorithms", "app": "cmd", "ui": "ui"}
# Tests that do not test behaviour: a fault may break the formatting of a line.
NOT_TESTS = r"^(format)$"


def suites_of():
    """Maps each suite, named as in ctest, to its test files."""
    suites = {}
    for path in sorted((ROOT / "tests").rglob("*_test.cpp")):
        if path.parent.name == "guest":
            continue
        for name in set(re.findall(r"^(?:TEST|TEST_F|TEST_P)\((\w+),", path.read_text(), re.MULTILINE)):
            suites.setdefault(name, []).append(path)
    return suites


def fitting(suites, mutated):
    """Returns two lists of suites: those whose file matches the mutated one by name or includes it; others that are related.

    Related are those of the same folder, or if that has no tests of its own, those of its parents that share a word with it.
    """
    file = Path(mutated)
    stem = re.sub(r"(_lanes|-inl)$", "", file.stem)
    header = str(Path(*file.parts[1:]).with_suffix(".h")).removeprefix("include/")
    # For a source whose header is public.
    if not any((ROOT / "algorithms" / top / header).exists() for top in ("", "include")):
        header = "relief/" + file.with_suffix(".h").name
    include = '"' + header + '"'
    top = TESTS[file.parts[0]]
    folder = ROOT / "tests" / top / Path(*file.parent.parts[1:]).relative_to("include" if "include" in file.parts else "")
    words = None
    while folder not in {path.parent for paths in suites.values() for path in paths} and folder != ROOT / "tests":
        words = (words or set(stem.split("_"))) | {folder.name}
        folder = folder.parent
    near, beside = [], []
    for suite, paths in suites.items():
        if any(path.stem.startswith(stem) or include in path.read_text() for path in paths):
            near.append(suite)
        elif any(path.parent == folder and (words is None or words & set(path.stem.split("_"))) for path in paths):
            beside.append(suite)
    return near, beside


def build_output(build):
    """Builds; returns None, or the output if it failed."""
    ran = subprocess.run(["ninja", "-k", "0", "-C", str(build)], capture_output=True, text=True, stdin=subprocess.DEVNULL)
    return None if ran.returncode == 0 else ran.stdout + ran.stderr


def built(source, draw, count):
    """Draws faults, writes the copy and builds it, until all that are drawn compile."""
    build = source / "build"
    draw.fill(count)
    while True:
        write_copy(source, draw.faults)
        command = ["cmake", "-G", "Ninja", "-S", str(source), "-B", str(build), "-DRELIEF_TESTS=ON", "-DCMAKE_BUILD_TYPE=Release",
                   f"-DRELIEF_PATIENCE={PATIENCE}"]
        if subprocess.run(command, stdout=subprocess.DEVNULL, stdin=subprocess.DEVNULL).returncode != 0:
            sys.exit("the copy of the sources could not be configured")
        output = build_output(build)
        if output is None:
            return
        errors = {(os.path.relpath(os.path.join(build, file), source), int(line))
                  for file, line in re.findall(r"^(\S+?):(\d+):\d+: (?:fatal )?error:", output, re.MULTILINE)}
        dropped = draw.drop(errors)
        if dropped == 0:
            sys.exit("the copy does not build:\n" + output[-4000:])
        print(f"{dropped} faults do not compile on a condition and are replaced", file=sys.stderr, flush=True)
        draw.fill(count)


class Runs:
    """Runs suites of the build with faults. A suite that fails without a fault notices none."""

    def __init__(self, build):
        self.build, self.sound = build, {}

    def failed(self, only, faults, *options):
        """Runs these suites, or all, with the faults of these numbers; returns the tests that fail."""
        if only is not None and not only:
            return []
        command = ["ctest", "--test-dir", str(self.build), f"-j{os.cpu_count()}", "-E", NOT_TESTS, *options]
        if only is not None:
            # CMake's regular expressions have no \w.
            command += ["-R", r"^(window\.)?([A-Za-z0-9_]+/)?(" + "|".join(re.escape(suite) for suite in sorted(only)) + ")$"]
        environment = dict(os.environ, RELIEF_FAULTS=",".join(str(fault) for fault in faults))
        ran = subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL, env=environment)
        lines = [line for line in ran.stdout.split("\n") if "***" in line and "***Skipped" not in line]
        return [match.group(1) for line in lines if (match := re.search(r"Test +#\d+: (\S+)", line))]

    def is_sound(self, test):
        if test not in self.sound:
            self.sound[test] = not self.failed([bare(test)], [])
        return self.sound[test]

    def noticing(self, faults):
        """Runs all suites with these faults; returns the tests that notice any."""
        return [test for test in self.failed(None, faults) if self.is_sound(test)]

    def first(self, groups, fault):
        """Runs the groups of suites in turn; returns the first test that notices the fault, or None."""
        for group in groups:
            left = set(group)
            while failed := self.failed(left, [fault], "--stop-on-failure"):
                if sound := [test for test in failed if self.is_sound(test)]:
                    return sound[0]
                left -= {bare(test) for test in failed}
        return None


def bare(test):
    return re.sub(r"^(window\.)?(\w+/)?", "", test)


def likely_first(suites, tests, mutated):
    """Splits the tests into three groups: those of the mutated file's folder, of its library, all others."""
    groups = [[], [], []]
    near = [ROOT / "tests" / TESTS[Path(mutated).parts[0]] / Path(*Path(mutated).parts[1:]).parent,
            ROOT / "tests" / TESTS[Path(mutated).parts[0]]]
    for test in tests:
        path = suites.get(bare(test), [ROOT])[0]
        groups[next((k for k in (0, 1) if path.is_relative_to(near[k])), 2)].append(bare(test))
    return groups


class Record:
    """The results of a draw, a line each; the first says what was drawn, from which sources."""

    def __init__(self, path):
        self.path = path
        checksum = hashlib.sha256()
        for name, file in sources().items():
            checksum.update(name.encode() + b"\0" + file.read_bytes())
        self.of = checksum.hexdigest()
        self.lines = [json.loads(line) for line in path.read_text().splitlines()] if path.exists() else []
        if not self.lines or self.lines[0]["sources"] != self.of:
            self.lines = []

    def begin(self, count, faults):
        self.lines = [{"sources": self.of, "count": count, "faults": faults}]
        self.path.write_text(json.dumps(self.lines[0]) + "\n")

    def find(self, kind, fault):
        return next((line for line in self.lines[1:] if line["kind"] == kind and line["fault"] == fault), None)

    def add(self, **line):
        self.lines.append(line)
        with self.path.open("a") as out:
            out.write(json.dumps(line) + "\n")
        return line


def tried(record, kind, fault, first):
    """Returns the line of the record for this fault; if there is none, it calls first() for the test that notices it."""
    if known := record.find(kind, fault):
        return known
    begun = time.monotonic()
    by = first()
    return record.add(kind=kind, fault=fault, by=by, seconds=round(time.monotonic() - begun))


def say(fault, place, by):
    print(f"{fault} {place[0]}:{place[1] + 1}: {by or '-'}", file=sys.stderr, flush=True)


def table(faults, results):
    print("| place | fault | noticed by | s |\n| --- | --- | --- | --: |")
    for fault, (name, number, begin, end, new) in faults.items():
        old = (ROOT / name).read_text().split("\n")[number]
        change = f"`{old.strip()}` -> `{(old[:begin] + new + old[end:]).strip()}`".replace("|", "\\|")
        by, seconds = results[fault]
        print(f"| {name}:{number + 1} | {change} | {by or '**survived**'} | {seconds} |")
    noticed = sum(1 for by, _ in results.values() if by)
    print(f"\n{noticed} of {len(results)} faults noticed ({100 * noticed / max(1, len(results)):.0f}%).")


def main():
    folder, count, seed = Path(sys.argv[1]).resolve(), int(sys.argv[2]), int(sys.argv[3])
    rule = sys.argv[4] if len(sys.argv) > 4 else None
    # The build folder lies within the sources as in a checkout, so that the compiler cache is hit.
    source = folder / "source"
    # A fault may exhaust the memory.
    most = resource.getrlimit(resource.RLIMIT_AS)[1]
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY if most < 0 else min(MEMORY, most), most))
    folder.mkdir(parents=True, exist_ok=True)
    record = Record(folder / f"seed-{seed}{'-' + rule if rule else ''}.jsonl")
    draw = Draw(seed, rule)
    if record.lines and record.lines[0]["count"] == count:
        draw.faults = {fault: tuple(place) for fault, place in record.lines[0]["faults"]}
        built(source, draw, 0)
    else:
        built(source, draw, count)
        record.begin(count, list(draw.faults.items()))
    suites, runs = suites_of(), Runs(source / "build")
    results = {}
    for fault, place in draw.faults.items():
        line = tried(record, "near", fault, lambda: runs.first(fitting(suites, place[0]), fault))
        results[fault] = (line["by"], line["seconds"])
        say(fault, place, line["by"])
    left = [fault for fault in draw.faults if not results[fault][0]]
    if left:
        together = record.find("together", left) or record.add(kind="together", fault=left, by=runs.noticing(left), seconds=0)
        print("with all that are left, these fail: " + " ".join(together["by"]), file=sys.stderr, flush=True)
        for fault in left:
            place = draw.faults[fault]
            line = tried(record, "far", fault, lambda: runs.first(likely_first(suites, together["by"], place[0]), fault))
            results[fault] = (line["by"], results[fault][1] + line["seconds"])
            say(fault, place, line["by"])
    table(draw.faults, results)


if __name__ == "__main__":
    main()
