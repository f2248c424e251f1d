"""The tables of docs/performance.md, from the documents that scripts/bench measures or reads."""
import os
import re

MARKERS = ("<!-- figures: scripts/bench summary -->", "<!-- end of figures -->")
SHOWN_CONTENDERS = ("points, projected", "exact, passes", "passalis", "dominant axis", "exact, cpu", "exact, node",
                    "plain loop", "openvdb", "openvdb, narrow")


class SummaryError(Exception):
    """Figures that a summary can't have, or a page without a place for them."""


def check_commit(documents):
    """Raise SummaryError unless all figures are of one commit, built without other changes."""
    commits = list(dict.fromkeys(document["environment"]["commit"] for document in documents))
    if len(commits) > 1:
        raise SummaryError(f"figures are of the commits {', '.join(commits)}; expected figures of one commit")
    if commits[0].endswith("-dirty"):
        raise SummaryError(f"figures are of '{commits[0]}', a build with uncommitted changes; expected figures of a commit")


def table(head, rows):
    def line(cells):
        return "| " + " | ".join(str(cell) for cell in cells) + " |\n"
    return line(head) + "|" + "---|" * len(head) + "\n" + "".join(line(row) for row in rows)


def number(value, digits=0):
    return f"{value:,.{digits}f}"


def milliseconds(value):
    return number(value, 1 if value < 100 else 0)


def ratio(value):
    return number(value, 2 if value < 10 else 1 if value < 100 else 0)


def verdict(goals):
    """How many goals are missed."""
    missed = sum(not goal.reached for goal in goals)
    return f"**{missed} of {len(goals)}**" if missed else f"0 of {len(goals)}"


def group(rows, key):
    """Rows by a key, both in the order of their first occurrence."""
    groups = {}
    for row in rows:
        groups.setdefault(key(row), []).append(row)
    return groups


# ---- Tables of each benchmark

def voxelize_summary(documents, goals):
    meshes = [mesh for document in documents for mesh in document["meshes"]]
    head = ["milliseconds"] + [f"{mesh['mesh']} {mesh['resolution']}" for mesh in meshes] + ["recall, tunnels"]
    quality = next((mesh for mesh in meshes if mesh["resolution"] == 128), meshes[-1])
    rows = []
    for name in SHOWN_CONTENDERS:
        found = [next((row for row in mesh["contenders"] if row["name"] == name and "failure" not in row), None)
                 for mesh in meshes]
        if not any(found):
            continue
        seen = found[meshes.index(quality)]
        rows.append([f"`{name}`"] + [milliseconds(row["milliseconds"]["median"]) if row else "-" for row in found]
                    + [f"{seen['recall']:.2f}, {seen['tunnels']:,}" if seen and "cells" in seen else "-"])
    text = table(head, rows)
    text += f"\nRecall and tunnels: {quality['mesh']} at {quality['resolution']}. Ratios of medians, and their goals:\n\n"
    places = [f"{mesh['mesh']} at {mesh['resolution']}" for mesh in meshes]
    rows = []
    kinds = [*dict.fromkeys(goal.compared for goal in goals)]
    by_ratio = group(sorted(goals, key=lambda goal: kinds.index(goal.compared)),
                     lambda goal: (goal.compared, re.sub(r", \d+ tunnels$", "", goal.what)))
    for (compared, title), found in by_ratio.items():
        figures = {goal.where: goal for goal in found}
        ordered = [figures[place] for place in places if place in figures] or found
        where = dict.fromkeys(goal.where.split(" at ")[0].split(",")[0] for goal in ordered)
        values = "; ".join(f"{mesh} " + ", ".join(
            ratio(goal.figure) + ("" if goal.reached else "*") for goal in ordered
            if goal.where.split(" at ")[0].split(",")[0] == mesh) for mesh in where)
        bounds = sorted({goal.bound for goal in found})
        bound = " to ".join(f"{value:g}" for value in (bounds if len(bounds) == 1 else (bounds[0], bounds[-1])))
        rows.append([compared, title, values, ("at most " if found[0].at_most else "at least ") + bound, verdict(found)])
    return text + table(["compared", "ratio", "figures", "goal", "missed"], rows)


def frame_summary(documents, goals):
    text = ""
    for document in documents:
        looks = list(dict.fromkeys(row["look"] for row in document["rows"]))
        rows = []
        for (mesh, resolution, view), found in group(
                document["rows"], lambda row: (row["mesh"], row["resolution"], row["view"])).items():
            cells = {row["look"]: row for row in found}
            line = [f"{mesh} {resolution}, {view}"]
            for look in looks:
                row = cells.get(look)
                if not row:
                    line.append("-")
                    continue
                present, reference = row["presentMilliseconds"]["median"], row["referenceMilliseconds"]["median"]
                is_reached = reference / present >= 4.0 and row["difference"]["same"]
                line.append(f"{milliseconds(present)} ({ratio(reference / present)}){'' if is_reached else '*'}")
            rows.append(line)
        text += table([f"ms, {document['width']} x {document['height']} (times as fast)"] + looks, rows)
    others = [goal for goal in goals if goal.unit == "ms"]
    if others:
        text += "\n" + " ".join(f"{goal.what[0].upper()}{goal.what[1:]}: {goal.figure:.0f} ms, goal {goal.bound:.0f} ms, "
                                f"{'reached' if goal.reached else '**missed**'}." for goal in others) + "\n"
    return text


def draw_summary(documents, goals):
    rows = [row for document in documents for row in document["rows"]]
    counted = [row for row in rows if "unchanged" in row]
    text = ""
    if counted:
        head = [f"{counted[0]['frames']} frames in which nothing changes, {counted[-1]['mesh']} {counted[-1]['resolution']}"]
        for row in counted:
            head.append("a box of OSG's" if row["look"] == "none" else f"{row['look']}, {row['drawnBy']}" + (
                ", occlusion" if row["occlusion"] else "") + ("" if row["device"] == "auto" else f", {row['device']}"))
        text += table(head, [[title] + [row["unchanged"].get(key, "not traced") for row in counted] for title, key in (
            ("bricks made", "legolizations"), ("waits for the renderer", "waits"), ("allocations", "allocations"))])
    first = [row for row in rows if row["frames"] == 0]
    if first:
        text += "\nPeak memory in MiB of a process that makes the bricks and draws a frame with ambient occlusion:\n\n"
        lines = [[row["device"], row["resolution"], number(row.get("drawnBricks", 0)),
                  number(row["mebibytes"]["resident"])] + [
                      number(row["mebibytes"][key]) if key in row["mebibytes"] else "not traced"
                      for key in ("gl", "largestGlObject", "largestBlock")] for row in first]
        text += table(["device", "N", "bricks", "resident", "of that GL's", "largest of GL", "largest block"], lines)
    return text + goal_lines([goal for goal in goals if goal.compared in ("memory", "unchanged frames")])


def goal_lines(goals):
    missed = [goal for goal in goals if not goal.reached]
    text = "".join(f" {goal.what}, {goal.where}: {goal.figure_text}, goal {goal.bound_text}." for goal in missed)
    return f"\nOf {len(goals)} goals, {len(missed)} are missed." + text + "\n" if goals else ""


def layout_cells(row):
    missed = {goal["what"] for goal in row.get("goals", []) if not goal["reached"]}

    def mark(text, what):
        return text + ("*" if what in missed else "")
    bound = row.get("bound", {})
    rest = bound.get("layers", 0) - bound.get("optimalLayers", 0)
    share = mark(f"{row['ofPlates']:.3f} of plates", "parts / plates alone") if "ofPlates" in row else \
        mark(f"{row['ratio']:.3f}", "parts / bound") + (f" ({rest} not proved)" if rest else "") if "ratio" in row else "-"
    return [number(row["parts"]), share, mark(f"{100.0 * row['stacked']:.1f} %", "stacked"),
            mark(f"{row['components']} of {row['componentsPossible']}", "components"),
            mark(f"{100.0 * row['articulation']:.1f} %", "articulation"),
            mark(number(row["milliseconds"]["median"]), "milliseconds")]


def layout_summary(documents, goals):
    """A row for each mesh of a figure, with its resolutions side by side."""
    rows = []
    by_mesh = group((row for document in documents for row in document["rows"]),
                    lambda row: (row["figure"], row["mesh"]))
    for (figure, mesh), found in by_mesh.items():
        cells = [layout_cells(row) for row in found]
        rows.append([f"{figure}: {mesh} " + "; ".join(str(row["resolution"]) for row in found)]
                    + ["; ".join(column) for column in zip(*cells)])
    return table(["figure: model", "parts", "parts / bound", "stacked", "components", "articulation", "ms"], rows) \
        + f"\nOf {len(goals)} goals, {sum(not goal.reached for goal in goals)} are missed (*).\n"


def name_stability(row):
    return f"{row['mesh']} {row['resolution']}" + (", solid" if row.get("fill") == "solid" else "")


def starred(value, goal):
    return number(value) + ("" if value <= goal else "*")


def stability_summary(documents, _):
    rows = [[name_stability(row), number(row["parts"]), number(row["forces"]),
             starred(row["milliseconds"]["median"], row["goal"]), number(row["goal"]),
             starred(row["peakMemory"], row["memoryGoal"]) if "peakMemory" in row else "-",
             number(row["clp"]) if "clp" in row else "-", row["falling"], f"{row['margin']:.2f}"]
            for document in documents for row in document["rows"]]
    return table(["model", "parts", "forces", "ms, * missed", "goal, ms", "MiB, * missed", "CLP's barrier, ms", "parts that fall",
                  "margin"], rows)


def building_summary(documents, _):
    rows = [[f"{row['mesh']} `{row['settings']}`", number(row["parts"]), row["unheld"],
             f"{row['floatingLayerSteps']} of {row['layerSteps']}", f"{row['floatingSteps']} of {row['steps']}",
             row["fallingSteps"], f"{row['submodels']}: {row['fallingSubmodelSteps']} of {row['submodelSteps']}",
             row["uncheckedSteps"], number(row["milliseconds"]["median"]),
             number(row["stabilityMilliseconds"]["median"])]
            for document in documents for row in document["rows"]]
    return table(["model", "parts", "not placeable", "layer by layer, steps that float", "planned, steps that float",
                  "that fall", "submodels: steps that fall", "unchecked", "ms", "with stability"], rows)


# The pages of docs/, and the sections of each: a benchmark, its title, and its tables.
PAGES = {"performance.md": (("voxelize", "From mesh to bricks", voxelize_summary), ("frame", "Drawing", frame_summary),
                            ("draw", "Unchanged frames and memory", draw_summary)),
         "layout.md": (("layout", None, layout_summary),), "stability.md": (("stability", None, stability_summary),),
         "building.md": (("building", None, building_summary),)}


def place_text(documents):
    """The commit and the machines."""
    places = dict.fromkeys((place["processor"], place["threads"], place["date"][:10])
                           for place in (document["environment"] for document in documents))
    return f"commit {documents[0]['environment']['commit']} on " + "; ".join(
        f"{processor}, {threads} threads, {date}" for processor, threads, date in places)


def overview(documents, goals):
    """The number of goals of each kind, with those that are missed."""
    renderer = next((document["environment"]["renderer"] for document in documents
                     if "renderer" in document["environment"]), "none")
    kinds = group(goals, lambda goal: goal.compared.partition(",")[0])
    rows = [[kind, len(found), sum(not goal.reached for goal in found)] for kind, found in kinds.items()]
    rows.append(["all", len(goals), sum(not goal.reached for goal in goals)])
    return (f"Measured on {place_text(documents)}; renderer: {renderer}.\n\n"
            + table(["goals", "number", "missed"], rows))


def format_page(sections, documents, find_goals):
    """The place stands once above several sections."""
    text = ""
    for benchmark, title, summarize in sections:
        found = [document for document in documents if document["benchmark"] == benchmark]
        if found:
            text += f"\n## {title}\n\n" if title else f"\nMeasured on {place_text(found)}.\n\n"
            text += summarize(found, find_goals(found))
    return text


def update_pages(folder, documents, find_goals):
    """Replace the text between the markers of all pages that have tables of these documents.
    @param find_goals gives the goals of several documents.
    @return the pages that have changed; raises SummaryError for figures that check_commit() refuses, before any page
    changes, and for a page without markers."""
    check_commit(documents)
    pages = []
    for name, sections in PAGES.items():
        text = format_page(sections, documents, find_goals)
        if not text:
            continue
        file_name = os.path.join(folder, name)
        if name == "performance.md":
            text = "\n" + overview(documents, find_goals(documents)) + text
        update_page(file_name, text)
        pages.append(file_name)
    return pages


def update_page(file_name, text):
    with open(file_name, encoding="utf-8") as file:
        page = file.read()
    begin, end = page.find(MARKERS[0]), page.find(MARKERS[1])
    if begin < 0 or end < begin:
        raise SummaryError(f"'{file_name}' has no markers; expected the lines {' and '.join(MARKERS)}")
    temporary = file_name + ".part"
    with open(temporary, "w", encoding="utf-8") as file:
        file.write(page[:begin] + MARKERS[0] + "\n" + text + "\n" + page[end:])
    os.replace(temporary, file_name)
