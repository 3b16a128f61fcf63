# SPDX-License-Identifier: GPL-3.0-or-later
"""Random changes of parameter files and mesh files. All random numbers are those of the module random."""
import random
import re
import struct

# Values that stand for a number.
NUMBERS = ["0", "-1", "1", "-0", "1e308", "-1e308", "1e-308", "5e-324", "1e400", "nan", "inf", "-inf", "", "1e-9", "1e9", "1e12",
           "2147483647", "2147483648", "4294967295", "4294967296", "-2147483649", "18446744073709551615",
           "99999999999999999999", "0x10", "1e", "1.5.2", "--1", "1,5", "0.1", "3", "100", "1e-3", "1e5"]

NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
WORD = re.compile(r"[A-Za-z$][A-Za-z'$-]*")


# What stands for some bytes of a binary file.
BINARY = [struct.pack("<" + kind, value) for kind, values in (
    ("i", (0, 1, -1, 2, 4, 1000, 2**31 - 1, -2**31)), ("q", (0, 1, -1, 2**31, 2**32, 2**62, 2**63 - 1, -2**63)),
    ("d", (0., -1., 1e308, -1e308, 5e-324, float("nan"), float("inf")))) for value in values]


class Mutator:
    """Changes of a text; @p words are those of all texts, @p lines too."""

    def __init__(self, words, lines):
        self.words, self.lines = words, lines

    def mutate(self, text):
        for _ in range(random.choice([1, 1, 1, 2, 2, 3, 5])):
            text = random.choice(self.CHANGES)(self, text)
        return text

    def change_lines(self, text):
        lines = text.split(b"\n")
        i, j = random.randrange(len(lines)), random.randrange(len(lines))
        kind = random.randrange(6)
        if kind == 0:
            del lines[i]
        elif kind == 1:
            lines.insert(i, lines[i])
        elif kind == 2:
            lines[i], lines[j] = lines[j], lines[i]
        elif kind == 3:
            lines.insert(i, random.choice(self.lines))
        elif kind == 4:
            lines[i] = random.choice(self.lines)
        else:
            del lines[min(i, j):max(i, j)]
        return b"\n".join(lines)

    def change_match(self, pattern, replacements, text):
        matches = list(re.finditer(pattern.pattern.encode(), text))
        if not matches:
            return text
        match = random.choice(matches)
        return text[:match.start()] + random.choice(replacements) + text[match.end():]

    def change_number(self, text):
        return self.change_match(NUMBER, [number.encode() for number in NUMBERS], text)

    def scale_number(self, text):
        matches = list(re.finditer(NUMBER.pattern.encode(), text))
        if not matches:
            return text
        match = random.choice(matches)
        value = float(match.group()) * random.choice([-1., 0.5, 1.001, 2., 10., 1e3, 1e-3, 1e6, 1e-6])
        return text[:match.start()] + b"%.12g" % value + text[match.end():]

    def change_word(self, text):
        return self.change_match(WORD, self.words, text)

    def change_bytes(self, text):
        data = bytearray(text)
        for _ in range(random.choice([1, 1, 4, 50])):
            place = random.randrange(len(data) + 1)
            data[place:place + random.randrange(3)] = random.randbytes(random.randrange(3))
        return bytes(data)

    def change_binary(self, text):
        value = random.choice(BINARY)
        place = random.randrange(max(1, len(text) - len(value)))
        return text[:place] + value + text[place + len(value):]

    def change_separator(self, text):
        return self.change_match(re.compile("[,:;=#\"/ ]"), [b",", b":", b";", b"=", b"#", b" ", b"", b"\"", b"\0", b"\\", b"\r\n", b"/"], text)

    def truncate(self, text):
        return text[:random.randrange(len(text) + 1)]

    def change_structure(self, text):
        lines = text.split(b"\n")
        lines.insert(random.randrange(len(lines) + 1), random.choice([
            b"end", b"end\nend", b"subsection", b"subsection " + random.choice(self.words), b"subsection a\n" * 2000, b"set",
            b"set " + random.choice(self.words) + b" = 1", b"include case.prm", b"include", b"x" * 100000, b"$Elements",
            b"set Gravity = " + b"1, " * 50000, b"set Solids = " + b", ".join(b"solid %d" % i for i in range(100)), b"set Fluids = fluid, other",
            b"set Boundaries = walls, walls", b"set Dimension = 3",
            b"set Corners = " + b"0, 0 : 1, 1; " * 30]))
        return b"\n".join(lines)

    CHANGES = [change_lines, change_number, change_number, change_number, scale_number, change_word, change_word,
               change_bytes, change_binary, change_separator, truncate, change_structure]
