"""Exceptions and warnings of csgsim."""

import re

_PLACE = re.compile(r"(?P<file>.+?):(?P<line>\d+):(?P<column>\d+): ")


class Error(Exception):
    """A model, machine, Program or option that cannot be used. The text is one line, `file:line:column: what is wrong;
    what to do` if there is a place.

    >>> try:
    ...     csgsim.render(text="cube(10;")
    ... except csgsim.Error as error:
    ...     print(error.line, error.column)
    """

    def _place(self, part):
        place = _PLACE.match(str(self))
        return place[part] if place else None

    @property
    def file(self):
        """The file's name, or None if the message has no place."""
        return self._place("file")

    @property
    def line(self):
        """Line number, from 1, or None if the message has no place."""
        line = self._place("line")
        return None if line is None else int(line)

    @property
    def column(self):
        """Column number, from 1, or None if the message has no place."""
        column = self._place("column")
        return None if column is None else int(column)


class UsageError(Error):
    """An unknown option, with the nearest known one, or an invalid value or combination.

    >>> csgsim.render("part.csg", z_bitz=16)
    csgsim.UsageError: there is no option --z-bitz; did you mean --z-bits? see csgsim render --help
    """


class CsgsimWarning(UserWarning):
    """A warning that the command line would print on standard error.

    >>> warnings.simplefilter("error", csgsim.CsgsimWarning)
    """


Error.__module__ = UsageError.__module__ = CsgsimWarning.__module__ = "csgsim"
