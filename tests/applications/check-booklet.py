#!/usr/bin/env python3
"""Checks a booklet: its structure, that its steps add each part once, its pictures, and its downloads.

Usage: check-booklet.py FILE.html FIRST_STEP LAST_STEP FILE.csv FILE.xml
LAST_STEP may be "all". The files are those that the page's downloads must equal. Prints one line per failure, and "N steps, M submodels".
"""
import base64
import collections
import html.parser
import re
import struct
import sys

VOID = {"meta", "img", "br", "link", "input", "hr"}


class Page(html.parser.HTMLParser):
    """The elements of a page, each as (tag, attributes, ids and classes of its ancestors)."""

    def __init__(self, text):
        super().__init__()
        self.elements, self.open, self.failures = [], [], []
        self.feed(text)
        self.close()
        if self.open:
            self.failures.append(f"not closed: {[tag for tag, _ in self.open]}")

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.elements.append((tag, attributes, [own for _, own in self.open]))
        if tag not in VOID:
            self.open.append((tag, attributes))

    def handle_startendtag(self, tag, attributes):
        self.elements.append((tag, dict(attributes), [own for _, own in self.open]))

    def handle_endtag(self, tag):
        if not self.open or self.open[-1][0] != tag:
            self.failures.append(f"</{tag}> closes {self.open[-1][0] if self.open else 'nothing'}")
        elif self.open:
            self.open.pop()


def size_of(data):
    """The width and height of a JPEG or WebP picture, in pixels."""
    if data[:4] == b"RIFF" and data[8:12] == b"WEBP":
        kind = data[12:16]
        if kind == b"VP8X":
            return 1 + int.from_bytes(data[24:27], "little"), 1 + int.from_bytes(data[27:30], "little")
        if kind == b"VP8L":
            bits = int.from_bytes(data[21:25], "little")
            return 1 + (bits & 0x3FFF), 1 + (bits >> 14 & 0x3FFF)
        return struct.unpack("<HH", data[26:30])
    if data[:2] != b"\xff\xd8":
        raise ValueError("neither JPEG nor WebP")
    place = 2
    while data[place + 1] not in (0xC0, 0xC1, 0xC2):
        place += 2 + int.from_bytes(data[place + 2:place + 4], "big")
    height, width = struct.unpack(">HH", data[place + 5:place + 9])
    return width, height


def decode(link):
    kind, text = link.removeprefix("data:").split(",", 1)
    assert kind.endswith(";base64"), kind
    return base64.b64decode(text, validate=True)


def has_class(ancestors, name):
    return any(name in own.get("class", "").split() for own in ancestors)


def find_id(ancestors, beginning):
    return next((own["id"] for own in reversed(ancestors) if own.get("id", "").startswith(beginning)), None)


def read_parts(text):
    """The quantity and the kind in a description such as "2 red bricks 2 x 4"."""
    match = re.fullmatch(r"([\d,]+) (.+) (brick|plate)(s?) (\d x \d)", text)
    assert match, f"not a description of parts: {text}"
    number = int(match[1].replace(",", ""))
    assert (number == 1) == (match[4] == ""), text
    return number, f"{match[2]} {match[3]} {match[5]}"


def count_parts(page, is_wanted):
    counts = collections.Counter()
    for tag, own, ancestors in page.elements:
        if tag == "svg" and own.get("role") == "img" and is_wanted(own, ancestors):
            number, kind = read_parts(own["aria-label"])
            counts[kind] += number
    return counts


def check_structure(page, fail):
    ids = [own["id"] for _, own, _ in page.elements if "id" in own]
    for name, number in collections.Counter(ids).items():
        if number > 1:
            fail(f"{number} elements have the id {name}")
    for tag, own, _ in page.elements:
        if tag == "html" and own.get("lang") != "en":
            fail("the page has no language")
        if tag == "img" and not own.get("alt", "").strip():
            fail("a picture has no alternative text")
        if tag == "svg" and own.get("role") == "img" and not own.get("aria-label", "").strip():
            fail("a symbol has no label")
        link = own.get("href", "") or own.get("src", "")
        if link.startswith("#") and link[1:] not in ids:
            fail(f"the link {link} leads nowhere")
        if link and not link.startswith(("#", "data:")):
            fail(f"the page is not self-contained: {link}")
    levels = [int(tag[1]) for tag, _, _ in page.elements if re.fullmatch(r"h\d", tag)]
    if levels[0] != 1 or levels.count(1) != 1:
        fail(f"the headings begin with h{levels[0]}")
    for level, following in zip(levels, levels[1:]):
        if following > level + 1:
            fail(f"h{following} follows h{level}")


def check_pictures(page, fail):
    widths = collections.defaultdict(set)
    for tag, own, ancestors in page.elements:
        if tag not in ("img", "image"):
            continue
        width, height = size_of(decode(own.get("src") or own["href"]))
        density = 2 if tag == "img" else 1
        if abs(width / density - int(own["width"])) > 1 or abs(height / density - int(own["height"])) > 1:
            fail(f"a picture of {width} x {height} pixels is declared as {own['width']} x {own['height']}")
        if has_class(ancestors, "frame"):
            widths[find_id(ancestors, "submodel-")].add(width)
    for chapter, found in widths.items():
        if len(found) > 1:
            fail(f"steps of {chapter or 'the model'} have pictures of different widths: {sorted(found)}")


def check_parts(page, fail):
    """Each part is in one step, and each submodel's list has the parts of its own steps and submodels."""
    whole = count_parts(page, lambda own, ancestors: has_class(ancestors, "parts"))
    is_part = lambda ancestors: has_class(ancestors, "callout")
    long_submodels = {find_id(ancestors, "submodel-") for _, own, ancestors in page.elements
                      if "step" in own.get("class", "").split()}

    def is_added(own, ancestors):
        if not is_part(ancestors) or own["aria-label"].startswith("Submodel"):
            return False
        return has_class(ancestors, "step") or find_id(ancestors, "submodel-") not in long_submodels

    added = count_parts(page, is_added)
    for chapter in long_submodels - {None}:
        inside = lambda own, ancestors: any(own_.get("id") == chapter for own_ in ancestors)
        listed = count_parts(page, lambda own, ancestors: is_part(ancestors) and has_class(ancestors, "intro")
                             and find_id(ancestors, "submodel-") == chapter)
        steps = count_parts(page, lambda own, ancestors: is_added(own, ancestors) and inside(own, ancestors))
        if listed != steps:
            fail(f"{chapter} lists {listed} and its steps add {steps}")
    return whole, added


def check_downloads(page, expected, fail):
    found = {own["download"].rsplit(".", 1)[1]: decode(own["href"]) for tag, own, _ in page.elements
             if tag == "a" and "download" in own}
    for name in expected:
        kind = name.rsplit(".", 1)[1]
        with open(name, "rb") as file:
            if found.get(kind) != file.read():
                fail(f"the download .{kind} differs from {name}")


def check_model(page, number, steps, fail):
    """The .mpd has all parts, in steps as on the page."""
    text = next(decode(own["href"]) for _, own, _ in page.elements if own.get("download", "").endswith(".mpd")).decode()
    if sum(line.startswith("1 ") and line.endswith(".dat") for line in text.splitlines()) != number:
        fail(f"the .mpd has other parts than the {number} of the model")
    main = text.split("0 FILE ")[1].splitlines()
    ends = sum(line.startswith(("0 STEP", "0 ROTSTEP")) and "END" not in line for line in main)
    if steps and ends != steps:
        fail(f"the .mpd has {ends} steps instead of {steps}")


def main():
    name, first, last, *expected = sys.argv[1:]
    with open(name, encoding="utf-8") as file:
        page = Page(file.read())
    failures = list(page.failures)
    check_structure(page, failures.append)
    check_pictures(page, failures.append)
    whole, added = check_parts(page, failures.append)
    steps = [own["id"] for _, own, _ in page.elements if re.fullmatch(r"step-\d+", own.get("id", ""))]
    if steps != [f"step-{number}" for number in range(int(first), len(steps) + int(first))]:
        failures.append(f"the steps are {steps}")
    if last == "all":
        if whole != added:
            failures.append(f"the parts list has {whole} and the steps add {added}")
    elif len(steps) != int(last) - int(first) + 1:
        failures.append(f"there are {len(steps)} steps")
    elif any(added[kind] > whole[kind] for kind in added):
        failures.append(f"the parts list has {whole} and some steps add {added}")
    check_downloads(page, expected, failures.append)
    check_model(page, sum(whole.values()), len(steps) if last == "all" else None, failures.append)
    for failure in failures:
        print(failure)
    submodels = [own["id"] for tag, own, _ in page.elements if tag == "section" and own.get("id", "").startswith("submodel-")]
    print(f"{len(steps)} steps, {len(submodels)} submodels")
    return 1 if failures else 0


sys.exit(main())
