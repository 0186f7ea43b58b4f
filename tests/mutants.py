#!/usr/bin/env python3
"""Puts faults of one line into the sources, one at a time, and tells which of them the tests notice.

    tests/mutants.py FOLDER N SEED [RULE]      called by: tests/run --mutants N [--seed S] [--rule RULE]

FOLDER gets a copy of the sources (source/), its build (build/) and what was found, a line of JSON a fault, in
seed-SEED.jsonl (with a rule, seed-SEED-RULE.jsonl): a run that was stopped goes on from there; with other sources,
remove that file. Faults are drawn by RULES, or by one of them, from the .cpp and .h files of algorithms/, app/ and ui/.
First the tests run whose files fit by name, then those of the same folder, then those of the same library, then all
others, until one fails; what does not compile is drawn anew. At the end a table with the faults that no test noticed.
"""

import filecmp
import json
import random
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

# Seconds after which a test has failed: a fault may be a loop without end. Of tests that fit, and of all.
PATIENCE_NEAR, PATIENCE = 150, 600
# The test program that a folder's faults are tried with first, and its tests.
PROGRAMS = {"algorithms": ("relief_tests", "algorithms"), "app": ("relief_cmd_tests", "cmd"),
            "ui": ("reliefui_tests", "ui")}
# Not of what the program does: a fault may put a line out of form.
NOT_TESTS = r"^(format)$"

NAME = r"[A-Za-z_][\w.]*(?:\[\w+\])?"
# Name, what is replaced, by what. Binary operators have blanks beside them (clang-format), angle brackets of templates
# do not.
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
    # Of all constants, those that keep a decision safe (algorithms/relief/margins.md).
    ("margin", r"(?<=constexpr )(?:float|double) k\w*(?:Margin|Slack|Shorter\w*|Steeper|Round\w*|Off\w*|Inside|Late|Away|"
               r"Aside|Nudge|Unsure|Clearance|Start) = [^;]+(?=;)",
     lambda m: m.group().split("=")[0] + ("= 1" if re.search(r"= 1 [+-]", m.group()) else "= 0")),
    ("swapped", rf"(?<=[\w>]\()({NAME}), ({NAME})(?=\))", r"\2, \1"),
    ("key", rf" (?:\|\||&&|\|) {NAME}(?:\([\w:]*\))?(?: == {NAME})?(?=[;)])", ""),
    ("check", r"^ *if \([^{}]*\) (?:return\b[^;]*|continue|break|throw [^;]*);$", ""),
]


def code_lines(text):
    """(number, line) of those that are code: no comment, no directive, no text in quotes."""
    block = False
    for number, line in enumerate(text.split("\n")):
        bare = line.strip()
        if block or bare.startswith(("/*", "*")):
            block = "*/" not in bare and (block or bare.startswith("/*"))
        elif bare and not bare.startswith(("//", "#")) and '"' not in bare and "assert(" not in bare:
            yield number, line


def candidates(source):
    """By rule: all places, as (file, line, from, to, what stands there then)."""
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
    """Suite to its test file, as ctest names both."""
    suites = {}
    for path in sorted((source / "tests").rglob("*_test.cpp")):
        for name in re.findall(r"^(?:TEST|TEST_F|TEST_P)\((\w+),", path.read_text(), re.MULTILINE):
            suites[name] = path
    return suites


def fitting(source, suites, mutated):
    """Two lists of suites: whose file fits the mutated one by name or includes it; those of the same folder."""
    file = Path(mutated)
    stem = re.sub(r"(_lanes|-inl)$", "", file.stem)
    include = '"' + str(Path(*file.parts[1:])).removesuffix(".cpp").removesuffix(".h") + '.h"'
    folder = source / "tests" / file.parent
    while not folder.exists():
        folder = folder.parent
    near, beside = [], []
    for suite, path in suites.items():
        if path.stem.startswith(stem) or include in path.read_text():
            near.append(suite)
        elif path.parent == folder:
            beside.append(suite)
    return near, beside


def refresh(source):
    """The copy is what the checkout is; files that are the same stay, so that they are not built again."""
    root = Path(__file__).resolve().parent.parent
    for name in ("CMakeLists.txt", "README.md", "algorithms", "app", "datasets", "tests", "ui"):
        files = [root / name] if (root / name).is_file() else [p for p in (root / name).rglob("*") if p.is_file()]
        wanted = {file.relative_to(root) for file in files}
        for file in wanted:
            to = source / file
            if not to.exists() or not filecmp.cmp(root / file, to, shallow=False):
                to.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(root / file, to)
        for file in (source / name).rglob("*"):
            if file.is_file() and file.relative_to(source) not in wanted:
                file.unlink()


def configure(source, build):
    command = ["cmake", "-G", "Ninja", "-S", str(source), "-B", str(build), "-DRELIEF_TESTS=ON",
               "-DCMAKE_BUILD_TYPE=Release"]
    if subprocess.run(command, stdout=subprocess.DEVNULL, stdin=subprocess.DEVNULL).returncode != 0:
        sys.exit("the copy of the sources could not be configured")


def named(suites):
    return r"^(window\.)?(\w+/)?(" + "|".join(sorted(suites)) + ")$"


def first_failure(build, patience, only=None, without=()):
    """The suite that fails, or None. only: these suites; without: all but these."""
    if only is not None and not only:
        return None
    command = ["ctest", "--test-dir", str(build), "--stop-on-failure", "--timeout", str(patience), "-j2",
               "-E", "|".join([NOT_TESTS] + ([named(without)] if without else []))]
    if only is not None:
        command += ["-R", named(only)]
    ran = subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL)
    line = next((line for line in ran.stdout.split("\n") if "***" in line), None)
    if line is None:
        return None
    name = re.search(r"Test +#\d+: (\S+)", line).group(1)
    return name + (" (no end)" if "***Timeout" in line else "")


def builds(build, *programs):
    """Whether it builds; the build runs the test programs to list their tests, so it may not end either."""
    try:
        command = ["ninja", "-C", str(build), *programs]
        ran = subprocess.run(command, capture_output=True, stdin=subprocess.DEVNULL, timeout=3 * PATIENCE)
        return ran.returncode == 0
    except subprocess.TimeoutExpired:
        return False


def noticed_by(source, build, suites, name):
    """The suite that notices the fault in a file, or None; False: it does not compile."""
    program, folder = PROGRAMS[Path(name).parts[0]]
    if not builds(build, program):
        return False
    near, beside = fitting(source, suites, name)
    whole = [suite for suite, path in suites.items() if path.is_relative_to(source / "tests" / folder)]
    rest = [suite for suite in whole if suite not in near + beside]
    by = (first_failure(build, PATIENCE_NEAR, near) or first_failure(build, PATIENCE_NEAR, beside)
          or first_failure(build, PATIENCE, rest))
    if by:
        return by
    return first_failure(build, PATIENCE, without=whole) if builds(build) else False


def tried(source, build, suites, place):
    """What became of a fault; None: it does not compile."""
    name, number, begin, end, new = place
    path = source / name
    text = path.read_text()
    lines = text.split("\n")
    old = lines[number]
    lines[number] = old[:begin] + new + old[end:]
    result = {"file": name, "line": number + 1, "old": old.strip(), "new": lines[number].strip()}
    path.write_text("\n".join(lines))
    try:
        begun = time.monotonic()
        result["by"] = noticed_by(source, build, suites, name)
        result["seconds"] = round(time.monotonic() - begun)
        if result["by"] is False:
            return None
    finally:
        path.write_text(text)
    return result


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
    source, build = folder / "source", folder / "build"
    record = folder / f"seed-{seed}{'-' + rule if rule else ''}.jsonl"
    refresh(source)
    configure(source, build)
    done = [json.loads(line) for line in record.read_text().splitlines()] if record.exists() else []
    places, suites = candidates(source), suites_of(source)
    if rule is not None and rule not in places:
        sys.exit(f"--rule {rule}: there are {', '.join(sorted(places))}")
    rules = [rule] if rule else sorted(places)
    count = min(count, len(set(sum((places[name] for name in rules), []))))
    if not builds(build):
        sys.exit("without a fault: it does not build")
    if not done and (failed := first_failure(build, PATIENCE)):
        sys.exit(f"without a fault: {failed} fails")
    drawn, seen, results = random.Random(seed), set(), []
    while len(results) < count and len(seen) < sum(len(places[name]) for name in rules):
        # Each rule as often as any other, however many places it has.
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
            print(f"{len(results)}/{count} {result['file']}:{result['line']}: {result['by'] or 'SURVIVED'}",
                  file=sys.stderr, flush=True)
    table(results)


if __name__ == "__main__":
    main()
