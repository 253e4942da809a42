"""Exact decimal text of numbers on any scale, which reads back to the same number."""

from __future__ import annotations

from decimal import Context, Decimal

_EXACT = Context(prec=40)
_LONGEST = 60
"""Characters; a longer text is no number that a program wrote, and counts as the number that it is near."""


def scale_text(value: float, up: int, down: int = 1) -> str:
    """Return ``value * up / down``; :func:`unscale_text` of it is ``value``, to the last bit.

    The text has as many digits as that takes, most often no more than the number itself.

    >>> scale_text(0.07, 100), unscale_text("7.0", 100)
    ('7.000000000000001', 0.07)
    """
    product = _EXACT.divide(_EXACT.multiply(Decimal(value), Decimal(up)), Decimal(down))
    short = repr(float(product))
    return short if unscale_text(short, up, down) == value else f"{product:.25g}"


def unscale_text(text: str, up: int, down: int = 1) -> float:
    """Return the number of which a text is ``up / down`` times as much; the text must be a finite number."""
    if len(text) <= _LONGEST:
        try:
            return float(_EXACT.divide(_EXACT.multiply(Decimal(text), Decimal(down)), Decimal(up)))
        except ArithmeticError:
            pass  # an exponent of twenty digits: the number itself is 0
    return float(text) / up * down
