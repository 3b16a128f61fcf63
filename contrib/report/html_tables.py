# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of the report in HTML, and how numbers are written."""

import html
import math

RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def escape(text):
    return html.escape(str(text))


def number(value, digits=4):
    """A number of so many digits; a dash where there is none."""
    if value is None or not math.isfinite(value):
        return "–"
    if value == 0.:
        return "0"
    exponent = math.floor(math.log10(abs(value)))
    if exponent < -3 or exponent > 5:
        mantissa, power = f"{value:.{digits - 1}e}".split("e")
        return f"{mantissa}·10{str(int(power)).translate(RAISED)}".replace("-", "−")
    text = f"{float(f'{value:.{digits - 1}e}'):.{max(digits - 1 - exponent, 0)}f}"
    return text.replace("-", "−")


def whole(value):
    """A whole number with narrow blanks between thousands."""
    return f"{value:,.0f}".replace(",", "\u202f").replace("-", "−") if math.isfinite(value) else "–"


def short(value, digits=3):
    """A number of at most so many digits, as people write what they have chosen."""
    text = number(value, digits)
    return text.rstrip("0").rstrip(".") if "." in text and "·" not in text else text


def percent(share):
    """A share of 1, with its sign, in per cent."""
    if not math.isfinite(share):
        return "–"
    return "0.000 %" if abs(share) < 5e-6 else f"{100. * share:+.3f} %".replace("-", "−")


def seconds(value):
    """A wall time."""
    if not math.isfinite(value):
        return "–"
    if value < 120.:
        return f"{number(value, 3)} s"
    minutes = round(value / 60.)
    return f"{minutes} min" if minutes < 120 else f"{minutes // 60} h {minutes % 60:02d} min"


class Html(str):
    """Text that is HTML already."""


def cell(content, tag="td", is_number=False, extra=""):
    content = content if isinstance(content, Html) else escape(content)
    return f"<{tag}{' class=n' if is_number else ''}{extra}>{content}</{tag}>"


def table(head, rows, numbers=(), caption="", kind=""):
    """A table with the columns @p numbers aligned as numbers; rows are lists of texts."""
    lines = [f'<div class="scroll"><table class="{kind}">']
    if caption:
        lines.append(f"<caption>{escape(caption)}</caption>")
    lines.append("<thead><tr>" + "".join(cell(text, "th", i in numbers) for i, text in enumerate(head))
                 + "</tr></thead><tbody>")
    lines += ["<tr>" + "".join(cell(text, "td", i in numbers) for i, text in enumerate(row)) + "</tr>" for row in rows]
    return "\n".join([*lines, "</tbody></table></div>"])


def details(summary, content):
    return f"<details><summary>{escape(summary)}</summary>{content}</details>"


def items(texts):
    return "<ul>" + "".join(f"<li>{escape(text)}</li>" for text in texts) + "</ul>"
