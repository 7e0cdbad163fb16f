# SPDX-License-Identifier: Apache-2.0
"""Numbers as strokes of seven segments, of which pictures and engravings draw them."""

from dataclasses import dataclass

_SEGMENTS = {
    '0': 'abcdef', '1': 'bc', '2': 'abged', '3': 'abgcd', '4': 'fgbc', '5': 'afgcd',
    '6': 'afgedc', '7': 'abc', '8': 'abcdefg', '9': 'abcdfg',
}  # fmt: skip
_ENDS = {
    'a': ((0, 2), (1, 2)), 'b': ((1, 2), (1, 1)), 'c': ((1, 1), (1, 0)), 'd': ((0, 0), (1, 0)),
    'e': ((0, 1), (0, 0)), 'f': ((0, 2), (0, 1)), 'g': ((0, 1), (1, 1)),
}  # fmt: skip
_HALF_TURNED = {'0': '0', '1': '1', '2': '2', '5': '5', '6': '9', '8': '8', '9': '6'}


@dataclass(frozen=True)
class Stroke:
    """From one point to another; x to the right, y up."""

    start: tuple[float, float]
    end: tuple[float, float]


def strokes(number: int, height: float, gap: float) -> list[Stroke]:
    """The middle lines of a number's strokes, from (0, 0) at the lower left.

    Digits are half as wide as high, with that gap between them.
    """
    half, out, left = height / 2, [], 0.0
    for digit in str(number):
        for segment in _SEGMENTS[digit]:
            (a, b), (c, d) = _ENDS[segment]
            out.append(Stroke((left + half * a, half * b), (left + half * c, half * d)))
        left += half + gap
    return out


def width(number: int, height: float, gap: float) -> float:
    """Of the middle lines."""
    count = len(str(number))
    return count * height / 2 + (count - 1) * gap


def needs_bar(number: int) -> bool:
    """Whether it reads as another number when it is turned by half: 6 and 9, 12 and 21."""
    digits = str(number)
    if any(digit not in _HALF_TURNED for digit in digits):
        return False
    return ''.join(_HALF_TURNED[digit] for digit in reversed(digits)) != digits
