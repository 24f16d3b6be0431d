"""Numbers as text."""


def decimal(number: float) -> str:
    """Give a length in points to a millionth, without an exponent and without idle zeros."""
    text = f"{number:.6f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text
