#!/usr/bin/env python3
"""Checks the sheets of a booklet as Chromium lays them out for A5: nothing leaves its sheet, its column or its block, no two
things overlap, and pictures have nearly the size that was planned.

Usage: check-sheets.py FILE.html
"""
import sys

from browser import Browser

A5 = (484, 692)  # pixels of CSS, without its margins

# Each failure as a text. Things that are within each other in the document may overlap.
FIND_FAILURES = """(() => {
    const BLOCKS = ".section header, .parts, .true-size, .bag, .step, .submodel, .last-line";
    const THINGS = BLOCKS + ", .parts li, .bag h2, .bag p, .number, .callout, .box, li > svg, .quantity, .letter, .multiplier, " +
        ".box h4, .small-step h5, .turn, .note, .frame, figure > svg, .sheet-parts, .colors, .colors li";
    const TOLERANCE = 1; // pixels
    const failures = [];
    const name = own => own.closest("[data-stop]")?.dataset.stop + ": ." + (own.className.baseVal ?? own.className) + " " +
        own.tagName + " " + own.textContent.trim().replace(/\\s+/g, " ").slice(0, 20);
    const isIn = (own, outer) => own.left > outer.left - TOLERANCE && own.right < outer.right + TOLERANCE &&
        own.top > outer.top - TOLERANCE && own.bottom < outer.bottom + TOLERANCE;
    const overlap = (own, other) => own.left < other.right - TOLERANCE && other.left < own.right - TOLERANCE &&
        own.top < other.bottom - TOLERANCE && other.top < own.bottom - TOLERANCE;
    document.querySelectorAll(".sheet").forEach((sheet, index) => {
        const fail = text => failures.push(`sheet ${index + 1}: ${text}`);
        const limits = sheet.getBoundingClientRect();
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
        for (const own of [sheet, ...sheet.querySelectorAll(".column, .number, .callout, .box, .last-line")])
            if (own.scrollHeight > own.clientHeight + 3 || own.scrollWidth > own.clientWidth + 3)
                fail(`${name(own)} has too much content`);
        for (const own of sheet.querySelectorAll(".model .frame")) {
            const planned = own.getBoundingClientRect().width / parseFloat(getComputedStyle(own).getPropertyValue("--print"));
            const unit = innerWidth / 128 * (parseFloat(getComputedStyle(own).getPropertyValue("--scale")) || 1);
            if (planned < 0.8 * unit) fail(`${name(own)} has ${(planned / unit).toFixed(2)} of the planned size`);
        }
    });
    return failures;
})()"""

with Browser(*A5) as browser:
    browser.emulate_media("print")
    browser.open(sys.argv[1])
    found = browser.evaluate(FIND_FAILURES)
    sheets = browser.evaluate("document.querySelectorAll('.sheet').length")
for failure in found:
    print(failure)
if sheets == 0:
    print("there are no sheets")
sys.exit(1 if found or sheets == 0 else 0)
