"""Mutants of C++ sources: one small edit each, derived from the tokens of a file.

The sources are formatted by clang-format, so that an operator between operands has a space on either side, and the
angle brackets of templates have none.
"""

import random
import re
from dataclasses import dataclass
from pathlib import Path

TOKEN = re.compile(
    r"""
    (?P<skip>\s+ | //[^\n]* | /\*.*?\*/ | ^[ \t]*\#(?:[^\n\\]|\\.)* )
  | (?P<string>(?:u8|[uUL])?R"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)" | (?:u8|[uUL])?"(?:[^"\\\n]|\\.)*" | '(?:[^'\\\n]|\\.)+')
  | (?P<real>(?:\d[\d']*\.\d*|\.\d+)(?:[eE][+-]?\d+)?[fFlL]? | \d+[eE][+-]?\d+)
  | (?P<integer>0[xX][\da-fA-F']+[uUlL]* | 0[bB][01']+[uUlL]* | \d[\d']*[uUlLzZ]*)
  | (?P<word>[A-Za-z_]\w*)
  | (?P<mark_>::|<=>|<<=|>>=|->|\+\+|--|<<|>>|<=|>=|==|!=|&&|\|\||[-+*/%&|^]=|.)
    """,
    re.VERBOSE | re.DOTALL | re.MULTILINE,
)

INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)

BETWEEN = {  # operators between two operands
    "<": ["<=", ">"],
    "<=": ["<", ">="],
    ">": [">=", "<"],
    ">=": [">", "<="],
    "==": ["!="],
    "!=": ["=="],
    "+": ["-"],
    "-": ["+"],
    "*": ["/"],
    "/": ["*"],
    "%": ["/"],
    "<<": [">>"],
    ">>": ["<<"],
    "&&": ["||"],
    "||": ["&&"],
    "&": ["|"],
    "|": ["&"],
    "^": ["&"],
    "+=": ["-="],
    "-=": ["+="],
    "*=": ["/="],
    "/=": ["*="],
    "<<=": [">>="],
    ">>=": ["<<="],
    "&=": ["|="],
    "|=": ["&="],
    "^=": ["|="],
}
WORDS = {
    "min": ["max"],
    "max": ["min"],
    "min_element": ["max_element"],
    "max_element": ["min_element"],
    "floor": ["ceil"],
    "ceil": ["floor"],
    "any_of": ["all_of"],
    "all_of": ["any_of"],
    "lower_bound": ["upper_bound"],
    "upper_bound": ["lower_bound"],
}
NO_OPERANDS = {"return", "case", "throw", "else", "do", "co_return", "operator"}


@dataclass(frozen=True)
class Token:
    kind: str
    text: str
    begin: int

    @property
    def end(self):
        return self.begin + len(self.text)


@dataclass(frozen=True)
class Mutant:
    """An edit that replaces characters begin to end of a file by `after`."""

    file: str
    line: int
    column: int
    begin: int
    end: int
    before: str
    after: str
    kind: str

    @property
    def edit(self):
        return f"{shown(self.before)} -> {shown(self.after)}" if self.after else f"{shown(self.before)} dropped"

    @property
    def key(self):
        return (self.file, str(self.line), str(self.column), self.edit)

    def apply(self, text):
        return text[: self.begin] + self.after + text[self.end :]


def shown(text):
    return " ".join(text.split())


def tokens_of(text):
    found = []
    for match in TOKEN.finditer(text):
        kind = match.lastgroup if match.lastgroup != "mark" else "string"
        if kind != "skip":
            found.append(Token(kind, match.group(), match.start()))
    return found


def closing(tokens, opening):
    """The index of the bracket that closes the one at `opening`; the last token if none does."""
    pairs = {"(": ")", "{": "}", "[": "]"}
    left = tokens[opening].text
    depth = 0
    for i in range(opening, len(tokens)):
        depth += (tokens[i].text == left) - (tokens[i].text == pairs[left])
        if depth == 0:
            return i
    return len(tokens) - 1


def left_alone(tokens):
    """Indices of the tokens of static_asserts, attributes and thrown messages."""
    alone = set()
    for i, token in enumerate(tokens):
        if token.text == "static_assert":
            alone.update(range(i, closing(tokens, i + 1) + 1))
        elif token.text == "[" and i + 1 < len(tokens) and tokens[i + 1].text == "[":
            alone.update(range(i, closing(tokens, i) + 1))
        elif token.text == "throw":
            end = i
            while end < len(tokens) and tokens[end].text != ";":
                end += 1
            alone.update(range(i, end))
    return alone


def is_operand(token):
    return token.kind in ("integer", "real", "string") or token.text in (")", "]", "}") or (
        token.kind == "word" and token.text not in NO_OPERANDS
    )


def constants(token, previous, following):
    if token.kind == "real":
        return [f"({token.text} + 1.0)"]
    if previous.text == "=" and following.text == ";" and token.text == "0":
        return [f"{token.text} + 1"]  # this would not compile for a pure virtual function
    return [f"({token.text} + 1)", f"({token.text} - 1)"]


def between_spaces(text, token):
    return text[token.begin - 1 : token.begin].isspace() and text[token.end : token.end + 1].isspace()


def edits_at(text, tokens, i):
    """(begin, end, after, kind) of every edit of the token."""
    token, previous, following = tokens[i], tokens[i - 1], tokens[i + 1]
    whole = (token.begin, token.end)
    if token.kind in ("integer", "real"):
        return [(*whole, after, "constant") for after in constants(token, previous, following)]
    if token.text in WORDS and following.text == "(":
        return [(*whole, after, "choice") for after in WORDS[token.text]]
    if token.text in ("true", "false"):
        return [(*whole, "false" if token.text == "true" else "true", "truth")]
    if token.text == "!" and previous.text != "operator":
        return [(*whole, "", "negation")]
    if token.text == "-" and not is_operand(previous) and not between_spaces(text, token):
        return [(*whole, "", "sign")]
    if token.text in BETWEEN and is_operand(previous) and previous.text != "template" and between_spaces(text, token):
        return [(*whole, after, "operator") for after in BETWEEN[token.text]]
    if token.text == "if" and following.text == "(":
        return conditions(text, tokens, i + 1)
    return dropped_call(tokens, i)


def conditions(text, tokens, opening):
    end = closing(tokens, opening)
    inside = text[tokens[opening].end : tokens[end].begin]
    if any(token.text == ";" for token in tokens[opening:end]):
        return []
    place = (tokens[opening].end, tokens[end].begin)
    return [(*place, after, "condition") for after in (f"!({inside})", f"({inside}) && false", f"({inside}) || true")]


def dropped_call(tokens, i):
    """A statement that is only a call."""
    if tokens[i].kind != "word" or tokens[i].text in ("return", "if", "for", "while", "switch", "else", "using", "catch"):
        return []
    if tokens[i - 1].text not in (";", "{", "}", ")", "else"):
        return []
    end = i
    while tokens[end].kind == "word" and tokens[end + 1].text in ("::", ".", "->"):
        end += 2
    if tokens[end].kind != "word" or tokens[end + 1].text != "(":
        return []
    end = closing(tokens, end + 1)
    if end + 1 >= len(tokens) or tokens[end + 1].text != ";":
        return []
    return [(tokens[i].begin, tokens[end].end, "", "call")]


def mutants_of(root, file):
    """Every mutant of a file, in order, as lists of those at one place."""
    text = (root / file).read_text()
    tokens = tokens_of(text)
    alone = left_alone(tokens)
    places = []
    for i in range(1, len(tokens) - 1):
        if i in alone:
            continue
        line = text.count("\n", 0, tokens[i].begin) + 1
        column = tokens[i].begin - text.rfind("\n", 0, tokens[i].begin)
        here = [
            Mutant(str(file), line, column, begin, end, text[begin:end], after, kind)
            for begin, end, after, kind in edits_at(text, tokens, i)
        ]
        if here:
            places.append(here)
    return places


def in_random_order(root, files, seed):
    """One mutant for every place in the files. The seed and the line determine which, and its order, so that changes of
    other lines do not change the choice."""
    chosen = []
    for file in files:
        lines = (root / file).read_text().splitlines()
        for place in mutants_of(root, file):
            rng = random.Random(f"{seed} {file} {place[0].column} {lines[place[0].line - 1]}")
            chosen.append((rng.random(), rng.choice(place)))
    return [mutant for _, mutant in sorted(chosen, key=lambda pair: pair[0])]


def files_of(root, room):
    return [path.relative_to(root) for path in sorted(Path(root, room).iterdir()) if path.suffix in (".cpp", ".h")]


def dependants(root):
    """The number of .cpp files that include each file, directly or indirectly."""
    sources = [path for folder in ("hw", "host", "sim", "tests") for path in sorted((root / folder).rglob("*"))
               if path.suffix in (".cpp", ".h")]
    included = {str(path.relative_to(root)): INCLUDE.findall(path.read_text()) for path in sources}
    counts = dict.fromkeys(included, 0)
    for source in included:
        if source.endswith(".cpp"):
            for file in reached(source, included):
                counts[file] += 1
    return counts


def reached(source, included):
    found = set()
    waiting = [source]
    while waiting:
        for file in included[waiting.pop()]:
            if file in included and file not in found:
                found.add(file)
                waiting.append(file)
    return found
