"""What can go wrong, as exceptions that state what, where and the remedy."""

from __future__ import annotations


class Error(Exception):
    """Any error of this package."""


class LcmFileError(Error):
    """An .lcm file that declares no types; the text begins with file:line:column."""


class DecodeError(Error):
    """Bytes that are not a message of their type."""


class LogError(Error):
    """A log, or a part of one, that cannot be read.

    Attributes:
        path: The log.
        offset: The byte of the file at which the trouble begins.
        what: What is wrong there.
    """

    def __init__(self, path: str, offset: int, what: str) -> None:
        super().__init__(f"{path}: byte {offset}: {what}")
        self.path = path
        self.offset = offset
        self.what = what

    def __reduce__(self) -> tuple[type[LogError], tuple[str, int, str]]:
        return (LogError, (self.path, self.offset, self.what))


class LogWarning(UserWarning):
    """A log of which a part could not be read, and was left out."""


class ResultsError(Error):
    """Results of a campaign that cannot be read; the text begins with the file."""


class BusError(Error):
    """A bus that cannot be opened or used, with what to try."""


class StepError(Error):
    """A participant that cannot take part in its mission."""


class SimulationError(Error):
    """A mission that cannot be opened, or cannot go on; one line for each error of its file."""
