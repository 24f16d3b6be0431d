"""A method's panel: its name, its verdict, its frame at t."""

from PySide6.QtCore import QEvent
from PySide6.QtGui import QColor, QPalette
from PySide6.QtWidgets import QHBoxLayout, QVBoxLayout, QWidget

from app.compute import STEERED, MethodState
from app.session import Session
from app.view.painting.display import Display
from app.view.painting.theme import theme_of
from app.view.panels.frame_view import FrameView
from app.view.panels.steering import Steering
from app.view.timeline.player import Player
from app.view.wording import plain, verdicts, words
from app.view.wording.counts import COUNTS
from app.view.wording.fitting_label import FittingLabel
from app.view.wording.plain import Label
from starskel.arrays import Floats
from starskel.sheet.words import kind_of

HEADING = 20
"""Height of the line with the method's name, in pixels."""


class Panel(QWidget):
    """One of the methods side by side."""

    def __init__(self, method: str, session: Session, player: Player, display: Display) -> None:
        super().__init__()
        self.method = method
        self._session = session
        self.setObjectName(f"{method}-panel")
        self.setAccessibleName(words.method(method))
        self._name = Label(words.method(method))
        font = self._name.font()
        font.setBold(True)
        self._name.setFont(font)
        self._name.setToolTip(words.method_tip(method))
        self.verdict = FittingLabel()  # whole in its tip
        self.verdict.setObjectName(f"{method}-verdict")
        self.verdict.setAccessibleName(self.tr("Verdict on {method}").format(method=words.method(method)))
        self.view = FrameView(session, player, display)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(2)
        layout.addLayout(self._heading())
        layout.addWidget(self.verdict)
        layout.addWidget(self.view, 1)

    def _heading(self) -> QHBoxLayout:
        row = QHBoxLayout()
        row.setContentsMargins(0, 0, 0, 0)
        self._name.setFixedHeight(HEADING)  # so that frames stand in line whatever else there is in a heading
        row.addWidget(self._name, 1)
        if self.method == STEERED:
            row.addWidget(Steering(self._session))
        return row

    def follow(self, extent: Floats) -> None:
        """Show what the session has of this method, in the view that all panels share."""
        state = self._session.blends.results.get(self.method, MethodState())
        self._show_verdict(state)
        self.view.show_blend(state, extent, self._message(state))

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self._show_verdict(self._session.blends.results.get(self.method, MethodState()))

    def _show_verdict(self, state: MethodState) -> None:
        texts, colour = self._verdict(state)
        self.verdict.say(texts)
        self.verdict.setToolTip(plain.tip(self._tip(state)))
        palette = QPalette(self.palette())
        palette.setColor(QPalette.ColorRole.WindowText, QColor(colour))
        self.verdict.setPalette(palette)

    def _verdict(self, state: MethodState) -> tuple[list[str], str]:
        """Give the verdict in many words and in few, and its colour; a glyph says the same as the colour."""
        theme = theme_of(self.palette())
        if state.error is not None:
            return ["✕ " + self.tr("no blend")], theme.refused
        if state.result is None:
            return [self.tr("computing…") if self._session.blends.busy else ""], theme.muted
        report = state.result.report
        texts = verdicts.summaries(report)
        if state.stale:
            outdated = self.tr("{verdict} (out of date)")
            return ["… " + outdated.format(verdict=text) for text in texts], theme.muted
        glyph = {"simple": "✓ ", "natural": "≈ ", "harmful": "✕ "}[kind_of(report)]
        return [glyph + text for text in texts], theme.simple if report.simple else theme.refused

    def _tip(self, state: MethodState) -> str:
        if state.error is not None:
            return words.reason(state.error, self._session.document)
        return verdicts.details(state.result.report) if state.result is not None else ""

    def _message(self, state: MethodState) -> str:
        if state.error is not None:
            return words.reason(state.error, self._session.document)
        document = self._session.document
        if state.result is None and (held := self._session.blends.held):
            return COUNTS.held(held)
        if state.result is not None or self._session.blends.busy:
            return ""
        if document.source is None or document.target is None:
            return self.tr("The in-between shapes appear here as soon as there are a source and a target.")
        return self.tr("Cancelled. F5 computes it again.")
