#!/usr/bin/env python3
"""Checks a booklet as its reader sees it: its structure, the visible quantities, letters and numbers, its pictures, and its
downloads. The downloads are compared with each other and with the page by parsers of their own.

Usage: check-booklet.py FILE.html FIRST_STEP LAST_STEP [MODEL.ldr]
LAST_STEP may be "all". MODEL.ldr is the model, of parts without submodels, from which the booklet was made. Prints one line
per failure, and "N steps, M submodels".
"""
import base64
import collections
import csv
import hashlib
import io
import re
import sys
import xml.etree.ElementTree

from booklet_page import Page, decode, size_of
from ldraw_document import Document, describe_color, name_part

failures = []

MOST_LISTED = 200  # parts of a submodel with a list


def fail(text):
    failures.append(text)


def check_structure(page):
    ids = [own["id"] for own in page.elements if "id" in own]
    for name, number in collections.Counter(ids).items():
        if number > 1:
            fail(f"{number} elements have the id {name}")
    for own in page.elements:
        if own.tag == "html" and own.get("lang") != "en":
            fail("the page has no language")
        if own.tag == "img" and not own.get("alt", "").strip():
            fail("a picture has no alternative text")
        if own.tag == "svg" and own.get("role") == "img" and not own.get("aria-label", "").strip():
            fail("a symbol has no label")
        link = own.get("href", "") or own.get("src", "")
        if link.startswith("#") and link[1:] not in ids:
            fail(f"the link {link} leads nowhere")
        if link and not link.startswith(("#", "data:")):
            fail(f"the page is not self-contained: {link}")
    levels = [int(own.tag[1]) for own in page.elements if re.fullmatch(r"h\d", own.tag)]
    if levels[0] != 1 or levels.count(1) != 1:
        fail(f"the headings begin with h{levels[0]}")
    for level, following in zip(levels, levels[1:]):
        if following > level + 1:
            fail(f"h{following} follows h{level}")


def check_policy(text):
    """The page allows its own script and style sheet, by their hashes, and pictures in the page; otherwise nothing."""
    policy = re.search('<meta charset="utf-8">\n<meta http-equiv="Content-Security-Policy" content="([^"]*)">', text)
    if not policy:
        fail("the page has no policy in its second element")
        return
    expected = {"default-src": "'none'", "img-src": "data:", "base-uri": "'none'", "form-action": "'none'",
                "style-src": "'unsafe-inline'", "style-src-attr": "'unsafe-inline'"}
    for directive, tag in (("script-src", "script"), ("style-src-elem", "style")):
        contents = re.findall(f"<{tag}>(.*?)</{tag}>", text, re.DOTALL)
        if len(contents) != 1:
            fail(f"the page has {len(contents)} elements {tag}")
        hash_of_content = base64.b64encode(hashlib.sha256(contents[0].encode()).digest()).decode()
        expected[directive] = f"'sha256-{hash_of_content}'"
    found = dict(own.strip().split(" ", 1) for own in policy[1].split(";"))
    if found != expected:
        fail(f"the policy of the page is {found} instead of {expected}")


def check_pictures(page):
    widths, bag = collections.defaultdict(set), ""
    for own in page.elements:
        bag = own["id"] if own.has_class("bag") and "id" in own else bag
        if own.tag not in ("img", "image"):
            continue
        width, height = size_of(decode(own.get("src") or own["href"]))
        density = 1.5 if own.tag == "img" else 1
        if abs(width / density - int(own["width"])) > 1 or abs(height / density - int(own["height"])) > 1:
            fail(f"a picture of {width} x {height} pixels is declared as {own['width']} x {own['height']}")
        if own.find_ancestor(lambda other: other.has_class("frame")):
            step = own.find_ancestor(lambda other: other.get("id", "").startswith("step-"))
            widths[step["id"].rstrip("0123456789"), bag].add(width)
    for chapter, found in widths.items():
        if len(found) > 1:
            fail(f"steps of {' of '.join(chapter)} have pictures of different widths: {sorted(found)}")


def read_quantity(text, where):
    match = re.fullmatch(r"([\d,]+)×", text)
    if not match:
        fail(f"{where} shows '{text}' instead of a quantity")
        return 0
    return int(match[1].replace(",", ""))


def check_label(label, number, kind, where):
    """A description such as "2 red bricks 2 x 4" says as much as the reader sees."""
    match = re.fullmatch(r"([\d,]+) (.+) (brick|plate)(s?) (\d x \d)", label)
    if not match or int(match[1].replace(",", "")) != number or (number == 1) != (match[4] == ""):
        fail(f"{where} shows {number} and is described as '{label}'")
    elif kind and f"{match[2]} {match[3]} {match[5]}" != kind:
        fail(f"{where} shows a {kind} and is described as '{label}'")


class Kinds:
    """The parts list that a reader sees: for each symbol of a part, its number, its colour, and its quantity."""

    def __init__(self, page):
        self.parts, self.labels, self.quantities = {}, {}, collections.Counter()
        lists = [own for own in page.elements if own.tag == "ul" and own.has_class("parts")]
        for item in [item for own in lists for item in own.children]:
            picture, details = item.children
            symbol = picture.children[0]["href"]
            text = details.get_text()
            match = re.fullmatch(r"(\S+) (Brick|Plate) (\d) × (\d) (\S+) (.+?)((?: BrickLink \d+)?)((?: LDraw \d+.*)?)", text)
            if not match:
                fail(f"the parts list shows '{text}'")
                continue
            quantity = read_quantity(match[1], f"the parts list, {match[5]},")
            color = re.match(r" LDraw (\d+)", match[8])
            self.parts[symbol] = match[5], int(color[1]) if color else match[6]
            self.quantities[self.parts[symbol]] += quantity
            label = picture["aria-label"]
            check_label(label, quantity, None, f"the parts list, {match[5]},")
            self.labels[symbol] = re.sub(r"^[\d,]+ (.+ )(brick|plate)s? ", r"\1\2 ", label)
            size = f"{match[2]} {match[3]} x {match[4]}"
            if name_part(match[5]) != size:
                fail(f"the parts list calls {match[5]} a {size}")
            if color and f" BrickLink {describe_color(int(color[1]))[1]}" != match[7]:
                fail(f"the parts list shows the colour {color[1]} of LDraw as '{match[7]}'")


def read_multiplier(owner):
    """How often a submodel is built."""
    return next((read_quantity(own.get_text(), "a submodel") for own in owner.children if own.has_class("multiplier")), 1)


def read_boxes(elements, where):
    """The letters of the submodels in boxes among elements, as often as they are built."""
    letters = []
    for box in [box for own in elements if own.has_class("boxes") for box in own.children if box.has_class("box")]:
        header = box.children[0]
        letter = header.children[0].get_text()
        if box["id"] != f"submodel-{letter.lower()}":
            fail(f"{where} has a box {letter} with the id {box['id']}")
        letters += [letter] * read_multiplier(next(own for own in box.children if own.tag == "figure"))
    return letters


def read_callout(owner, kinds, where):
    """The parts and the letters of submodels that a list shows, each letter as often as the submodel is built."""
    parts, letters = collections.Counter(), []
    header = next(own for own in owner.children if own.tag == "header")
    items = [item for own in header.children if own.has_class("callout") or own.has_class("items") for item in own.children]
    for item in items:
        picture, label, text = item.children[0], item.children[0]["aria-label"], item.get_text()
        symbol = picture.children[0]["href"]
        if label.startswith("Submodel "):
            text = item.children[1].get_text()
            letters += [text] * read_multiplier(item)
            if label != f"Submodel {text}" or symbol != f"#submodel-{text.lower()}-picture":
                fail(f"{where} shows '{text}' with {symbol}, described as '{label}'")
            continue
        number = read_quantity(text, where)
        parts[kinds.parts.get(symbol)] += number
        check_label(label, number, kinds.labels.get(symbol), where)
    return parts, letters


def letters_of(index):
    """A to Z, and then AA, AB and so on."""
    letters = [chr(ord("A") + place) for place in range(26)]
    return letters[index] if index < 26 else letters_of(index // 26 - 1) + letters[index % 26]


def find_submodels(page):
    return [own for own in page.elements if own.tag == "section" and (own.has_class("submodel") or own.has_class("box"))
            and not own.has_class("continued")]


def find_continued(page, name):
    """The rest of a list that is too long for one sheet."""
    return [own for own in page.elements if own.get("data-of") == name]


def check_letters(page):
    for index, section in enumerate(find_submodels(page)):
        heading = section.children[0].children[0]
        if heading.get_text() != letters_of(index) or section["id"] != f"submodel-{letters_of(index).lower()}":
            fail(f"submodel {index + 1} has the letter '{heading.get_text()}' and the id {section['id']}")


def find_steps(page, letter):
    """The steps of the model or of a submodel."""
    return [own for own in page.elements if re.fullmatch(rf"step-{letter.lower()}\d+", own.get("id", ""))]


def list_parts(page, letter, kinds):
    """The parts of a submodel by its lists and those of the submodels that they name."""
    name = f"submodel-{letter.lower()}"
    listed = collections.Counter()
    for own in [page.find_id(name)] + find_continued(page, name):
        parts, letters = read_callout(own, kinds, f"submodel {letter}")
        listed += parts
        for inner in letters:
            listed += list_parts(page, inner, kinds)
    return listed


def match_submodels(page, letters, attached, kinds, document, where):
    """Find a submodel of the .mpd with the same parts for each letter. Equal ones have one letter."""
    pairs, left = {}, list(attached)
    for letter in letters:
        listed = list_parts(page, letter, kinds)
        # Submodels of so many parts have no lists: those of bags have their parts.
        same = [own for own in left if document.count_parts(own) == listed or
                (not listed and document.count_parts(own).total() > MOST_LISTED)]
        if not same:
            fail(f"{where} attaches {letter} with {listed}, which the .mpd does not")
            continue
        left.remove(same[0])
        pairs.setdefault(letter, same[0])
    return list(pairs.items())


def describe_added(num_parts, letters):
    """Such as "4 parts + A + 2 × B"; submodels of many letters are only counted."""
    added = [f"{num_parts} part{'s' if num_parts != 1 else ''}"] if num_parts else []
    quantities = collections.Counter(letters)
    if len(quantities) > 2:
        added.append(f"{len(letters)} submodels")
    else:
        added += [f"{quantity} × {letter}" if quantity > 1 else letter for letter, quantity in quantities.items()]
    return " + ".join(added)


def check_step(page, step, name, written, kinds, document):
    """A step of the page has the parts, submodels and the turn of a step of the .mpd. Returns its submodels' letters."""
    attached = [own.name for own in written.references if own.name in document.files]
    if step.has_class("small-step"):  # the box around it lists its parts
        number = step.children[0]
        heading = number.children[0]
        before = [index for index, own in enumerate(step.parent.children) if own is step][0]
        letters = read_boxes(step.parent.children[before - 1:before], f"step {name}")
    else:
        number = next(own for own in step.children if own.tag == "header").children[0]
        heading, count = number.children[:2]
        parts, letters = read_callout(step, kinds, f"step {name}")
        letters += read_boxes(step.children, f"step {name}")
        direct = collections.Counter((own.name, own.color) for own in written.references if own.name not in document.files)
        if parts != direct or len(letters) != len(attached):
            fail(f"step {name} shows {parts} and submodels {letters}, and the .mpd places {direct} and {attached}")
        added = describe_added(direct.total(), letters)
        if count.get_text() != added:
            fail(f"step {name} adds {added}, and counts {count.get_text()}")
    if heading.get_text() != name:
        fail(f"step {name} shows the number '{heading.get_text()}'")
    if any(own.has_class("turn") for own in number.children) != written.changes_view:
        fail(f"step {name} {'has no' if written.changes_view else 'has an'} arrow for turning, unlike the .mpd")
    return match_submodels(page, letters, attached, kinds, document, f"step {name}")


def check_chapter(page, letter, steps, kinds, document, first=1):
    """The steps of the page are those of a file of the .mpd, and so are its submodels."""
    for index, (step, written) in enumerate(zip(find_steps(page, letter), steps)):
        name = f"{letter}{first + index}"
        for inner_letter, inner in check_step(page, step, name, written, kinds, document):
            steps_of_inner = document.files[inner]
            number = len(find_steps(page, inner_letter))
            # The picture of a finished submodel may show all its parts.
            if number not in (0, len(steps_of_inner)):
                fail(f"submodel {inner_letter} has {number} steps, and {len(steps_of_inner)} in the .mpd")
            check_chapter(page, inner_letter, steps_of_inner, kinds, document)


def check_bags(page, kinds):
    """The lists of all bags, if there are any, and the counts of all pages add up to the parts list."""
    bags = collections.Counter()
    for bag in [own for own in page.elements if own.has_class("bag") and not own.has_class("continued")]:
        listed = collections.Counter()
        lists = [own for part in [bag] + find_continued(page, bag["id"]) for own in part.children if own.has_class("callout")]
        for item in [item for own in lists for item in own.children]:
            symbol = item.children[0].children[0]["href"]
            listed[kinds.parts.get(symbol)] += read_quantity(item.get_text(), bag["id"])
            check_label(item.children[0]["aria-label"], listed[kinds.parts.get(symbol)], kinds.labels.get(symbol), bag["id"])
        if not bag.children[1].get_text().startswith(f"{listed.total()} part"):
            fail(f"{bag['id']} has {listed.total()} parts, and counts {bag.children[1].get_text()}")
        bags += listed
    if (kinds.quantities.total() >= 200 or bags) and bags != kinds.quantities:
        fail(f"the bags have {bags}, and the parts list {kinds.quantities}")
    counts = [int(own.get_text().split()[0].replace(",", "")) for own in page.elements if own.has_class("sheet-parts")]
    if sum(counts) != kinds.quantities.total():
        fail(f"the pages have {counts} parts, and the parts list {kinds.quantities.total()}")


def check_csv(text, parts):
    """The table has a row for each part and colour, and the sums of its rows."""
    rows = list(csv.DictReader(io.StringIO(text)))
    end = next(index for index, row in enumerate(rows) if row["part"] == "total")
    total, rows = rows[end], rows[:end]  # a base plate follows
    counts, masses = collections.Counter(), []
    for row in rows:
        color = int(row["ldraw_color"]) if row["ldraw_color"] else row["color_name"]
        number, mass = int(row["quantity"]), float(row["mass"])
        counts[row["part"], color] += number
        masses.append(number * mass)
        if row["name"] != name_part(row["part"]):
            fail(f"the .csv calls {row['part']} a {row['name']}")
        if (row["color_name"], row["bricklink_color"]) != describe_color(color):
            fail(f"the .csv names the colour {color} {row['color_name']}, {row['bricklink_color']}")
        if abs(float(row["total_mass"]) - number * mass) > 0.005 * (number + 1):
            fail(f"{number} parts of {mass} g have {row['total_mass']} g in the .csv")
    if counts != parts:
        fail(f"the .csv has {counts} and the .mpd {parts}")
    if total["part"] != "total" or int(total["quantity"]) != sum(parts.values()):
        fail(f"the last row of the .csv is {total}")
    if abs(float(total["total_mass"]) - sum(masses)) > 0.005 * (sum(parts.values()) + 1):
        fail(f"the .csv adds {sum(masses):.2f} g up to {total['total_mass']}")


def check_wanted_list(text, parts):
    """The wanted list has BrickLink's colours, or remarks without them. BrickLink refuses a declaration of XML."""
    if text.startswith("<?xml"):
        fail("the .xml begins with a declaration")
    counts, expected = collections.Counter(), collections.Counter()
    for item in xml.etree.ElementTree.fromstring(text).findall("ITEM"):
        if item.findtext("ITEMTYPE") != "P":
            fail("an item of the .xml is not a part")
        counts[item.findtext("ITEMID"), item.findtext("COLOR") or item.findtext("REMARKS")] += int(item.findtext("MINQTY"))
    for (part, color), number in parts.items():
        name, brick_link = describe_color(color)
        expected[part, brick_link or name] += number
    if counts != expected:
        fail(f"the .xml has {counts}; expected {expected}")


def check_cover(page, document, is_whole):
    """The cover counts the steps of the .mpd, and those of submodels apart."""
    facts = {own.children[0].get_text(): own.children[1].get_text() for own in page.elements
             if own.tag == "div" and [child.tag for child in own.children] == ["dt", "dd"]}
    number = len(document.files[document.main])
    inner = sum(len(steps) for steps in document.files.values()) - number
    expected = f"{number:,}" + (f", and {inner:,} in submodels" if inner else "")
    if is_whole and facts["Steps"] != expected:
        fail(f"the cover counts {facts['Steps']} steps, and the .mpd {expected}")


def main():
    name, first, last, *models = sys.argv[1:]
    with open(name, encoding="utf-8") as file:
        text = file.read()
    page = Page(text)
    check_policy(text)
    failures.extend(page.failures)
    check_structure(page)
    check_pictures(page)
    check_letters(page)
    kinds = Kinds(page)
    downloads = {own["download"].rsplit(".", 1)[1]: decode(own["href"]).decode() for own in page.elements
                 if own.tag == "a" and "download" in own}
    document = Document(downloads["mpd"])
    parts = document.count_parts(document.main)
    if kinds.quantities != parts:
        fail(f"the parts list has {kinds.quantities} and the .mpd {parts}")
    check_csv(downloads["csv"], parts)
    check_wanted_list(downloads["xml"], parts)
    for model in models:
        with open(model, encoding="utf-8") as file:
            original = Document(file.read())
        if document.find_places(document.main) != original.find_places(original.main):
            fail(f"the .mpd has other parts, colours or places than {model}")
    check_cover(page, document, last == "all")
    if last == "all":
        check_bags(page, kinds)
    written, begin = document.files[document.main], int(first)
    steps = find_steps(page, "")
    end = len(written) if last == "all" else int(last)
    if len(steps) != end - begin + 1:
        fail(f"there are {len(steps)} steps from {begin} to {end}")
    check_chapter(page, "", written[begin - 1:end], kinds, document, begin)
    for failure in failures:
        print(failure)
    print(f"{len(steps)} steps, {len(find_submodels(page))} submodels")
    return 1 if failures else 0


sys.exit(main())
