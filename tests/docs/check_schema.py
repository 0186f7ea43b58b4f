#!/usr/bin/env python3
"""Validates scenarios, lessons and figures of papers against their JSON Schemas, and the schemas against the program.

    check_schema.py SOURCES BIN

All stored and shipped scenarios, and those that the program writes, must be valid; scenarios that the program refuses must be
invalid. Exit status 77 if python3-jsonschema is not installed.
"""
import copy
import glob
import json
import os
import shutil
import subprocess
import sys
import tempfile

try:
    import jsonschema
except ImportError:
    print("python3-jsonschema is not there: scenarios are not validated")
    sys.exit(77)

root, relief = os.path.abspath(sys.argv[1]), os.path.join(os.path.abspath(sys.argv[2]), "relief")
schema = json.load(open(os.path.join(root, "algorithms/scenario/scenario.schema.json"), encoding="utf-8"))
jsonschema.Draft7Validator.check_schema(schema)
validator = jsonschema.Draft7Validator(schema)
faults = []


def read(path):
    """Returns the scenario of a file; reports contain one."""
    content = json.load(open(path, encoding="utf-8"))
    return content.get("scenario", content)


def read_lesson(path):
    return json.load(open(path, encoding="utf-8"))


def expect_valid(scenario, what):
    for error in validator.iter_errors(scenario):
        faults.append(f"{what}: {'/'.join(map(str, error.path))}: {error.message}")


def with_value(document, path, value):
    """Returns a copy with the value at the path; objects on the way that are missing are made."""
    changed = copy.deepcopy(document)
    place = changed
    for key in path[:-1]:
        place = place[key] if isinstance(place, list) else place.setdefault(key, {})
    place[path[-1]] = value
    return changed


def expect_refused(good, values, file, command, checker, what):
    """Writes the document with each value at its path to the file; the program's command and the schema must refuse it."""
    for path, value in values.items():
        changed = with_value(good, path, value)
        json.dump(changed, open(file, "w", encoding="utf-8"))
        if subprocess.run(command, capture_output=True).returncode != 2:
            faults.append(f"the program takes {path} = {value}")
        if checker.is_valid(changed):
            faults.append(f"the schema of {what} takes {path} = {value}")


def objects(scenario, path=()):
    """Yields all nested objects with their paths."""
    if isinstance(scenario, dict):
        yield path
    children = scenario.items() if isinstance(scenario, dict) else enumerate(scenario) if isinstance(scenario, list) else ()
    for key, child in children:
        yield from objects(child, path + (key,))


patterns = ["tests/files/v1/*.json", "tests/files/v1/*/*.json", "ui/lessons/*.json", "app/manual/*.json"]
files = [f for p in patterns for f in glob.glob(os.path.join(root, p)) if "/traced/" not in f and "/tables/" not in f and not f.endswith("/course.json")]
for file in files:
    expect_valid(read(file), os.path.relpath(file, root))
if len(files) < 60:
    faults.append(f"only {len(files)} scenarios were found")

with tempfile.TemporaryDirectory() as folder:
    def render(*arguments):
        return subprocess.run([relief, "render", "-q", *arguments, "--size", "32x24", "-o", os.path.join(folder, "x.png")],
                              capture_output=True, text=True)

    # Scenarios that the program writes, with options that add keys to the file.
    report = os.path.join(folder, "report.json")
    given = [["--relief", "bricks:16x16:3", "--scene", "cube", "--shadows", "--no-skip", "--bounded", "0.5", "--mapping", "affine"],
             ["--relief", "drawn:2x2:0,1,0.5,1", "--eye", "0.5,0.6,0.7", "--target", "0,0,0", "--address", "border"],
             ["--relief", "hills:16x16", "--filter", "elliptical:sigma=0.6", "--tracer", "layers", "--set", "layers=9"],
             ["--relief", "city:16x16", "--supersample", "3", "--pixel-model", "lcd", "--surface", "columns"]]
    for arguments in given:
        done = render(*arguments, "--report", report)
        if done.returncode != 0:
            faults.append(done.stderr)
        else:
            expect_valid(read(report), " ".join(arguments))

    # Faults that the program refuses: an unknown key anywhere but among options and the window's state, and values out
    # of range.
    everything = read(os.path.join(root, "tests/files/v1/written/everything.json"))
    refused = 0
    wrong = {("relief", "depth"): 5, ("camera", "fov"): 171, ("scene",): "ceiling", ("size",): [0, 3], ("reliefscope",): 2,
             ("method", "name"): "coen", ("relief", "address"): "mirror", ("light", "ambient"): "much", ("sky",): [0, 1],
             ("pictures", "recipe", "name"): "ctiy", ("pictures", "max-pixels"): 0, ("step",): -1,
             ("compare", "rate"): 100, ("supersample",): 65, ("pictures", "invert"): 1}
    mutants = [(path + ("unknown",), 1) for path in objects(everything)
               if not {"options", "filter-options"} & set(path) and path[:1] not in (("ui",), ("panes",))]
    recipes = [(("pictures", "recipe"), recipe) for recipe in ({"name": "city", "width": 0}, {"name": "city", "height": 32769}, {})]
    for path, value in mutants + list(wrong.items()) + recipes:
        scenario = with_value(everything, path, value)
        file = os.path.join(folder, "mutant.json")
        json.dump(scenario, open(file, "w", encoding="utf-8"))
        program = subprocess.run([relief, "info", file], capture_output=True, text=True).returncode
        if program != 2:
            faults.append(f"the program takes {path} = {value}")
        if validator.is_valid(scenario):
            faults.append(f"the schema takes {path} = {value}")
        refused += 1

# Lessons: lesson.json of the shipped ones with the scenarios in it; changed ones, which schema and program refuse.
lesson_schema = json.load(open(os.path.join(root, "algorithms/scenario/lesson.schema.json"), encoding="utf-8"))
jsonschema.Draft7Validator.check_schema(lesson_schema)
lesson_validator = jsonschema.Draft7Validator(lesson_schema)
lessons = sorted(glob.glob(os.path.join(root, "ui/lessons/*/lesson.json")))
for file in lessons:
    lesson, what = read_lesson(file), os.path.relpath(file, root)
    for error in lesson_validator.iter_errors(lesson):
        faults.append(f"{what}: {'/'.join(map(str, error.path))}: {error.message}")
    expect_valid(lesson["scenario"], what)
reliefscope = os.path.join(os.path.dirname(relief), "reliefscope")
if os.path.exists(reliefscope):
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(os.path.join(root, "ui/lessons/302"), os.path.join(folder, "302"))
        file = os.path.join(folder, "302", "lesson.json")
        good = read_lesson(file)
        expect_refused(good, {("lesson",): 2, ("minutes",): 0, ("unknown",): 1, ("pages",): [], ("pages", 0, "unknown"): 1,
                            ("pages", 0, "pane"): "profil", ("pages", 0, "step"): 0, ("pages", 0, "name"): "a b",
                            ("pages", 0, "layer"): "colour", ("pages", 0, "claims"): [1], ("variants", "a b"): {},
                            ("pages", 2, "knob", "values"): ["8"], ("pages", 2, "knob", "set"): "method",
                            ("pages", 2, "knob", "watch", 0, "trend"): "grows",
                            ("pages", 1, "question"): {"ask": 1}},
                       file, [reliefscope, "--lesson", os.path.dirname(file), "--check"], lesson_validator, "lessons")

# Figures of the papers: the shipped ones with their scenarios; changed ones, which schema and program refuse.
figure_schema = json.load(open(os.path.join(root, "algorithms/scenario/paper_figure.schema.json"), encoding="utf-8"))
jsonschema.Draft7Validator.check_schema(figure_schema)
figure_validator = jsonschema.Draft7Validator(figure_schema)
figures = sorted(glob.glob(os.path.join(root, "ui/paper_figures/*.json")))
for file in figures:
    figure, what = json.load(open(file, encoding="utf-8")), os.path.relpath(file, root)
    for error in figure_validator.iter_errors(figure):
        faults.append(f"{what}: {'/'.join(map(str, error.path))}: {error.message}")
    expect_valid(figure["scenario"], what)
if os.path.exists(reliefscope):
    words = subprocess.run([reliefscope, "--help"], capture_output=True, text=True, check=True).stdout.split("VIEW:")[1].split("  --")[0]
    views = sorted(word for word in words.replace("(PNG alone)", "").replace(",", " ").split() if word != "pareto")
    if views != figure_schema["properties"]["parts"]["items"]["properties"]["view"]["enum"]:
        faults.append(f"paper_figure.schema.json: the program's views are\n    {json.dumps(views)}")
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "mine.json")
        good = json.load(open(os.path.join(root, "ui/paper_figures/MIP18-4.json"), encoding="utf-8"))
        expect_refused(good, {("paper-figure",): 2, ("paper",): "", ("number",): 0, ("page",): -1, ("unknown",): 1, ("parts",): [],
                            ("caption", "uk"): "", ("note",): {"en": "x"}, ("parts", 0, "view"): "pareto", ("parts", 0, "width"): 1,
                            ("parts", 0, "layer"): "colour", ("parts", 0, "change"): 1, ("parts", 0, "unknown"): 1},
                       file, [reliefscope, "--paper-figures", file], figure_validator, "figures")

# Names of the lists.
listed = json.loads(subprocess.run([relief, "list", "--json"], capture_output=True, text=True, check=True).stdout)
for key, names in (("tracers", schema["definitions"]["method"]["properties"]["name"]["enum"]),
                   ("filters", schema["properties"]["filter"]["enum"]),
                   ("reliefs", schema["properties"]["pictures"]["properties"]["recipe"]["properties"]["name"]["enum"])):
    program = [entry["name"] for entry in listed[key]]
    if program != names:
        missing, extra = [n for n in program if n not in names], [n for n in names if n not in program]
        faults.append(f"scenario.schema.json, {key}: missing {missing}, not in the program {extra}; the program's order is\n"
                      f"    {json.dumps(program)}")

print("\n".join(faults))
print(f"{len(lessons)} lessons, {len(figures)} figures of papers, {len(files)} scenarios of files and {len(given)} written are valid, {refused} changed ones refused: {len(faults)} faults")
sys.exit(1 if faults else 0)
