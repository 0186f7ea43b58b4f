#!/usr/bin/env python3
"""Opens pages that reliefscope writes in a headless browser, and uses them.

    check_pages.py RELIEFSCOPE SOURCES

A page 360 pixels wide has no horizontal scroll bar; its slider, keys, question and languages work; nothing is loaded and
no error is reported. With RELIEF_LONG all pages of the course are written, to check their sizes. Exit status 77 if there is
no chromium.
"""
import html
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

MOST_BYTES = 3_000_000
reliefscope, root = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
browser = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")

# Runs in a page around the lesson's, which is in a frame of the width of a phone.
PROBE = """
const out = {errors: []};
const frame = document.querySelector('iframe');
frame.addEventListener('load', () => setTimeout(() => {
  const w = frame.contentWindow, d = w.document;
  try {
    out.width = w.innerWidth;
    out.wide = d.documentElement.scrollWidth;
    const figure = d.querySelector('figure.steps script.frames').parentNode;
    const slider = figure.querySelector('input'), drawing = figure.querySelector('svg.en');
    out.sliderSeen = slider.getBoundingClientRect().width > 100;
    const move = by => { slider.value = +slider.value + by; slider.dispatchEvent(new w.Event('input', {bubbles: true})); };
    const first = drawing.innerHTML, own = slider.value;
    move(1); out.moved = drawing.innerHTML !== first; out.step = figure.querySelector('output').textContent;
    const frames = JSON.parse(figure.querySelector('script.frames').textContent);
    out.whole = frames.en.every((parts, step) => {
      slider.value = step; move(0); return drawing.children.length === parts.length; });
    slider.value = +own + 1;
    move(-1); out.back = drawing.innerHTML === first || drawing.innerHTML.length === first.length;
    figure.scrollIntoView({block: 'center'});
    d.dispatchEvent(new w.KeyboardEvent('keydown', {key: '.', bubbles: true}));
    const all = [...d.querySelectorAll('figure.steps input')];
    out.key = all.some(s => s.value !== s.getAttribute('value'));
    const question = d.querySelector('.question[data-right]');
    const choice = question.querySelector('input[value="' + question.dataset.right + '"]');
    choice.click(); out.right = choice.parentNode.className;
    const seen = c => [...d.querySelectorAll('main p .' + c + ', main div.' + c)].some(e => e.offsetHeight > 0);
    out.english = seen('en') && !seen('uk');
    d.getElementById('show-uk').click(); out.ukrainian = seen('uk') && !seen('en'); out.lang = d.documentElement.lang;
    out.loaded = w.performance.getEntriesByType('resource').map(e => e.name).filter(n => !n.startsWith('data:'));
    const knob = d.querySelector('.knob input');
    if (knob) { knob.value = 0; knob.dispatchEvent(new w.Event('input')); out.knob = d.querySelectorAll('.knob .on').length > 1; }
  } catch (e) { out.errors.push(String(e)); }
  document.getElementById('probe').textContent = JSON.stringify(out);
}, 200));
"""


def fail(text):
    print(text)
    sys.exit(1)


def write(arguments, path):
    done = subprocess.run([reliefscope, *arguments, "--html", "-o", path], capture_output=True, text=True)
    if done.returncode != 0:
        fail(f"{arguments}: {done.stderr}")
    if os.path.isdir(path):
        return None
    text = open(path, encoding="utf-8").read()
    if len(text.encode()) > MOST_BYTES:
        fail(f"{arguments}: {len(text)} bytes")
    # Nothing but names of XML and the page's own parts.
    outside = [u for u in re.findall(r'(?:src|href)="([^"]*)"', text) if not u.startswith(("data:", "#")) and not u.endswith(".html")]
    if outside or re.search(r'url\((?!["\']?(?:data:|#))|@import|fetch\(|XMLHttpRequest', text):
        fail(f"{arguments}: refers to {outside or 'something outside'}")
    print(f"{' '.join(arguments)}: {len(text.encode())} bytes")
    return text


with tempfile.TemporaryDirectory() as folder:
    page = write(["--lesson", "302"], os.path.join(folder, "302.html"))
    # Readable without scripts: the chosen step is drawn, the answer is in the file.
    if page.count("<svg") < 4 or "<details>" not in page or page.index("<svg") > page.index("<script"):
        fail("the page shows nothing without scripts")
    # Texts keep their paragraphs, in both languages.
    blocks = [page.count(f'<div class="{language}" lang="{language}">') for language in ("en", "uk")]
    if blocks[0] < 5 or blocks[0] != blocks[1] or page.count("<p>") < sum(blocks):
        fail(f"texts in English and Ukrainian: {blocks}, paragraphs: {page.count('<p>')}")
    view = write([os.path.join(root, "ui/lessons/missed_spike.json"), "--export", "profile"], os.path.join(folder, "profile.html"))
    if "type=\"range\"" not in view:
        fail("the pane's page has no slider")
    if os.environ.get("RELIEF_LONG"):
        course = os.path.join(folder, "course")
        write(["--lesson", "all"], course)
        sizes = {name: os.path.getsize(os.path.join(course, name)) for name in sorted(os.listdir(course))}
        print(json.dumps(sizes))
        if len(sizes) < 28 or max(sizes.values()) > MOST_BYTES:
            fail("the course is incomplete or has a large page")
    if not browser:
        print("chromium is not there: the pages are not opened")
        sys.exit(77)
    test = os.path.join(folder, "test.html")
    open(test, "w", encoding="utf-8").write(
        f'<!DOCTYPE html><meta charset="utf-8"><link rel="icon" href="data:,"><pre id="probe"></pre>'
        f'<iframe width="360" height="640" style="border:0" srcdoc="{html.escape(page)}"></iframe><script>{PROBE}</script>')
    done = subprocess.run(
        [browser, "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--lang=en-US", "--no-first-run",
         f"--user-data-dir={folder}/browser", "--host-resolver-rules=MAP * ~NOTFOUND", "--enable-logging=stderr",
         "--window-size=800,900", "--virtual-time-budget=20000", "--dump-dom", "file://" + test],
        capture_output=True, text=True, timeout=240)
    found = re.search(r'<pre id="probe">(.*?)</pre>', done.stdout, re.S)
    if not found or not found.group(1):
        fail(f"the browser shows nothing: {done.stderr[-2000:]}")
    result = json.loads(html.unescape(found.group(1)))
    print(json.dumps(result, ensure_ascii=False))
    console = [line for line in done.stderr.splitlines() if "CONSOLE" in line]
    expected = {"errors": [], "width": 360, "sliderSeen": True, "moved": True, "whole": True, "back": True, "key": True, "right": "right",
                "english": True, "ukrainian": True, "lang": "uk", "loaded": [], "knob": True}
    wrong = {key: result.get(key) for key, value in expected.items() if result.get(key) != value}
    if wrong or console or result["wide"] > 360:
        fail(f"wrong: {wrong}, wide: {result['wide']}, console: {console}")
