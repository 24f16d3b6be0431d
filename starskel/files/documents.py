"""JSON documents: checked while they are read, written so that two of them can be compared line by line."""

from collections.abc import Sequence
from pathlib import Path
from typing import TypeVar

import msgspec

from starskel.errors import InvalidFile, either, told
from starskel.files.disk import read_bytes, write_bytes
from starskel.limits import DOCUMENT_VALUES, check_limit

Document = TypeVar("Document")

_BYTE_ORDER_MARK = b"\xef\xbb\xbf"


class _Header(msgspec.Struct):
    format: str = ""


def format_of(path: Path) -> str:
    """Give what the document says its format is, "" where it says nothing.

    Raises
    ------
    InvalidFile
        If the file cannot be read or is no JSON object.
    """
    return read_document(path, _Header).format


def check_format(path: Path, *expected: str) -> str:
    """Give the format of a document that must have one of these.

    Raises
    ------
    InvalidFile
        If it is none of those expected, naming them; or if the file cannot be read or is no JSON object.
    """
    found = format_of(path)
    if found not in expected:
        what = (
            told('{path} has the format "{found}"', path=path, found=found)
            if found
            else told("{path} does not name its format", path=path)
        )
        mend = told("give a file of the format {names}", names=either([f'"{name}"' for name in expected]))
        if found.partition("/")[0] in {name.partition("/")[0] for name in expected}:
            mend = told("{mend}, or open it with a newer starskel", mend=mend)
        raise InvalidFile(what, mend)
    return found


def read_document(path: Path, kind: type[Document]) -> Document:
    """Give a JSON file as a value of this type.

    Raises
    ------
    InvalidFile
        If the file cannot be read or is too large, is no JSON, or holds other things than the type says,
        naming the place.
    """
    content = read_bytes(path).removeprefix(_BYTE_ORDER_MARK)
    values = sum(content.count(sign) for sign in (b",", b"[", b"{"))
    check_limit(str(path), told("values"), values, DOCUMENT_VALUES)
    try:
        return msgspec.json.decode(content, type=kind)
    except msgspec.ValidationError as error:
        raise InvalidFile(
            told("{where}: {what}", where=path, what=error), told("correct the file at this place")
        ) from error
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError) as error:
        raise InvalidFile(
            told("{path} is damaged: {error}", path=path, error=error), told("take an undamaged copy")
        ) from error


def write_document(path: Path, document: object) -> None:
    """Write a value as JSON, whole or not at all; rows of numbers stand on one line each.

    Raises
    ------
    InvalidFile
        If it cannot be written.
    """
    write_bytes(path, document_text(document).encode())


def document_text(document: object) -> str:
    """Give a value as JSON; rows of numbers stand on one line each."""
    return _lines(msgspec.to_builtins(document), "") + "\n"


def _lines(value: object, indent: str) -> str:
    deeper = indent + "  "
    if isinstance(value, dict) and value:
        entries = [f"{_inline(key)}: {_lines(entry, deeper)}" for key, entry in value.items()]
        return _block("{", entries, "}", indent)
    if isinstance(value, list | tuple) and (rows := _rows(value)) is not None:
        return _block("[", rows, "]", indent)
    if isinstance(value, list | tuple) and any(isinstance(entry, list | tuple | dict) for entry in value):
        return _block("[", [_lines(entry, deeper) for entry in value], "]", indent)
    return _inline(value)


def _rows(value: Sequence[object]) -> list[str] | None:
    """Give the lines of a list of rows of numbers, the bulk of large documents, all at once; else None."""
    first = value[0] if value else None
    if not isinstance(first, list | tuple) or not first or isinstance(first[0], list | tuple | dict | str):
        return None
    content = msgspec.json.encode(value)
    if b'"' in content or b"{" in content or content.count(b"[") != len(value) + 1:
        return None
    rows = content[2:-2].replace(b",", b", ").decode().split("], [")
    return [f"[{row}]" for row in rows] if len(rows) == len(value) else None


def _block(opening: str, entries: list[str], closing: str, indent: str) -> str:
    return opening + ",".join(f"\n{indent}  {entry}" for entry in entries) + f"\n{indent}{closing}"


def _inline(value: object) -> str:
    if isinstance(value, list | tuple):
        return f"[{', '.join(map(_inline, value))}]"
    return msgspec.json.encode(value).decode()
