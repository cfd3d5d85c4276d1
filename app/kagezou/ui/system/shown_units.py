"""In which units people read and type numbers: shares as per cent, speeds by the frame."""

from collections.abc import Iterable
from dataclasses import dataclass

from PySide6.QtCore import QCoreApplication

from kagezou.document.property import AnyProperty, Kind


@dataclass(frozen=True, slots=True)
class ShownUnit:
    """How a number is shown: times a factor, with a unit behind it."""

    factor: float
    unit: str

    def behind(self) -> str:
        """Return the unit as it is written behind a number: with a gap, but for degrees."""
        return self.unit if self.unit in ("", "°") else f" {self.unit}"


def shown_unit(prop: AnyProperty) -> ShownUnit:
    """Return how the numbers of a property are shown; scripts and files keep the property's own unit."""
    is_share = prop.kind is Kind.NUMBER and not prop.unit and (prop.low, prop.high) == (0.0, 1.0)
    if is_share:
        return ShownUnit(100.0, "%")
    if prop.name.endswith(".velocity"):
        return ShownUnit(1.0, QCoreApplication.translate("Units", "px/frame"))
    return ShownUnit(1.0, prop.unit)


def common_factor(props: Iterable[AnyProperty]) -> float:
    """Return by what numbers of several properties on one scale are shown; 1 where they differ."""
    factors = {shown_unit(prop).factor for prop in props}
    return factors.pop() if len(factors) == 1 else 1.0
