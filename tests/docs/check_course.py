#!/usr/bin/env python3
"""Holds the shipped course to its rules, and looks for every method, filter, row method and map in it.

    check_course.py SOURCES BIN

Whether the claims of a lesson hold is not checked here: `reliefscope --lesson all --check` measures them.
"""
import glob
import json
import os
import re
import subprocess
import sys

root, relief = os.path.abspath(sys.argv[1]), os.path.join(os.path.abspath(sys.argv[2]), "relief")
faults = []
LESSONS, CHAPTERS, PAGES, WORDS = 27, 7, 4, 60
VALUE = re.compile(r"\{[^{}]*\}")


def strings(value):
    """Yields all strings in a JSON value."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, (dict, list)):
        for child in value.values() if isinstance(value, dict) else value:
            yield from strings(child)


def chosen(value, keys):
    """Yields the names that stand under these keys: "filter": "trilinear", "methods": [{"name": "cone"}]."""
    for key, child in value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ():
        if key in keys:
            entries = child if isinstance(child, list) else [child]
            yield from (entry.get("name", "") if isinstance(entry, dict) else entry for entry in entries if entry)
        yield from chosen(child, keys)


def sections(text):
    return re.findall(r"^(?:## \w+:|### \w+)", text, re.MULTILINE)


met = {"tracers": set(), "filters": set(), "rows": set(), "code": set()}
folders = sorted(os.path.dirname(file) for file in glob.glob(os.path.join(root, "ui/lessons/*/lesson.json")))
for folder in folders:
    name = os.path.basename(folder)
    lesson = json.load(open(os.path.join(folder, "lesson.json"), encoding="utf-8"))
    texts = {}
    for language in ("en", "uk"):
        texts[language] = open(os.path.join(folder, f"text.{language}.md"), encoding="utf-8").read()
        text = texts[language]
        for part in ("remember", "note", "source", "hint", "question", "knob"):
            if f"### {part}\n" not in text:
                faults.append(f"{name}: {language}: no {part}")
        for page in re.split(r"^## ", text, flags=re.MULTILINE)[1:]:
            title, _, body = page.partition("\n")
            # A value that is filled in is one word.
            words = len(VALUE.sub("N", body.split("\n### ")[0]).split())
            if words > WORDS:
                faults.append(f"{name}: {language}: {title}: {words} words, at most {WORDS}")
        met["code"].update(word for code in re.findall(r"`([^`]*)`", text) for word in code.split())
    if sections(texts["en"]) != sections(texts["uk"]):
        faults.append(f"{name}: the two languages have other pages or sections")
    if sorted(VALUE.findall(texts["en"])) != sorted(VALUE.findall(texts["uk"])):
        faults.append(f"{name}: the two languages fill in other values")
    if len(lesson["pages"]) < PAGES:
        faults.append(f"{name}: {len(lesson['pages'])} pages, at least {PAGES}")
    if "color" not in lesson["scenario"]["pictures"]:
        faults.append(f"{name}: its scene has no colour picture")
    names = [page["name"] for page in lesson["pages"]] + list(lesson.get("variants", {}))
    if len(names) != len(set(names)):
        faults.append(f"{name}: a page and a variant share a name")
    for page in lesson["pages"]:
        if not page.get("claims") and "question" not in page:
            faults.append(f"{name}: {page['name']}: nothing is claimed")
    met["tracers"].update(chosen(lesson, ("method", "methods")))
    met["filters"].update(chosen(lesson, ("filter", "filters")))
    mapped = list(chosen(lesson, ("mapping", "mappings")))
    mapped += [row for value in strings(lesson) for row in re.findall(r"rows\.\w+\('([^']*)'", value)]
    met["rows"].update(str(row).split(":")[0] for row in mapped)

chapters = {os.path.basename(folder)[0] for folder in folders}
if len(folders) < LESSONS or len(chapters) < CHAPTERS:
    faults.append(f"{len(folders)} lessons in {len(chapters)} chapters, at least {LESSONS} in {CHAPTERS}")

listed = json.loads(subprocess.run([relief, "list", "--json"], capture_output=True, check=True).stdout)
for kind in ("tracers", "filters", "rows"):
    faults += [f"no lesson shows {entry['name']} ({kind})" for entry in listed[kind] if entry["name"] not in met[kind]]
# A map is met with the tracer that builds it; other maps, and any-hit queries, are named in the words.
for kind in ("any_hit", "maps"):
    faults += [f"no lesson names {entry['name']} ({kind})" for entry in listed[kind]
               if entry["name"] not in met["code"] and entry.get("tracer") not in met["tracers"]]

print("\n".join(faults) if faults else f"{len(folders)} lessons: all rules hold, everything listed is met")
sys.exit(1 if faults else 0)
