// Keys, swipes and a bar lead from stop to stop: the cover, the parts, each step, and the finished model.
(() => {
    "use strict";
    const stops = [...document.querySelectorAll("[data-stop]")];
    const bar = document.createElement("nav");
    bar.className = "steps-bar";
    bar.setAttribute("aria-label", "Steps");
    const addButton = (sign, label, action) => {
        const button = document.createElement("button");
        button.type = "button";
        button.textContent = sign;
        button.setAttribute("aria-label", label);
        button.addEventListener("click", action);
        bar.append(button);
        return button;
    };

    const findCurrent = () => {
        const upperQuarter = window.innerHeight / 4;
        let current = 0;
        stops.forEach((stop, index) => { if (stop.getBoundingClientRect().top < upperQuarter) current = index; });
        return current;
    };
    const isCalm = window.matchMedia("(prefers-reduced-motion: reduce)").matches;
    // Keys count from the stop that they led to last, which may be lower in the window at the end of the page, until the
    // reader scrolls.
    let target = null;
    const goTo = index => {
        target = Math.max(0, Math.min(stops.length - 1, index));
        stops[target].scrollIntoView({ behavior: isCalm ? "auto" : "smooth", block: "start" });
        show();
    };
    const goBy = steps => goTo((target ?? findCurrent()) + steps);

    const back = addButton("\u2039", "Previous", () => goBy(-1));
    const place = document.createElement("output");
    bar.append(place);
    const next = addButton("\u203a", "Next", () => goBy(1));
    const show = () => {
        const current = target ?? findCurrent();
        place.textContent = stops[current].dataset.stop;
        back.disabled = current === 0;
        next.disabled = current === stops.length - 1;
    };
    document.body.append(bar);
    window.addEventListener("scroll", show, { passive: true });
    for (const name of ["wheel", "touchmove", "mousedown"])
        window.addEventListener(name, event => {
            if (!bar.contains(event.target)) target = null;
        }, { passive: true });

    const moves = {
        ArrowRight: () => goBy(1), ArrowDown: () => goBy(1), PageDown: () => goBy(1),
        ArrowLeft: () => goBy(-1), ArrowUp: () => goBy(-1), PageUp: () => goBy(-1),
        Home: () => goTo(0), End: () => goTo(stops.length - 1)
    };
    window.addEventListener("keydown", event => {
        if (!moves[event.key] || event.altKey || event.ctrlKey || event.metaKey || event.shiftKey) return;
        event.preventDefault();
        moves[event.key]();
    });

    let start = null;
    window.addEventListener("touchstart", event => {
        start = event.touches.length === 1 ? event.touches[0] : null;
    }, { passive: true });
    window.addEventListener("touchend", event => {
        if (!start) return;
        const right = event.changedTouches[0].clientX - start.clientX;
        const down = event.changedTouches[0].clientY - start.clientY;
        if (Math.abs(right) > 60 && Math.abs(right) > 2 * Math.abs(down)) goBy(right < 0 ? 1 : -1);
        start = null;
    }, { passive: true });
    show();
})();
