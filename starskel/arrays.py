"""Arrays: what their types are called, and how what is handed out stays what it was proven to be."""

from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]
Indices = NDArray[np.intp]
Signs = NDArray[np.int8]
Flags = NDArray[np.bool_]

Number = TypeVar("Number", bound=np.generic)


def read_only(array: NDArray[Number]) -> NDArray[Number]:
    """Give an array after making it read-only."""
    array.flags.writeable = False
    return array


class ReadOnlyArrays:
    """A base for frozen dataclasses: the arrays in their fields cannot be written to."""

    def __post_init__(self) -> None:
        fields: dict[str, Any] = vars(self)
        for value in fields.values():
            if isinstance(value, np.ndarray):
                read_only(value)
