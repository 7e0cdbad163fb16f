# SPDX-License-Identifier: Apache-2.0
"""What may be chosen of printable parts. Millimetres, as printers have them."""

from dataclasses import dataclass

_BED, _HIGH, _MARGIN = (0.22, 0.22), 250.0, 0.004  # [m], [mm], [m]


@dataclass(frozen=True)
class PartOptions:
    """Choices, with their defaults."""

    fit: float = 0.15
    """Play between a part and the modules that it holds [mm]."""
    wall: float = 1.2
    """Least thickness, and least material around a hole [mm]."""
    gap: float = 0.5
    """Least distance between what moves past each other [mm]."""
    bed: tuple[float, float, float] | None = None
    """Of the printer [mm]; None: that of [print] in the robot's assembly, else 220 x 220, and 250
    high."""
    strength: float = 25.0
    """That the printed material bears, across its layers [MPa]."""
    safety: float = 2.0
    """Least safety factor under the loads of the gait."""

    press: float = 0.1
    """By how much a foot's socket is narrower than its peg, across [mm]; negative is play."""
    step: bool = False
    """Whether parts are written as STEP, too."""
    margin: float | None = None
    """What parts leave free at each side of the bed, for a skirt, a brim or clips [mm]; None: that
    of [print] in the robot's assembly, else 4."""

    def bed_for(self, own: tuple[float, float] | None) -> tuple[float, float, float]:
        """The bed [mm]. @param own the robot's [m]"""
        if self.bed is not None:
            return self.bed
        wide, deep = own or _BED
        return 1e3 * wide, 1e3 * deep, _HIGH

    def margin_for(self, own: float | None) -> float:
        """What is left free at each side of the bed [mm]. @param own the robot's [m]"""
        return self.margin if self.margin is not None else 1e3 * (_MARGIN if own is None else own)

    def faults(self) -> list[str]:
        """What is wrong with them."""
        out = []
        for name, least in (('fit', 0.0), ('wall', 0.1), ('gap', 0.0), ('strength', 0.1)):
            value = getattr(self, name)
            if not least <= value <= 1000.0:
                out.append(f'{name} is {value:g}; expected {least:g} to 1000')
        if not -1.0 <= self.press <= 1.0:
            out.append(f'press is {self.press:g}; expected -1 to 1')
        if self.bed is None:
            pass
        elif len(self.bed) != 3 or not all(1 <= side <= 10000 for side in self.bed):
            out.append(f'bed is {self.bed}; expected three sizes in mm from 1 to 10000')
        if self.margin is not None and not 0 <= self.margin <= 1000:
            out.append(f'margin is {self.margin:g}; expected 0 to 1000')
        if not 0 < self.safety <= 100:
            out.append(f'safety is {self.safety:g}; expected more than 0, at most 100')
        return out
