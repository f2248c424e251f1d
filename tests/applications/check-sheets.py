#!/usr/bin/env python3
"""Checks the sheets of a booklet as Chromium lays them out for A5 and for A4 sideways: nothing leaves its sheet, its column or its block, no two
things overlap, quantities are apart from numbers of steps, pictures have nearly the size that was planned, those of parts have one
scale, all texts are at least 2 mm high on A5, and the picture of the cover is large.

Usage: check-sheets.py FILE.html
"""
import sys

from browser import Browser

PAPERS = {"A5": (484, 692), "A4": (1047, 692)}  # pixels of CSS, without margins

# Each failure as a text. Things that are within each other in the document may overlap.
FIND_FAILURES = """(() => {
    const BLOCKS = ".section header, .parts, .true-size, .bag, .step, .submodel, .last-line";
    const THINGS = BLOCKS + ", .parts li, .bag h2, .bag p, .number, .callout, .box, li > svg, .quantity, .letter, .multiplier, " +
        ".submodel h3, .box h4, .small-step h5, .turn, .note, .frame, figure > svg, .sheet-parts, .colors, .colors li";
    const TOLERANCE = 1; // pixels
    const failures = [];
    const name = own => own.closest("[data-stop]")?.dataset.stop + ": ." + (own.className.baseVal ?? own.className) + " " +
        own.tagName + " " + own.textContent.trim().replace(/\\s+/g, " ").slice(0, 20);
    const isIn = (own, outer) => own.left > outer.left - TOLERANCE && own.right < outer.right + TOLERANCE &&
        own.top > outer.top - TOLERANCE && own.bottom < outer.bottom + TOLERANCE;
    const overlap = (own, other) => own.left < other.right - TOLERANCE && other.left < own.right - TOLERANCE &&
        own.top < other.bottom - TOLERANCE && other.top < own.bottom - TOLERANCE;
    // How large the picture of a part is, compared with the texts and lists around it.
    const getPartScale = own => own.getBoundingClientRect().width / parseFloat(getComputedStyle(own).getPropertyValue("--w")) /
        (parseFloat(getComputedStyle(own).getPropertyValue("--scale")) || 1);
    const findParts = outer => [...outer.querySelectorAll(".callout svg, .items svg")].filter(
        own => own.firstElementChild?.getAttribute("href")?.startsWith("#part-"));
    const partScale = Math.max(...findParts(document).map(getPartScale));
    // A long title and long warnings leave a fifth of the cover to the picture.
    const cover = document.querySelector(".cover").getBoundingClientRect();
    const picture = document.querySelector(".cover .picture").getBoundingClientRect();
    if (picture.height < cover.height / 5)
        failures.push(`the picture has ${(picture.height / cover.height).toFixed(2)} of the height of the cover`);
    for (const own of document.querySelectorAll(".cover > *"))
        if (!isIn(own.getBoundingClientRect(), cover)) failures.push(`${name(own)} leaves the cover`);
    document.querySelectorAll(".sheet").forEach((sheet, index) => {
        const fail = text => failures.push(`sheet ${index + 1}: ${text}`);
        const limits = sheet.getBoundingClientRect();
        const unitOf = own => limits.width / 128 * (parseFloat(getComputedStyle(own).getPropertyValue("--scale")) || 1);
        const things = [...sheet.querySelectorAll(THINGS)].map(own => ({own, size: own.getBoundingClientRect()}));
        for (const {own, size} of things) {
            if (!size.width || !size.height) fail(`${name(own)} has no size`);
            if (!isIn(size, limits)) fail(`${name(own)} leaves the sheet`);
            const outer = own.parentElement.closest(".box, .callout, .column, " + BLOCKS);
            if (outer && !isIn(size, outer.getBoundingClientRect())) fail(`${name(own)} leaves ${name(outer)}`);
        }
        things.forEach(({own, size}, first) => things.slice(first + 1).forEach(({own: other, size: others}) => {
            if (overlap(size, others) && !own.contains(other)) fail(`${name(own)} overlaps ${name(other)}`);
        }));
        for (const own of [sheet, ...sheet.querySelectorAll(".column, .number, .submodel h3, .callout, .box, .last-line")])
            if (own.scrollHeight > own.clientHeight + 3 || own.scrollWidth > own.clientWidth + 3)
                fail(`${name(own)} has too much content`);
        const texts = document.createTreeWalker(sheet, NodeFilter.SHOW_TEXT);
        while (texts.nextNode()) {
            const own = texts.currentNode.parentElement;
            if (!texts.currentNode.textContent.trim() || own.closest(".hidden")) continue;
            const drawing = own.closest("svg");
            const scale = drawing ? drawing.getBoundingClientRect().width / drawing.viewBox.baseVal.width : 1;
            const size = parseFloat(getComputedStyle(own).fontSize) * scale / (limits.width / 128);
            if (size < 1.99) fail(`${name(own)} has letters of ${size.toFixed(2)} mm`);
        }
        for (const own of sheet.querySelectorAll(".model .frame")) {
            const planned = own.getBoundingClientRect().width / parseFloat(getComputedStyle(own).getPropertyValue("--print"));
            if (planned < 0.8 * unitOf(own)) fail(`${name(own)} has ${(planned / unitOf(own)).toFixed(2)} of the planned size`);
        }
        for (const own of sheet.querySelectorAll(".small-step h5")) {
            const size = own.getBoundingClientRect();
            const isAbove = others => others.bottom <= size.top + TOLERANCE && others.bottom > size.top - 1.8 * unitOf(own) &&
                others.left < size.right && size.left < others.right;
            for (const other of own.closest(".box").querySelectorAll(".quantity, .multiplier"))
                if (isAbove(other.getBoundingClientRect())) fail(`${name(other)} is close to the number ${own.textContent}`);
        }
        for (const own of findParts(sheet))
            if (getPartScale(own) < 0.99 * partScale)
                fail(`${name(own)} ${own.ariaLabel} has ${(getPartScale(own) / partScale).toFixed(2)} of the scale of other parts`);
    });
    return failures;
})()"""

failures = []
for paper, size in PAPERS.items():
    with Browser(*size) as browser:
        browser.emulate_media("print")
        browser.open(sys.argv[1])
        failures += [f"{paper}, {failure}" for failure in browser.evaluate(FIND_FAILURES)]
        # In true size, a sheet is 128 mm wide.
        width = browser.evaluate("document.querySelector('.sheet')?.getBoundingClientRect().width ?? 0")
        if abs(width - 484) > 3:
            failures.append(f"{paper}: a sheet is {width:.0f} pixels wide instead of 484")
for failure in failures:
    print(failure)
sys.exit(1 if failures else 0)
