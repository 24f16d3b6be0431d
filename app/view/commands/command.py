"""A row of the table of commands."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Command:
    """A row of the table.

    Attributes
    ----------
    name : str
        What the code calls it.
    text : str
        What the menu calls it.
    tip : str
        One line about what it does.
    keys : tuple of str
        Shortcuts in portable form.
    group : str
        Commands of one group exclude each other: one of them is checked.
    checkable : bool
        Whether it is a switch.
    """

    name: str
    text: object
    tip: object
    keys: tuple[str, ...] = ()
    group: str = ""
    checkable: bool = False
