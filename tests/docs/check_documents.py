#!/usr/bin/env python3
"""Checks all Markdown pages: links, named files, and the commands in their code blocks.

    check_documents.py SOURCES BIN [PAGE...]

Every relative link must lead to a file (and heading), every file named in backticks must exist, every function and camel-case name in
backticks must occur in the sources, and every command line that begins with relief or reliefscope is run in a temporary folder, in the
order of the page. A comment after a command states what to expect: "# status 1" is the exit status (default 0); a comment with "minute"
or "hour" marks a long command, which is stopped after some seconds and only must not be refused. Exit status 1 if there is any fault;
each is reported with its page and line.
"""
import os
import re
import signal
import subprocess
import sys
import tempfile
import time

LONG_SECONDS = 5
SLOWEST = 12  # commands that are printed with their time
FOLDERS = ["algorithms", "app", "datasets", "tests", "ui"]
ENDINGS = r"\.(?:h|cpp|md|json|sh|py|csv|ts|png|jpg|exr|txt|def|inc|supp|qrc)"


def slug(heading):
    """Returns the anchor of a heading, as GitHub and Doxygen make it."""
    text = re.sub(r"[^\w\- ]", "", heading.strip().lower().replace("`", ""))
    return text.replace(" ", "-")


class Page:
    def __init__(self, root, path):
        self.path = path
        self.folder = os.path.dirname(os.path.join(root, path))
        self.lines = open(os.path.join(root, path), encoding="utf-8").read().split("\n")
        self.prose, self.code = [], []  # (line number, text); code: of shell blocks
        fence = None
        for number, line in enumerate(self.lines, 1):
            if line.startswith("```"):
                fence = None if fence is not None else line[3:].strip() or "sh"
            elif fence is not None:
                if fence == "sh":
                    self.code.append((number, line))
            elif line.startswith("    ") and line.strip() and not re.match(r"\s+([-*]|\d+\.) ", line):
                self.code.append((number, line[4:]))
            else:
                self.prose.append((number, line))
        self.anchors = {slug(line.lstrip("#")) for _, line in self.prose if line.startswith("#")}


class Checker:
    def __init__(self, root, bin_folder):
        self.root, self.bin = root, bin_folder
        self.faults, self.links, self.files, self.commands = [], 0, 0, 0
        self.pages, self.names, self.words, self.seconds = {}, set(), set(), []
        for folder, folders, files in os.walk(root):
            folders[:] = [f for f in folders if f != ".git" and not f.startswith("build")]
            self.names.update(files)
            for name in files:
                if re.search(r"\.(?:h|cpp|inc|def|py|sh|cmake|glsl)$|^CMakeLists\.txt$", name):
                    self.words.update(re.findall(r"\w+", open(os.path.join(folder, name), encoding="utf-8").read()))
                if name.endswith(".md"):
                    path = os.path.relpath(os.path.join(folder, name), root)
                    self.pages[path] = Page(root, path)

    def fault(self, page, line, text):
        self.faults.append(f"{page.path}:{line}: {text}")

    def check_links(self, page):
        for number, line in page.prose:
            for target in re.findall(r"\]\(([^)\s]+)\)", re.sub(r"`[^`]*`", "", line)):
                if re.match(r"[a-z]+:", target):
                    continue
                self.links += 1
                path, _, anchor = target.partition("#")
                file = os.path.normpath(os.path.join(page.folder, path)) if path else os.path.join(self.root, page.path)
                if not os.path.exists(file):
                    self.fault(page, number, f"no such file: {target}")
                elif anchor:
                    other = self.pages.get(os.path.relpath(file, self.root))
                    if other is None or anchor not in other.anchors:
                        self.fault(page, number, f"no such heading: {target}")

    def exists(self, page, path):
        bases = [page.folder, self.root] + [os.path.join(self.root, f) for f in
                 ("algorithms", "algorithms/include", "algorithms/relief", "ui", "tests")]
        return any(os.path.exists(os.path.join(base, path)) for base in bases)

    def check_files(self, page):
        if page.path.endswith("SOURCES.md"):  # lists locations on other servers
            return
        for number, line in page.prose:
            for text in re.findall(r"`([^`]+)`", line):
                for word in text.split():
                    if not re.fullmatch(r"[\w./-]+", word) or re.search(r"[A-Z]{4}", os.path.splitext(word)[0].split("/")[-1]) \
                            and not self.exists(page, word):
                        continue
                    top = word.split("/")[0]
                    if word.startswith("build") or "/" not in word and not re.fullmatch(r"[\w-]+\.(?:h|cpp|inc|def)", word):
                        continue
                    named = re.search(ENDINGS + "$", word) or word.endswith("/") or top in FOLDERS
                    if not named:
                        continue
                    self.files += 1
                    if not (self.exists(page, word) if "/" in word else word in self.names):
                        self.fault(page, number, f"no such file: {word}")

    def check_names(self, page):
        """Checks that functions, `name()`, and names such as `FigureView` occur in the sources."""
        for number, line in page.prose:
            for text in re.findall(r"`([^`]+)`", line):
                for name in re.findall(r"\b\w+(?=\()|\b[A-Za-z]+[a-z][A-Z]\w*", text):
                    if name not in self.words:
                        self.fault(page, number, f"no such name in the sources: {name}")

    def check_script(self, page, number, line):
        """Checks that the options of app/run and tests/run occur in the scripts."""
        script, *words = line.split("#")[0].split()
        text = open(os.path.join(self.root, script), encoding="utf-8").read()
        for word in words:
            if word.startswith("--") and word.split("=")[0] not in text:
                self.fault(page, number, f"{script} has no option {word}")

    def run(self, page, folder, number, line):
        command, _, comment = line.partition("    #") if "    #" in line else line.partition(" # ")
        command = re.sub(r"^mpirun .*?(?=relief )", "", command.strip())
        long = bool(re.search(r"minute|hour", comment)) or line.strip().startswith("mpirun")
        wanted = int((re.search(r"status (\d+)", comment) or [0, 0])[1])
        environment = dict(os.environ, PATH=f"{self.bin}:{os.environ['PATH']}", HOME=folder, QT_QPA_PLATFORM="offscreen")
        self.commands += 1
        begun = time.monotonic()
        with tempfile.TemporaryFile() as said:
            process = subprocess.Popen(["bash", "-c", command], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                                       stdout=said, stderr=said, start_new_session=True)
            stopped = False
            try:
                status = process.wait(LONG_SECONDS if long else None)
            except subprocess.TimeoutExpired:
                stopped = True
                os.killpg(process.pid, signal.SIGKILL)
                status = process.wait()
            said.seek(0)
            text = said.read().decode(errors="replace").strip().split("\n")
        self.seconds.append((time.monotonic() - begun, f"{page.path}:{number}: {command}"))
        if not stopped and status != wanted:
            self.fault(page, number, f"status {status}, not {wanted}: {command}\n    " + "\n    ".join(text[-3:]))

    def check_commands(self, page):
        lines = []
        for number, line in page.code:
            line = line.replace("build/bin/", "")
            if re.match(r"(app|tests)/run\b", line):
                self.check_script(page, number, line)
            elif re.match(r"(relief|reliefscope) ", line) or re.match(r"(for|mpirun|parallel) .*\brelief ", line):
                known = re.match(r"mpirun|for|parallel", line) or os.path.exists(os.path.join(self.bin, line.split()[0]))
                if "$SLURM" in line or not known or line.startswith("parallel") and not self.has("parallel"):
                    continue
                lines.append((number, line))
        if not lines:
            return
        with tempfile.TemporaryDirectory() as folder:
            for name in FOLDERS:
                os.symlink(os.path.join(self.root, name), os.path.join(folder, name))
            os.makedirs(os.path.join(folder, "build"))
            for number, line in lines:
                self.run(page, folder, number, line)

    @staticmethod
    def has(program):
        return subprocess.call(["sh", "-c", f"command -v {program} >/dev/null"]) == 0


def main():
    root, bin_folder = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
    checker = Checker(root, bin_folder)
    for path in sys.argv[3:] or sorted(checker.pages):
        page = checker.pages[path]
        checker.check_links(page)
        checker.check_files(page)
        checker.check_names(page)
        checker.check_commands(page)
    for seconds, command in sorted(checker.seconds, reverse=True)[:SLOWEST]:
        print(f"{seconds:6.1f} s {command}")
    print("\n".join(checker.faults))
    print(f"{len(checker.pages)} pages: {checker.links} links, {checker.files} named files, {checker.commands} commands, "
          f"{len(checker.faults)} faults")
    return 1 if checker.faults or checker.links < 10 else 0


sys.exit(main())
