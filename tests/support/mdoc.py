"""Reads what man pages in mdoc(7) say: sections, tagged lists, commands with their output."""

import re


def sections_of(page):
    """{title: text} of a page."""
    parts = re.split(r"^\.Sh (.*)\n", page, flags=re.M)
    return {title: text for title, text in zip(parts[1::2], parts[2::2])}


def options_of(section):
    """{option names: (argument, text)} from the tagged list of OPTIONS."""
    options = {}
    for item in re.split(r"^\.It ", section, flags=re.M)[1:]:
        tag, _, text = item.partition("\n")
        names, argument = [], []
        words = iter(tag.split())
        for word in words:
            if word == "Fl":
                names.append("-" + next(words))
            elif word not in ("Ar", "Cm", "Ns") and not (word == "," and not argument):
                argument.append(word)
        options[frozenset(names)] = ("".join(argument), text)
    return options


def plain(text):
    """Text of a literal display as it is read."""
    return text.replace(r"\-", "-").replace(r"\e", "\\").replace(r"\(dq", '"').replace(r"\&", "")


def transcripts(section):
    """[(command, output shown or "")]: `.Dl $ command`, and the literal display that follows it at once."""
    pattern = r"^\.Dl \$ (.*)\n(?:\.Bd -literal -offset indent\n((?:[^.].*\n|\n)*)\.Ed\n)?"
    return [(plain(command), plain(shown)) for command, shown in re.findall(pattern, section + "\n", re.M)]


def references(page):
    """{"uhas-solve(1)"} of the cross references of a page."""
    return {f"{name}({number})" for name, number in re.findall(r"^\.(?:It )?Xr (\S+) (\d)", page, re.M)}
