"""Texts in the protocol's units: lines, columns in a negotiated encoding, edits.

Offsets are Python's, in characters. A marked text contains names in `«»` at the positions that a
test uses; the marks are removed before the text is used.
"""

import re

MARK = re.compile("«(\\w+)»")
LINE_BREAK = re.compile("\r\n|\n|\r")


def marked(text):
    """A text without its marks, and the offset of each mark."""
    places, clean, end = {}, [], 0
    size = 0
    for mark in MARK.finditer(text):
        clean.append(text[end:mark.start()])
        size += mark.start() - end
        if mark.group(1) in places:
            raise ValueError("two marks are called " + mark.group(1))
        places[mark.group(1)] = size
        end = mark.end()
    clean.append(text[end:])
    return "".join(clean), places


def units(text, encoding):
    """The number of columns of a part of a line."""
    if encoding == "utf-8":
        return len(text.encode("utf-8"))
    if encoding == "utf-16":
        return len(text.encode("utf-16-le")) // 2
    return len(text)


class Lines:
    """A text with its lines."""

    def __init__(self, text, encoding):
        self.text = text
        self.encoding = encoding
        # For each line: its start, and its end without the line break.
        self.lines = []
        start = 0
        for ending in LINE_BREAK.finditer(text):
            self.lines.append((start, ending.start()))
            start = ending.end()
        self.lines.append((start, len(text)))

    def position(self, offset):
        """The position of an offset."""
        low, high = 0, len(self.lines) - 1
        while low < high:
            middle = (low + high + 1) // 2
            if self.lines[middle][0] <= offset:
                low = middle
            else:
                high = middle - 1
        start, end = self.lines[low]
        return {"line": low, "character": units(self.text[start:min(offset, end)], self.encoding)}

    def range(self, start, end):
        """The range between two offsets."""
        return {"start": self.position(start), "end": self.position(end)}

    def offset(self, position, strict=True):
        """The offset of a position. A server must not use positions that do not exist."""
        line, column = position["line"], position["character"]
        if line >= len(self.lines):
            if strict:
                raise ValueError("there is no line %d" % line)
            return len(self.text)
        start, end = self.lines[line]
        if self.text[start:end].isascii():
            at = start + column
        else:
            at, left = start, column
            while left > 0 and at < end:
                left -= units(self.text[at], self.encoding)
                at += 1
            if left < 0:
                raise ValueError("the position %r lies inside of a character" % position)
            at += left
        if at > end:
            if strict:
                raise ValueError("line %d has no column %d" % (line, column))
            return end
        return at

    def span(self, range_):
        """The offsets of a range."""
        start, end = self.offset(range_["start"]), self.offset(range_["end"])
        if start > end:
            raise ValueError("the range %r ends before it starts" % range_)
        return start, end

    def at(self, range_):
        """The text in a range."""
        start, end = self.span(range_)
        return self.text[start:end]


def apply_edits(text, edits, encoding):
    """A text after edits whose positions all refer to the original text, as the protocol defines."""
    lines = Lines(text, encoding)
    spans = []
    for number, edit in enumerate(edits):
        start, end = lines.span(edit["range"])
        spans.append((start, end, number, edit["newText"]))
    spans.sort(key=lambda s: (s[0], s[1], s[2]))
    out, last = [], 0
    for start, end, _, new in spans:
        if start < last:
            raise ValueError("two edits overlap at offset %d" % start)
        out += [text[last:start], new]
        last = end
    return "".join(out) + text[last:]


def apply_change(text, change, encoding):
    """A text after one change of `textDocument/didChange`."""
    if "range" not in change:
        return change["text"]
    start, end = Lines(text, encoding).span(change["range"])
    return text[:start] + change["text"] + text[end:]
