#!/usr/bin/env python3
"""Builds the manual in HTML: the guide's pages, the methods, the commands and the public headers, by Doxygen.

    build.py SOURCES OUT DOXYGEN RELIEF      writes OUT/html/index.html

Exit status 1 if Doxygen warns. Pages and headers are first copied to OUT/pages in the form that Doxygen reads: links between pages
become references, plain comments become Doxygen comments.
"""
import json
import os
import re
import shutil
import subprocess
import sys

root, out, doxygen, relief = sys.argv[1:5]
pages = os.path.join(out, "pages")

# The pages of the guide in the order of the navigation. Page identifiers are derived from the folders' names.
GUIDE = ["README.md", "app/README.md", "ui/README.md", "algorithms/CONCEPTS.md", "algorithms/scenario/FORMATS.md",
         "algorithms/README.md", "algorithms/notation.md", "algorithms/relief/README.md", "algorithms/SIMD.md",
         "algorithms/relief/margins.md", "datasets/README.md", "tests/README.md", "tests/benchmarks/RESULTS.md",
         "tests/benchmarks/EXPERIMENTS.md", "tests/benchmarks/build_time.md", "tests/uncovered.md",
         "app/manual/SHADERS.md", "app/manual/SECURITY.md", "app/manual/CHANGELOG.md", "app/manual/CONTRIBUTING.md",
         "app/manual/CITATION.md"]
# Pages that stand below another one in the navigation.
BELOW = {"algorithms/README.md": ["algorithms/notation.md", "algorithms/relief/README.md", "algorithms/SIMD.md",
                                  "algorithms/relief/margins.md"],
         "tests/README.md": ["tests/benchmarks/RESULTS.md", "tests/benchmarks/EXPERIMENTS.md",
                             "tests/benchmarks/build_time.md", "tests/uncovered.md"],
         "app/README.md": ["app/manual/SHADERS.md", "app/manual/SECURITY.md", "app/manual/CHANGELOG.md",
                          "app/manual/CONTRIBUTING.md", "app/manual/CITATION.md"]}
STYLE = """.contents img { max-width: 100%; height: auto; }
.contents table.markdownTable { display: block; overflow-x: auto; max-width: 100%; }
"""


def page_id(path):
    return "page_" + re.sub(r"\W", "_", os.path.splitext(path)[0]).lower()


def slug(heading):
    """Returns the anchor of a heading, made as in tests/docs/check_documents.py."""
    text = re.sub(r"[^\w\- ]", "", heading.strip().lower().replace("`", ""))
    return text.replace(" ", "-")


def anchor(path, heading):
    return page_id(path) + "_" + re.sub(r"\W", "_", slug(heading))


def link(path, match):
    text, target = match.group(1), match.group(2)
    if re.match(r"[a-z]+:", target):
        return match.group(0)
    file, _, heading = target.partition("#")
    file = os.path.normpath(os.path.join(os.path.dirname(path), file)) if file else path
    if file not in GUIDE:
        return text if text.startswith("`") else f"`{text}`"
    reference = anchor(file, heading) if heading else page_id(file)
    return f'@ref {reference} "{text.replace("`", "")}"'


def guide_page(path):
    """Returns the text of a page with labels on its headings and references in place of links."""
    lines, fence, first = [], False, True
    for line in open(os.path.join(root, path), encoding="utf-8").read().split("\n"):
        if line.startswith("```") or line.startswith("~~~"):
            fence = not fence
        elif not fence and line.startswith("#"):
            marks, heading = line.split(" ", 1)
            line = f"{line.replace('`', '')} {{#{page_id(path) if first else anchor(path, heading)}}}"
            first = False
        elif not fence and not line.startswith("    "):
            line = re.sub(r"!\[([^\]]*)\]\(([^)]+)\)", lambda m: f"![{m.group(1)}]({os.path.basename(m.group(2))})", line)
            line = re.sub(r"(?<!!)\[([^\]]*)\]\(([^)\s]+)\)", lambda m: link(path, m), line)
        lines.append(line)
    below = [f"- @subpage {page_id(page)}" for page in BELOW.get(path, [])]
    return "\n".join(lines + (["", "Further pages:", ""] + below if below else [])) + "\n"


def opening_comment(path):
    """Returns the first comment of a header, with a new paragraph at each empty line and each sentence that begins with a topic."""
    text = ""
    for line in open(os.path.join(root, path), encoding="utf-8"):
        if not line.startswith("//"):
            break
        words = line[2:].strip()
        topic = re.match(r"(Frame and units|Surfaces|Model|Layouts|Walk|Guarantee|Failure mode|Cost|Source|Precision):", words)
        text += ("\n\n" if topic or not words else " ") + words
    text = re.sub(r"(?<=[.;] )(Guarantee|Failure mode|Cost|Surfaces|Fallback|Source):", r"\n\n\1:", text)
    text = re.sub(r"(?m)^\s*([A-Z][a-z ]+):", r"**\1**:", text)
    return re.sub(r"([@\\<>#])", r"\\\1", text).strip()


def header_of(name, kinds):
    base = name.replace("-", "_")
    for folder in kinds:
        for file in (f"{base}.h", f"{base}_filter.h", f"{base.split('_')[0]}.h"):
            if os.path.exists(os.path.join(root, folder, file)):
                return os.path.join(folder, file)
    return None


def number(value):
    return f"{value:g}" if isinstance(value, float) else str(value)


def span(option):
    """Returns the values that an option accepts: a range with its unit, words, or both."""
    words = ", ".join(map(str, option.get("choices") or []))
    if "low" not in option or option["low"] == option.get("high"):
        return words
    numbers = f"{number(option['low'])} to {number(option['high'])} {option.get('unit', '')}".strip()
    return f"{numbers} or {words}" if words else numbers


def list_pages(parent, intro, entries, folders, label):
    """Returns a page for each entry and one that lists them, so that the search and the navigation know them by name."""
    names = [(entry["name"], f"{label}_{entry['name'].replace('-', '_')}") for entry in entries]
    made = {f"page_{parent.lower()}.md": f"# {parent} {{#page_{parent.lower()}}}\n\n{intro}\n\n" +
            "".join(f"- @subpage {page}\n" for _, page in names)}
    for entry, (name, page) in zip(entries, names):
        text = f"# {name + ': ' + entry['title'] if 'title' in entry else name} {{#{page}}}\n\n"
        text += f"{entry['help'][0].upper()}{entry['help'][1:].rstrip('.')}.\n\n"
        facts = {"guarantee": "guarantee", "form": "implementation", "rays": "rays", "source": "source"}
        rows = [(shown, entry[key]) for key, shown in facts.items() if entry.get(key)]
        rows += [(key, ", ".join(entry[key])) for key in ("surfaces", "addresses", "maps") if entry.get(key)]
        header = header_of(name, folders)
        if header:
            rows.append(("header", f"`{header}`"))
        text += "| property | value |\n| --- | --- |\n" + "".join(f"| {a} | {b} |\n" for a, b in rows)
        if header:
            text += "\n" + opening_comment(header) + "\n"
        if entry.get("options"):
            text += "\n| option | values | default | meaning |\n| --- | --- | --- | --- |\n"
            for option in entry["options"]:
                text += f"| `{option['name']}` | {span(option)} | {option.get('default', '')} | {option['help']} |\n"
        made[page + ".md"] = text
    return made


def generated_pages():
    listed = json.loads(subprocess.run([relief, "list", "--json"], capture_output=True, text=True, check=True).stdout)
    made = list_pages("Methods", "What the headers of the methods say, with the options that `relief list` names.",
                      listed["tracers"], ["algorithms/relief/methods", "algorithms/relief/tracers"], "tracer")
    made |= list_pages("Filters", "How colours are sampled (`--filter`).", listed["filters"],
                       ["algorithms/filtering/methods"], "filter")
    page = subprocess.run([relief, "--help"], capture_output=True, text=True, check=True).stdout
    commands = "# Commands {#page_commands}\n\nThe help page of each command, as `relief COMMAND --help` prints it.\n\n"
    commands += "~~~{.unparsed}\n" + page + "~~~\n\n"
    for name, summary in re.findall(r"(?m)^  ([a-z]+) +(.*)", page.split("Commands:")[1].split("\n\n")[0]):
        text = subprocess.run([relief, name, "--help"], capture_output=True, text=True, check=True).stdout
        made[f"command_{name}.md"] = f"# {name}: {summary} {{#command_{name}}}\n\n~~~{{.unparsed}}\n{text}~~~\n"
        commands += f"- @subpage command_{name}\n"
    return made | {"page_commands.md": commands}


def documented(text):
    """Returns the text of a header with its plain comments turned into those that Doxygen reads."""
    def escaped(comment):
        return re.sub(r"([@\\<>#%&])", r"\\\1", comment)

    lines, opening = [], True
    for line in text.split("\n"):
        whole = re.match(r"(\s*)//(?!/)(.*)", line)
        behind = re.match(r"(.*[;,{}])(\s+)//(?!/)(.*)", line)
        if whole and opening:
            lines.append(("/// @file\n///" if not lines else "///") + escaped(whole.group(2)))
        elif whole:
            lines.append(f"{whole.group(1)}///{escaped(whole.group(2))}")
        elif behind and not behind.group(1).rstrip().endswith(("{", "}")):
            lines.append(f"{behind.group(1)}{behind.group(2)}///<{escaped(behind.group(3))}")
        else:
            opening = opening and not line.strip()
            lines.append(line)
    return "\n".join(lines)


def write(name, text):
    path = os.path.join(pages, name)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    open(path, "w", encoding="utf-8").write(text)
    return path


def main():
    shutil.rmtree(out, ignore_errors=True)
    inputs = [write(page_id(path) + ".md", guide_page(path)) for path in GUIDE]
    inputs += [write(name, text) for name, text in generated_pages().items()]
    folder = os.path.join(root, "algorithms/include/relief")
    for name in sorted(os.listdir(folder)):
        if name.endswith(".h"):
            inputs.append(write(f"relief/{name}", documented(open(os.path.join(folder, name), encoding="utf-8").read())))
    shutil.copy(os.path.join(folder, "messages.def"), os.path.join(pages, "relief"))
    style = write("../manual.css", STYLE)
    settings = {
        "PROJECT_NAME": "Reliefscope", "PROJECT_BRIEF": '"Exact relief texturing, every step shown"',
        "OUTPUT_DIRECTORY": f'"{out}"', "INPUT": " ".join(f'"{i}"' for i in inputs),
        "USE_MDFILE_AS_MAINPAGE": f'"{inputs[0]}"', "STRIP_FROM_PATH": f'"{pages}"', "STRIP_FROM_INC_PATH": f'"{pages}"',
        "HTML_EXTRA_STYLESHEET": f'"{style}"',
        "IMAGE_PATH": f'"{root}/app/manual/pictures" "{root}/ui"', "GENERATE_LATEX": "NO", "EXTRACT_ALL": "YES",
        "JAVADOC_AUTOBRIEF": "YES", "AUTOLINK_SUPPORT": "NO", "GENERATE_TREEVIEW": "YES", "TOC_INCLUDE_HEADINGS": "2",
        "HIDE_UNDOC_RELATIONS": "YES", "SORT_MEMBER_DOCS": "NO", "SHOW_INCLUDE_FILES": "NO", "VERBATIM_HEADERS": "NO",
        "QUIET": "YES", "WARN_IF_UNDOCUMENTED": "NO", "WARN_LOGFILE": f'"{out}/warnings.txt"', "HAVE_DOT": "NO",
        "CLASS_GRAPH": "NO", "INCLUDE_PATH": f'"{pages}"', "SEARCHENGINE": "YES", "HTML_TIMESTAMP": "NO",
        "HIDE_IN_BODY_DOCS": "YES"}
    write("../Doxyfile", "".join(f"{key} = {value}\n" for key, value in settings.items()))
    subprocess.run([doxygen, os.path.join(out, "Doxyfile")], check=True, stdin=subprocess.DEVNULL)
    warnings = open(os.path.join(out, "warnings.txt"), encoding="utf-8").read().strip()
    if warnings:
        print(warnings)
    print(f"manual: {os.path.join(out, 'html/index.html')}")
    return 1 if warnings else 0


sys.exit(main())
