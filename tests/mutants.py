#!/usr/bin/env python3
"""Mutation testing: puts faults of one line into the sources, one at a time, and reports those that no test detects.

    tests/mutants.py FOLDER N SEED [RULE]      called by: tests/run --mutants N [--seed S] [--rule RULE]

FOLDER receives a copy of the sources (source/), their build (source/build/) and the results, one line of JSON per fault,
in seed-SEED.jsonl (with a rule, seed-SEED-RULE.jsonl): an interrupted run resumes from there, unless the sources have
changed. Faults are drawn by RULES, or by one of them, from the .cpp and .h files of algorithms/, app/ and ui/; one that
does not compile without a warning is replaced by another. Each fault is built separately and tried with the tests whose files match it by
name, then with those of the same folder or related by name, until one fails. The undetected faults are then inserted
together and all tests are run once; the suites that fail are run again with each fault separately. A suite that passes
with all faults is assumed to pass with each. If faults mask each other this is wrong, so the number of survivors may be
too high.
"""

import filecmp
import json
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

# Timeout of a suite in seconds: a fault may cause an endless loop. Without a fault no suite takes a third of it. Set
# when configuring, because a test's own TIMEOUT overrides ctest's --timeout.
PATIENCE = 300
# Limit of a process's address space, in bytes.
MEMORY = 16 << 30
# The test program that is tried first with faults of each folder, and its tests.
PROGRAMS = {"algorithms": ("relief_tests", "algorithms"), "app": ("relief_cmd_tests", "cmd"),
            "ui": ("reliefui_tests", "ui")}
# Tests that do not test behaviour: a fault may break the formatting of a line.
NOT_TESTS = r"^(format)$"

NAME = r"[A-Za-z_][\w.]*(?:\[\w+\])?"
# Name, pattern, replacement. Binary operators are surrounded by blanks (clang-format), angle brackets of templates are
# not.
RULES = [
    ("bound", r"(?<= )<(?= )", "<="),
    ("bound", r"(?<= )<=(?= )", "<"),
    ("bound", r"(?<= )>(?= )", ">="),
    ("bound", r"(?<= )>=(?= )", ">"),
    ("comparison", r"(?<= )==(?= )", "!="),
    ("comparison", r"(?<= )!=(?= )", "=="),
    ("operator", r"(?<= )\+(?= )", "-"),
    ("operator", r"(?<= )-(?= )", "+"),
    ("operator", r"(?<= )\*(?= )", "/"),
    ("operator", r"(?<= )/(?= )", "*"),
    ("logic", r"(?<= )&&(?= )", "||"),
    ("logic", r"(?<= )\|\|(?= )", "&&"),
    ("logic", r"(?<=if \()!", ""),
    ("extreme", r"\bstd::min\b", "std::max"),
    ("extreme", r"\bstd::max\b", "std::min"),
    ("extreme", r"\bstd::floor\b", "std::ceil"),
    ("extreme", r"\bstd::ceil\b", "std::floor"),
    ("one", r" [+-] 1(?![\w.])", ""),
    ("sign", r"(?<=[(=,] )-(?=[A-Za-z_(])", ""),
    ("sign", r"(?<=\()-(?=[A-Za-z_(])", ""),
    ("truth", r"\btrue\b", "false"),
    ("truth", r"\bfalse\b", "true"),
    # Of all constants, those that are named as margins (algorithms/relief/margins.md).
    ("margin", r"(?<=constexpr )(?:float|double) k\w*(?:Margin|Slack|Shorter\w*|Steeper|Lower|LeastRun|Round\w*|Late|Away|Aside|"
               r"Nudge|Unsure|Clearance) = [^;]+(?=;)",
     lambda m: m.group().split("=")[0] + ("= 1" if re.search(r"= 1 [+-]", m.group()) else "= 0")),
    # Not in calls of symmetric functions, where it is no fault.
    ("swapped", rf"(?!(?:min|max|hypot|swap|Add|Mul|And|Or|Xor|Min|Max)\b)(\b\w+(?:<[^()]*>)?\()({NAME}), ({NAME})(?=\))", r"\1\3, \2"),
    ("key", rf" (?:\|\||&&|\|) {NAME}(?:\([\w:]*\))?(?: == {NAME})?(?=[;)])", ""),
    ("check", r"^ *if \([^{}]*\) (?:return\b[^;]*|continue|break|throw [^;]*);$", ""),
]


def code_lines(text):
    """Yields (number, line) of the lines that are code: not comments or directives, without string literals."""
    block = False
    for number, line in enumerate(text.split("\n")):
        bare = line.strip()
        if block or bare.startswith(("/*", "*")):
            block = "*/" not in bare and (block or bare.startswith("/*"))
        elif bare and not bare.startswith(("//", "#")) and '"' not in bare and "assert(" not in bare:
            yield number, line


def candidates(source):
    """Returns for each rule all its places, as (file, line, begin, end, replacement)."""
    found = {}
    for folder in ("algorithms", "app", "ui"):
        for path in sorted((source / folder).rglob("*")):
            if path.suffix not in (".cpp", ".h"):
                continue
            for number, line in code_lines(path.read_text()):
                code = line.split(" //")[0]
                for name, pattern, new in RULES:
                    if name == "margin" and (folder != "algorithms" or "measuring" in path.parts):
                        continue
                    for match in re.finditer(pattern, code):
                        other = match.expand(new) if isinstance(new, str) else new(match)
                        if other != match.group():
                            place = (str(path.relative_to(source)), number, *match.span(), other)
                            found.setdefault(name, []).append(place)
    return found


def suites_of(source):
    """Maps each suite, named as in ctest, to its test files."""
    suites = {}
    for path in sorted((source / "tests").rglob("*_test.cpp")):
        if path.parent.name == "guest":
            continue
        for name in set(re.findall(r"^(?:TEST|TEST_F|TEST_P)\((\w+),", path.read_text(), re.MULTILINE)):
            suites.setdefault(name, []).append(path)
    return suites


def fitting(source, suites, mutated):
    """Returns two lists of suites: those whose file matches the mutated one by name or includes it; others that are related.

    Related are those of the same folder, or if that has no tests of its own, those of its parents that share a word with it.
    """
    file = Path(mutated)
    stem = re.sub(r"(_lanes|-inl)$", "", file.stem)
    header = str(Path(*file.parts[1:]).with_suffix(".h")).removeprefix("include/")
    # For a source whose header is public.
    if not any((source / "algorithms" / top / header).exists() for top in ("", "include")):
        header = "relief/" + file.with_suffix(".h").name
    include = '"' + header + '"'
    top = PROGRAMS[file.parts[0]][1]
    folder = source / "tests" / top / Path(*file.parent.parts[1:]).relative_to("include" if "include" in file.parts else "")
    words = None
    while folder not in {path.parent for paths in suites.values() for path in paths} and folder != source / "tests":
        words = (words or set(stem.split("_"))) | {folder.name}
        folder = folder.parent
    near, beside = [], []
    for suite, paths in suites.items():
        if any(path.stem.startswith(stem) or include in path.read_text() for path in paths):
            near.append(suite)
        elif any(path.parent == folder and (words is None or words & set(path.stem.split("_"))) for path in paths):
            beside.append(suite)
    return near, beside


def refresh(source):
    """Updates the copy to the state of the checkout; returns True if anything changed. Equal files are not touched."""
    changed = False
    root = Path(__file__).resolve().parent.parent
    for name in ("CMakeLists.txt", "README.md", "algorithms", "app", "datasets", "tests", "ui"):
        files = [root / name] if (root / name).is_file() else [p for p in (root / name).rglob("*") if p.is_file()]
        wanted = {file.relative_to(root) for file in files}
        for file in wanted:
            to = source / file
            if not to.exists() or not filecmp.cmp(root / file, to, shallow=False):
                to.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(root / file, to)
                changed = True
        for file in (source / name).rglob("*"):
            if file.is_file() and file.relative_to(source) not in wanted:
                file.unlink()
                changed = True
    return changed


def configure(source, build):
    command = ["cmake", "-G", "Ninja", "-S", str(source), "-B", str(build), "-DRELIEF_TESTS=ON",
               "-DCMAKE_BUILD_TYPE=Release", "-DRELIEF_WERROR=ON", f"-DRELIEF_PATIENCE={PATIENCE}"]
    if subprocess.run(command, stdout=subprocess.DEVNULL, stdin=subprocess.DEVNULL).returncode != 0:
        sys.exit("the copy of the sources could not be configured")


def named(suites):
    # CMake's regular expressions have no \w.
    return r"^(window\.)?([A-Za-z0-9_]+/)?(" + "|".join(re.escape(suite) for suite in sorted(suites)) + ")$"


def failures(build, only=None, *options):
    """Runs all suites, or only these; returns the tests that fail."""
    if only is not None and not only:
        return []
    command = ["ctest", "--test-dir", str(build), "-j2", "-E", NOT_TESTS, *options]
    if only is not None:
        command += ["-R", named(only)]
    ran = subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL)
    failed = []
    for line in ran.stdout.split("\n"):
        if "***" in line and (match := re.search(r"Test +#\d+: (\S+)", line)):
            failed.append(match.group(1) + (" (no end)" if "***Timeout" in line else ""))
    return failed


def first_failure(build, only=None):
    """Returns the suite that fails first, or None."""
    return next(iter(failures(build, only, "--stop-on-failure")), None)


def first_of(build, groups):
    """Runs the groups of suites in order; returns the suite that fails first, or None."""
    return next((by for group in groups if (by := first_failure(build, group))), None)


def noticed_in_turn(source, build, suites, groups):
    """The same, but builds for each group only the programs that it needs."""
    for group in filter(None, groups):
        if not builds(build, *programs_of(source, suites, group)):
            return "the build"
        if by := first_failure(build, group):
            return by
    return None


def likely_first(source, suites, tests, mutated):
    """Splits the tests into three groups: those of the mutated file's folder, of its library, all others."""
    groups = [[], [], []]
    for test in tests:
        path = suites.get(re.sub(r"^(window\.)?(\w+/)?", "", test), [source])[0]
        near = [source / "tests" / Path(mutated).parent, source / "tests" / PROGRAMS[Path(mutated).parts[0]][1]]
        groups[next((k for k in (0, 1) if path.is_relative_to(near[k])), 2)].append(test)
    return groups


def programs_of(source, suites, tests):
    """Returns the targets to build for these tests; an empty list (ninja builds everything) if a test has no program of its own."""
    programs = set()
    for test in tests:
        paths = suites.get(re.sub(r"^(window\.)?(\w+/)?", "", test))
        if paths is None:
            return []
        path = paths[0]
        of = next(program for program, folder in PROGRAMS.values() if path.is_relative_to(source / "tests" / folder))
        programs.add(of)
    return sorted(programs)


def builds(build, *programs):
    """Returns True if the build succeeds. It has a timeout: the build runs the test programs to list their tests, and these may not end."""
    command = ["ninja", "-C", str(build), *programs]
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, stdin=subprocess.DEVNULL,
                          start_new_session=True) as ran:
        try:
            return ran.wait(6 * PATIENCE) == 0
        except subprocess.TimeoutExpired:
            os.killpg(ran.pid, signal.SIGKILL)
            return False


def noticed_nearby(source, build, suites, name):
    """Returns the suite that notices the fault among those that match the file, None if none does, False if it does not compile."""
    if not builds(build, PROGRAMS[Path(name).parts[0]][0]):
        return False
    return first_of(build, fitting(source, suites, name))


class Altered:
    """Puts faults into the sources on entry and restores them on exit."""

    def __init__(self, source, places):
        self.files = {source / name: (source / name).read_text() for name, *_ in places}
        self.places = [(source / place[0], *place[1:]) for place in places]

    def __enter__(self):
        # From the end, so that a replacement does not move the places of the others.
        for path, number, begin, end, new in sorted(self.places, reverse=True, key=lambda place: place[:3]):
            lines = path.read_text().split("\n")
            lines[number] = lines[number][:begin] + new + lines[number][end:]
            path.write_text("\n".join(lines))

    def __exit__(self, *_):
        for path, text in self.files.items():
            path.write_text(text)


def tried(source, build, suites, place):
    """Tries a fault with the tests that match its file; returns the record of the result, or None if it does not compile."""
    name, number, begin, end, new = place
    old = (source / name).read_text().split("\n")[number]
    result = {"place": place, "file": name, "line": number + 1, "old": old.strip(),
              "new": (old[:begin] + new + old[end:]).strip()}
    with Altered(source, [place]):
        begun = time.monotonic()
        result["by"] = noticed_nearby(source, build, suites, name)
        result["seconds"] = round(time.monotonic() - begun)
    return None if result["by"] is False else result


def tried_together(source, build, suites, left, record):
    """Runs all tests with all faults at once that the matching tests did not notice; then runs the tests that failed with each fault."""
    if not left:
        return
    known = [json.loads(line) for line in record.read_text().splitlines()] if record.exists() else []

    def remember(entry):
        with record.open("a") as out:
            out.write(json.dumps(entry) + "\n")
        known.append(entry)

    asked = [list(result["place"]) for result in left]
    if not known or known[0]["places"] != asked:
        record.unlink(missing_ok=True)
        known.clear()
        # Of two faults in one line, the second could be misplaced by the first, or one could remove what the other
        # replaces.
        lines = [tuple(place[:2]) for place in asked]
        apart = [place for place, line in zip(asked, lines) if lines.count(line) == 1]
        with Altered(source, apart):
            if not builds(build):
                sys.exit("the faults that are left do not build together")
            failed = [test.split(" ")[0] for test in failures(build)]
        remember({"places": asked, "failed": failed})
    print("with all that are left, these fail: " + " ".join(known[0]["failed"]), file=sys.stderr, flush=True)
    if not known[0]["failed"]:
        return
    for number, result in enumerate(left):
        if number + 1 >= len(known):
            with Altered(source, [result["place"]]):
                begun = time.monotonic()
                groups = likely_first(source, suites, known[0]["failed"], result["file"])
                by = noticed_in_turn(source, build, suites, groups)
                remember({"by": by, "seconds": round(time.monotonic() - begun)})
        result["by"] = known[number + 1]["by"]
        result["seconds"] += known[number + 1]["seconds"]
        print(f"{result['file']}:{result['line']}: {result['by'] or 'SURVIVED'}", file=sys.stderr, flush=True)


def table(results):
    print("| place | fault | noticed by | s |\n| --- | --- | --- | --: |")
    for one in results:
        fault = f"`{one['old']}` -> `{one['new']}`".replace("|", "\\|")
        print(f"| {one['file']}:{one['line']} | {fault} | {one['by'] or '**survived**'} | {one['seconds']} |")
    noticed = sum(1 for one in results if one["by"])
    print(f"\n{noticed} of {len(results)} faults noticed ({100 * noticed / max(1, len(results)):.0f}%).")


def main():
    folder, count, seed = Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])
    rule = sys.argv[4] if len(sys.argv) > 4 else None
    # The build folder lies within the sources as in a checkout, so that the compiler cache is hit.
    source = folder / "source"
    build = source / "build"
    record = folder / f"seed-{seed}{'-' + rule if rule else ''}.jsonl"
    # A fault may exhaust the memory.
    most = resource.getrlimit(resource.RLIMIT_AS)[1]
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY if most < 0 else min(MEMORY, most), most))
    passed = folder / "passed"  # marks that all tests pass without a fault
    if refresh(source):
        for stale in (passed, record, record.with_suffix(".together.jsonl")):
            stale.unlink(missing_ok=True)
    configure(source, build)
    done = [json.loads(line) for line in record.read_text().splitlines()] if record.exists() else []
    places, suites = candidates(source), suites_of(source)
    if rule is not None and rule not in places:
        sys.exit(f"--rule {rule}: there are {', '.join(sorted(places))}")
    rules = [rule] if rule else sorted(places)
    count = min(count, len(set(sum((places[name] for name in rules), []))))
    if not builds(build):
        sys.exit("without a fault: it does not build")
    if not passed.exists():
        if failed := first_failure(build):
            sys.exit(f"without a fault: {failed} fails")
        passed.touch()
    drawn, seen, results = random.Random(seed), set(), []
    while len(results) < count and len(seen) < sum(len(places[name]) for name in rules):
        # Each rule is chosen equally often, however many places it applies to.
        place = drawn.choice(places[drawn.choice(rules)])
        if place in seen:
            continue
        seen.add(place)
        if len(seen) <= len(done):
            result = done[len(seen) - 1]
        else:
            result = tried(source, build, suites, place) or {}
            with record.open("a") as out:
                out.write(json.dumps(result) + "\n")
        if result:
            results.append(result)
            print(f"{len(results)}/{count} {result['file']}:{result['line']}: {result['by'] or 'not by those that fit'}",
                  file=sys.stderr, flush=True)
    left = [result for result in results if not result["by"]]
    tried_together(source, build, suites, left, record.with_suffix(".together.jsonl"))
    table(results)


if __name__ == "__main__":
    main()
