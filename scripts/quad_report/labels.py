"""Symbols of the thesis for the page and for figures, from the plain text of tables and captions ("gamma_w,exp", "lambda(D_bd)")."""
import re

from markupsafe import Markup, escape

WORDS = (("||e||", "\u2016e\u2016"), ("lambda", "\u03bb"), ("gamma", "\u03b3"), ("<=", "\u2264"))
INDEXED = re.compile(r"([\u03b3\u03bbDTP\u0398W\u03b8f])_(w,exp|w,sim|Texp|init|eff|exp|des|bd|min|tr|w|e|0|T|c)\b")
ENTRY = re.compile(r"\b([AB])(12|21|1|2)\b")
HAT = re.compile(r"\b(dT|m)\^")
POWER = re.compile(r"\^(\d)")


def plain(text):
    """Greek letters and signs, indices still written with an underscore."""
    for word, sign in WORDS:
        text = text.replace(word, sign)
    return text


def to_html(text):
    """Safe HTML: everything else in the text is escaped."""
    text = str(escape(plain(str(text))))
    text = HAT.sub(lambda m: "".join(c + "\u0302" for c in m.group(1)), text)
    text = POWER.sub(r"<sup>\1</sup>", text)
    return Markup(ENTRY.sub(r"\1<sub>\2</sub>", INDEXED.sub(r"\1<sub>\2</sub>", text)))


def to_math(text):
    """For matplotlib: indices and hats in mathtext."""
    text = plain(text)
    text = HAT.sub(r"$\\widehat{\1}$", text)
    text = POWER.sub(r"$^\1$", text)
    return ENTRY.sub(r"$\1_{\2}$", INDEXED.sub(lambda m: "$%s_{\\mathrm{%s}}$" % m.groups(), text))


def number(value, digits=6):
    """A number, or the digits somebody printed, for people; a dash where there is none."""
    if value is None or value != value:
        return "\u2013"
    text = "%.*g" % (digits, value) if isinstance(value, (int, float)) else str(value)
    found = re.match(r"(-?[\d.]+)(?:e([-+]?\d+))?$", text)
    if not found:
        return text
    mantissa, exponent = found.groups()
    return mantissa.replace("-", "\u2212") + ("\u00b710" + superscript(int(exponent)) if exponent else "")


def superscript(value):
    return str(value).translate(str.maketrans("-0123456789", "\u207b\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079"))
