"""Names that files hold, made names that a file may have: of a stranger's file they may be anything."""

import re
from collections.abc import Sequence

_LONGEST = 100
"""Letters of a name: with an ending and a number they fit into the 255 bytes of most file systems."""

_UNFIT = re.compile(r"[^\w. ()+,'&~-]")
_RESERVED = re.compile(r"(?i)(con|prn|aux|nul|com\d|lpt\d)(\.|$)")
_BYTES = 200


def file_name_of(name: str) -> str:
    """Give a name as one that a file may have in a folder, on any system; it is never empty.

    Separators of folders, control characters and the like become underscores; leading and trailing dots and
    blanks are left out, names of devices get an underscore in front, long names are cut off.

    Examples
    --------
    >>> from starskel.files.file_name import file_name_of
    >>> file_name_of("Arm, bent"), file_name_of("../../.profile"), file_name_of("NUL.txt"), file_name_of("..")
    ('Arm, bent', '_.._.profile', '_NUL.txt', '_')
    """
    plain = _UNFIT.sub("_", name[:_LONGEST]).encode()[:_BYTES].decode(errors="ignore").strip(". ")
    return f"_{plain}" if not plain or _RESERVED.match(plain) else plain


def file_names_of(names: Sequence[str]) -> list[str]:
    """Give names as ones that files may have, each another, even where capitals do not count."""
    found: list[str] = []
    taken: set[str] = set()
    for name in map(file_name_of, names):
        number, own = 1, name
        while own.casefold() in taken:
            number += 1
            own = f"{name}-{number}"
        taken.add(own.casefold())
        found.append(own)
    return found
