"""How exported films move: how long, whether back again, how many pictures, how true to their paths."""

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QCheckBox, QSpinBox, QWidget

from app.export import Layout
from app.playback import Repeat
from app.view.timeline.player import Player
from app.view.wording.decimal_field import DecimalField
from starskel.export import bounds
from starskel.export.settings import Settings

_USUAL = Settings("animation")


class MotionFields(QObject):
    """Asks for it; begins with what the player does."""

    def __init__(self, player: Player, parent: QWidget) -> None:
        super().__init__(parent)
        self._seconds = DecimalField()
        self._seconds.setRange(bounds.DURATION.least, bounds.DURATION.most)
        self._seconds.setSuffix(self.tr(" s"))
        self._seconds.setValue(player.duration)
        self._returning = QCheckBox(self.tr("Back and forth"))
        self._returning.setChecked(player.repeat == Repeat.PING_PONG)
        self._returning.setAccessibleName(self._returning.text())
        self._rate = QSpinBox()
        self._rate.setRange(1, int(bounds.RATE.most))
        self._rate.setValue(round(_USUAL.rate))
        self._rate.setToolTip(self.tr("Of formats that are made of pictures"))
        self._tolerance = DecimalField()
        self._tolerance.setRange(0.01, 10)
        self._tolerance.setSingleStep(0.05)
        self._tolerance.setSuffix(self.tr(" %"))
        self._tolerance.setValue(100 * _USUAL.tolerance)
        self._tolerance.setToolTip(
            self.tr("How far vertices may stray between keys of SVG and Lottie, of the box of all frames")
        )

    @property
    def rows(self) -> tuple[tuple[str, QWidget], ...]:
        """The fields and their labels, to be put into a form."""
        return (
            (self.tr("&Duration"), self._seconds),
            ("", self._returning),
            (self.tr("Pictures a &second"), self._rate),
            (self.tr("T&olerance"), self._tolerance),
        )

    @property
    def seconds(self) -> float:
        """How long it takes one way."""
        return self._seconds.value()

    @property
    def returning(self) -> bool:
        """Whether it comes back again."""
        return self._returning.isChecked()

    @property
    def rate(self) -> float:
        """Pictures a second."""
        return self._rate.value()

    @property
    def tolerance(self) -> float:
        """How far a vertex may stray, as a part of the box of all frames."""
        return self._tolerance.value() / 100

    def begin_with(self, rate: float, tolerance: float) -> None:
        """Show what was chosen before; how long it takes is as it is played now."""
        self._rate.setValue(round(rate))
        self._tolerance.setValue(100 * tolerance)

    def offer(self, layout: Layout) -> None:
        """Offer what matters for a layout."""
        for field in (self._seconds, self._returning, self._rate):
            field.setEnabled(layout in ("animation", "morph"))
        self._tolerance.setEnabled(layout == "animation")
