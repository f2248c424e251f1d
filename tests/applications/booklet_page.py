"""The elements of a booklet's page, and the text that its reader sees."""
import base64
import html.parser
import struct

VOID = {"meta", "img", "br", "link", "input", "hr"}


class Element(dict):
    """An element: its attributes, its tag, its parent and its children, which are elements and texts."""

    def __init__(self, tag, attributes, parent):
        super().__init__({name: value or "" for name, value in attributes})
        self.tag, self.parent, self.content = tag, parent, []

    def __bool__(self):
        return True  # also without attributes

    @property
    def children(self):
        return [own for own in self.content if isinstance(own, Element)]

    def has_class(self, name):
        return name in self.get("class", "").split()

    def is_hidden(self):
        return self.tag in ("style", "script", "head") or self.has_class("hidden") or self.has_class("symbols")

    def find_ancestor(self, is_wanted):
        """The nearest element around this one that satisfies a condition, or None."""
        return self.parent and (self.parent if is_wanted(self.parent) else self.parent.find_ancestor(is_wanted))

    def get_text(self):
        """The text that a reader sees, with single spaces."""
        texts = [own if isinstance(own, str) else "" if own.is_hidden() else own.get_text() for own in self.content]
        return " ".join("".join(texts).split())


class Page(html.parser.HTMLParser):
    """The elements in the order of the page; `failures` names tags that don't match."""

    def __init__(self, text):
        super().__init__()
        self.elements, self.failures, self._open = [], [], None
        self.feed(text)
        self.close()
        if self._open:
            self.failures.append(f"not closed: {self._open.tag}")

    def handle_starttag(self, tag, attributes):
        own = Element(tag, attributes, self._open)
        self.elements.append(own)
        if self._open:
            self._open.content.append(own)
        if tag not in VOID:
            self._open = own

    def handle_startendtag(self, tag, attributes):
        self.handle_starttag(tag, attributes)
        if tag not in VOID:
            self._open = self._open.parent

    def handle_endtag(self, tag):
        if not self._open or self._open.tag != tag:
            self.failures.append(f"</{tag}> closes {self._open.tag if self._open else 'nothing'}")
        else:
            self._open = self._open.parent

    def handle_data(self, data):
        if self._open:
            self._open.content.append(data)

    def find_id(self, name):
        return next((own for own in self.elements if own.get("id") == name), None)


def decode(link):
    """The content of a data URL."""
    kind, text = link.removeprefix("data:").split(",", 1)
    assert kind.endswith(";base64"), kind
    return base64.b64decode(text, validate=True)


def size_of(data):
    """The width and height of a JPEG or PNG picture, in pixels."""
    if data[:8] == b"\x89PNG\r\n\x1a\n":
        return struct.unpack(">II", data[16:24])
    if data[:2] != b"\xff\xd8":
        raise ValueError("neither JPEG nor PNG")
    place = 2
    while data[place + 1] not in (0xC0, 0xC1, 0xC2):
        place += 2 + int.from_bytes(data[place + 2:place + 4], "big")
    height, width = struct.unpack(">HH", data[place + 5:place + 9])
    return width, height
