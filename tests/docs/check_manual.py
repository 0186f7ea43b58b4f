#!/usr/bin/env python3
"""Walks the manual: every link and picture of every page must exist, with its anchor.      check_manual.py HTML"""
import html.parser
import os
import sys
import urllib.parse

root = os.path.abspath(sys.argv[1])


class Page(html.parser.HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.links, self.anchors = [], set()
        self.feed(open(path, encoding="utf-8").read())

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        for key in ("id", "name"):
            if values.get(key):
                self.anchors.add(values[key])
        for key in ("href", "src"):
            if values.get(key):
                self.links.append(values[key])


pages = {name: Page(os.path.join(root, name)) for name in os.listdir(root) if name.endswith(".html")}
faults, links = [], 0
for name, page in sorted(pages.items()):
    for link in page.links:
        address = urllib.parse.urlsplit(link)
        # Doxygen links to the summary of nested classes even if all of them are private.
        if address.scheme or link == "#nested-classes":
            continue
        links += 1
        file = urllib.parse.unquote(address.path) or name
        if not os.path.exists(os.path.join(root, file)):
            faults.append(f"{name}: no such file: {link}")
        elif address.fragment and file in pages and urllib.parse.unquote(address.fragment) not in pages[file].anchors:
            faults.append(f"{name}: no such place: {link}")
# What the manual must contain: the guide, the methods, the commands, the reference.
for needed in ("index.html", "page_methods.html", "page_commands.html", "page_algorithms_readme.html", "tracers_8h.html",
               "rocks.jpg", "window.png"):
    if not os.path.exists(os.path.join(root, needed)):
        faults.append(f"there is no {needed}")
print("\n".join(faults))
print(f"{len(pages)} pages, {links} links, {len(faults)} faults")
sys.exit(1 if faults or len(pages) < 40 or links < 1000 else 0)
