"""A reader of LDraw's files for tests: the parts of bricks and plates, in their steps and places."""
import collections
import csv
import pathlib

COLORS = pathlib.Path(__file__).resolve().parent.parent.parent / "data" / "ldraw-solid-colours.csv"
SIZES = ("1 x 1", "1 x 2", "1 x 3", "1 x 4", "1 x 6", "1 x 8", "2 x 2", "2 x 3", "2 x 4", "2 x 6", "2 x 8")
# As BrickLink and LDraw number them.
BRICKS = "3005 3004 3622 3010 3009 3008 3003 3002 3001 2456 3007".split()
PLATES = "3024 3023 3623 3710 3666 3460 3022 3021 3020 3795 3034".split()

Reference = collections.namedtuple("Reference", "name color place axes")


class Step:
    def __init__(self):
        self.references, self.changes_view = [], False


def name_part(number):
    """The name of a part, such as "Brick 2 x 4"."""
    family, numbers = ("Brick", BRICKS) if number in BRICKS else ("Plate", PLATES)
    return f"{family} {SIZES[numbers.index(number)]}"


def describe_color(color):
    """The name of a colour, and BrickLink's number of it as text. Colours without a code are text themselves."""
    if isinstance(color, str):
        return color, ""
    with open(COLORS, encoding="utf-8") as file:
        for row in csv.reader(file):
            if row[0] == str(color):
                return row[1], row[4]
    raise ValueError(f"no colour has the code {color}")


class Document:
    """The files of a .ldr or .mpd, each as a list of steps."""

    def __init__(self, text):
        self.files, self.main, steps = {}, None, None
        for line in text.splitlines():
            words = line.split()
            if words[:2] == ["0", "FILE"] or steps is None:
                name = " ".join(words[2:]).lower() if words[:2] == ["0", "FILE"] else ""
                self.main = name if self.main is None else self.main
                steps = self.files.setdefault(name, [Step()])
            if words[:1] == ["1"]:
                steps[-1].references.append(self._read(words))
            elif words[:2] == ["0", "ROTSTEP"]:
                steps[-1].changes_view = True
            elif words[:2] == ["0", "STEP"]:
                steps.append(Step())
        for steps in self.files.values():
            if not steps[-1].references:
                steps.pop()

    @staticmethod
    def _read(words):
        code = int(words[1], 0)
        color = f"#{code & 0xFFFFFF:06X}" if code >= 0x2000000 else code
        numbers = [float(word) for word in words[2:14]]
        name = " ".join(words[14:]).lower()
        return Reference(name.removesuffix(".dat"), color, tuple(numbers[:3]), tuple(numbers[3:]))

    def visit(self, file, visit, place=(0, 0, 0)):
        """Visit all parts with their places. Submodels are not turned against each other."""
        for step in self.files[file]:
            for own in step.references:
                moved = tuple(a + b for a, b in zip(place, own.place))
                if own.name in self.files:
                    assert own.axes == (1, 0, 0, 0, 1, 0, 0, 0, 1), own
                    self.visit(own.name, visit, moved)
                else:
                    visit(own, moved)

    def count_parts(self, file):
        counts = collections.Counter()
        self.visit(file, lambda own, place: counts.update([(own.name, own.color)]))
        return counts

    def find_places(self, file):
        """The parts with their colours, directions and places, relative to the lowest ones."""
        found = []
        self.visit(file, lambda own, place: found.append((own.name, own.color, abs(own.axes[0]) > 0.5, place)))
        lowest = [min(place[axis] for *_, place in found) for axis in range(3)]
        return sorted((*own, tuple(round(a - b, 3) for a, b in zip(place, lowest))) for *own, place in found)
