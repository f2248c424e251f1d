#!/usr/bin/env python3
"""Checks how a booklet behaves in Chromium: keys, swipes and the bar, the widths of screens, and the policy.

Usage: browse-booklet.py FILE.html
"""
import sys

from browser import Browser

PLACE = "document.querySelector('.steps-bar output').textContent"
# Whether the stop of that name is at the top of the window, or as near to it as the end of the page lets it be.
IS_AT = """(() => {
    const stop = [...document.querySelectorAll('[data-stop]')].find(own => own.dataset.stop === %r);
    const atEnd = Math.abs(document.documentElement.scrollHeight - innerHeight - scrollY) < 2;
    return Math.abs(stop.getBoundingClientRect().top) < 40 || atEnd;
})()"""
failures = []


def expect(is_true, text):
    if not is_true:
        failures.append(text)


def expect_place(browser, place, action):
    expect(browser.evaluate(PLACE) == place, f"{action} leads to {browser.evaluate(PLACE)} instead of {place}")
    expect(browser.evaluate(IS_AT % place), f"{action} does not show {place}")


def expect_fitting(browser, width):
    expect(browser.evaluate("document.documentElement.scrollWidth") <= width,
           f"the page is {browser.evaluate('document.documentElement.scrollWidth')} wide on a screen of {width}")
    loaded = browser.evaluate("[...document.images].every(image => image.complete && image.naturalWidth > 0)")
    expect(loaded, "a picture can't be shown")


def check_keys(path):
    with Browser(1100, 800) as browser:
        browser.open(path)
        expect_fitting(browser, 1100)
        stops = browser.evaluate("[...document.querySelectorAll('[data-stop]')].map(own => own.dataset.stop)")
        expect_place(browser, stops[0], "opening")
        for key, place in (("ArrowRight", 1), ("ArrowDown", 2), ("ArrowLeft", 1), ("End", -1), ("ArrowRight", -1),
                           ("ArrowUp", -2), ("Home", 0), ("ArrowLeft", 0)):
            browser.press(key)
            expect_place(browser, stops[place], key)
        browser.evaluate("document.querySelector('.steps-bar button:last-child').click()")
        browser.settle()
        expect_place(browser, stops[1], "the button")


def check_policy(path):
    """The page has its style and its script, but no other script, style sheet, picture or address."""
    attempts = {
        "script-src-elem": "const own = document.createElement('script'); own.textContent = '1'; document.body.append(own);",
        "script-src-attr": "document.body.setAttribute('onclick', '1');",
        "style-src-elem": "const own = document.createElement('style'); own.textContent = 'p {}'; document.body.append(own);",
        "img-src": "new Image().src = 'http://127.0.0.1:9/picture.png';",
        "connect-src": "fetch('http://127.0.0.1:9/').catch(() => 0);",
        "frame-src": "const own = document.createElement('iframe'); own.src = 'http://127.0.0.1:9/'; document.body.append(own);"}
    with Browser(1100, 800) as browser:
        browser.open(path)
        place = browser.evaluate("getComputedStyle(document.querySelector('.steps-bar')).position")
        expect(place == "fixed", f"the page does not have its style: the bar is {place}")
        for directive, attempt in attempts.items():
            forbidden = browser.evaluate("""new Promise(done => {
                document.addEventListener("securitypolicyviolation", event => done(event.effectiveDirective), {once: true});
                setTimeout(() => done("nothing"), 5000);
                (() => { %s })();
            })""" % attempt)
            expect(forbidden == directive, f"the page forbids {forbidden} instead of {directive}")


def check_phone(path):
    with Browser(390, 844) as browser:
        browser.open(path)
        expect_fitting(browser, 390)
        stops = browser.evaluate("[...document.querySelectorAll('[data-stop]')].map(own => own.dataset.stop)")
        browser.swipe(-150)
        expect_place(browser, stops[1], "a swipe to the left")
        browser.swipe(150)
        expect_place(browser, stops[0], "a swipe to the right")
        shown = browser.evaluate("""(() => {
            const step = document.querySelector('.step');
            return step.getBoundingClientRect().height / innerHeight;
        })()""")
        expect(shown < 1.3, f"a step takes {shown:.1f} screens of a phone")


check_keys(sys.argv[1])
check_phone(sys.argv[1])
check_policy(sys.argv[1])
for failure in failures:
    print(failure)
sys.exit(1 if failures else 0)
