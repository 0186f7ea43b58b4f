"""Faults of one line in the sources: their rules, places and draw, and a copy of the sources that holds them on conditions.

Used by mutants.py.
"""

import random
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PARTS = ("CMakeLists.txt", "README.md", "algorithms", "app", "datasets", "tests", "ui")
FOLDERS = ("algorithms", "app", "ui")

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

# Included by every source that has a fault.
SWITCHES = """#pragma once
#include <cstdlib>
struct ReliefFaults {
    bool on[10000] = {};
    ReliefFaults() {
        for (const char* at = std::getenv("RELIEF_FAULTS"); at != nullptr && *at != '\\0';) {
            char* end = nullptr;
            const long fault = std::strtol(at, &end, 10);
            if (fault >= 0 && fault < 10000) { on[fault] = true; }
            at = *end == ',' ? end + 1 : "";
        }
    }
};
inline const ReliefFaults reliefFaults;
"""
STATEMENT = re.compile(r"(?:return|else|case|throw)\b")


def code_lines(text):
    """Yields (number, line) of the lines that are code: not comments or directives, without string literals."""
    block = False
    for number, line in enumerate(text.split("\n")):
        bare = line.strip()
        if block or bare.startswith(("/*", "*")):
            block = "*/" not in bare and (block or bare.startswith("/*"))
        elif bare and not bare.startswith(("//", "#")) and '"' not in bare and "assert(" not in bare:
            yield number, line


def candidates():
    """Returns for each rule all its places, as (file, line, begin, end, replacement)."""
    found = {}
    for folder in FOLDERS:
        for path in sorted((ROOT / folder).rglob("*")):
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
                            place = (str(path.relative_to(ROOT)), number, *match.span(), other)
                            found.setdefault(name, []).append(place)
    return found


def blanked(text):
    """Returns the text, of the same length, with comments, quoted text and the operators that contain < or > replaced by dots."""
    quiet = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|(?<!\w)\'(?:\\.|[^\'\\\n])+\'|->|(?<= )(?:<<|>>|<|>)(?==? )', re.DOTALL)
    return quiet.sub(lambda m: re.sub(r"[^\n]", ".", m.group()), text)


def expression_end(code, at, depth):
    """Returns where the expression that contains the position `at` ends; `depth` brackets are open there."""
    for at in range(at, len(code)):
        here = code[at]
        if here in "([{<":
            depth += 1
        elif here in ")]}>":
            depth -= 1
        if depth < 0 or depth == 0 and (here in ";,?" or (here == ":" and ":" not in (code[at - 1], code[at + 1]))):
            return at
    return len(code)


def expression_begin(code, at):
    """Returns where the expression that contains the position `at` begins."""
    depth = closed = 0
    for at in range(at, 0, -1):
        here, rest = code[at - 1], code[at:at + 7]
        if here in ")]}>":
            if depth == 0:
                if here == "}" and re.match(r"\s*\n", rest):
                    return at
                closed = at
            depth += 1
        elif here in "([{<":
            depth -= 1
            if depth < 0:
                return at
            if depth == 0 and here == "(" and re.search(r"\b(?:if|while|for|switch)(?: constexpr)? $", code[max(0, at - 20):at - 1]):
                return closed
        elif depth == 0:
            if here in ";,?" or (here == ":" and code[at - 2] != ":" and rest[0] != ":"):
                return at
            if here == "=" and rest[0] != "=" and re.search(r" (?:[-+*/%|&^]|\.\.)?=$", code[at - 4:at]):
                return at
            if (word := STATEMENT.match(rest)) and not re.match(r"\w", here):
                return at + word.end()
    return 0


def conditional(text, place, fault):
    """Returns the change (begin, end, replacement) of the text that makes the fault depend on its switch, or None."""
    _, number, begin, end, new = place
    lines = text.split("\n")
    start = sum(len(line) + 1 for line in lines[:number])
    begin, end = start + begin, start + end
    switch = f"::reliefFaults.on[{fault}]"
    code = blanked(text)
    old = code[begin:end]
    if re.match(r"(?:float|double) k\w* = ", old):  # a margin
        value = text[begin:end].split(" = ", 1)
        word = begin - len("constexpr ")
        return word, end, f"const {value[0]} = ({switch} ? {new.split('= ')[1]} : {value[1]})"
    if re.match(r" *if \(", old):  # a check
        condition = begin + old.index("(") + 1
        close = next(at for at in range(condition, end) if code.count("(", condition, at) < code.count(")", condition, at + 1))
        if re.search(r"; | = ", code[condition:close]):
            return None
        return condition, close, f"!{switch} && ({text[condition:close]})"
    opened = sum(old.count(c) for c in "([{") - sum(old.count(c) for c in ")]}")
    first, last = expression_begin(code, begin), expression_end(code, end, opened)
    while text[first].isspace():
        first += 1
    return first, last, f"({switch} ? {text[first:begin]}{new}{text[end:last]} : {text[first:last]})"


def sources():
    """Returns the files of the checkout that the copy holds, by their names."""
    files = {}
    for part in PARTS:
        for file in [ROOT / part] if (ROOT / part).is_file() else sorted((ROOT / part).rglob("*")):
            if file.is_file() and "__pycache__" not in file.parts:
                files[str(file.relative_to(ROOT))] = file
    return files


def with_faults(source, name, faults):
    """Returns the text of a source with the faults that lie in it, each on its condition."""
    text = (ROOT / name).read_text()
    changes = [conditional(text, place, fault) for fault, place in faults.items() if place[0] == name]
    for begin, end, new in sorted(changes, reverse=True):
        text = text[:begin] + new + text[end:]
    return f'#include "{source}/relief_faults.h"\n#line 1\n' + text


def write_copy(source, faults):
    """Brings the copy to the state of the checkout with the faults. Equal files are not touched."""
    files = sources()
    faulty = {place[0] for place in faults.values()}
    source.mkdir(parents=True, exist_ok=True)
    switches = source / "relief_faults.h"
    if not switches.exists() or switches.read_text() != SWITCHES:
        switches.write_text(SWITCHES)
    for name, file in files.items():
        wanted = with_faults(source, name, faults).encode() if name in faulty else file.read_bytes()
        to = source / name
        if not to.exists() or to.read_bytes() != wanted:
            to.parent.mkdir(parents=True, exist_ok=True)
            to.write_bytes(wanted)
            to.chmod(file.stat().st_mode)
    for part in PARTS:
        for file in (source / part).rglob("*"):
            if file.is_file() and str(file.relative_to(source)) not in files:
                file.unlink()


class Draw:
    """Faults drawn by a seed, by their numbers from 1; those that do not compile are replaced."""

    def __init__(self, seed, rule):
        self.places = candidates()
        if rule is not None and rule not in self.places:
            sys.exit(f"--rule {rule}: there are {', '.join(sorted(self.places))}")
        self.rules = [rule] if rule else sorted(self.places)
        self.random, self.seen, self.faults, self.taken, self.last = random.Random(seed), set(), {}, {}, 0

    def fill(self, count):
        """Draws until there are so many faults, or no place is left. No two faults lie in one line or one expression."""
        every = len(set(sum((self.places[name] for name in self.rules), [])))
        while len(self.faults) < count and len(self.seen) < every:
            # Each rule is chosen equally often, however many places it applies to.
            place = self.random.choice(self.places[self.random.choice(self.rules)])
            if place in self.seen:
                continue
            self.seen.add(place)
            text = (ROOT / place[0]).read_text()
            change = conditional(text, place, 0)
            if change is None:
                continue
            lines = range(text.count("\n", 0, change[0]), text.count("\n", 0, change[1]) + 1)
            taken = self.taken.setdefault(place[0], set())
            if taken.isdisjoint(lines):
                taken.update(lines)
                self.last += 1
                self.faults[self.last] = place

    def drop(self, errors):
        """Drops the faults that lie where the compiler reports errors, given as (file, line); returns their number."""
        def near(apart):
            return {fault for fault, (name, number, *_) in self.faults.items()
                    for file, line in errors if file == name and abs(number + 1 - line) <= apart}
        dropped = near(3) or near(1 << 30)
        for fault in dropped:
            del self.faults[fault]
        return len(dropped)
