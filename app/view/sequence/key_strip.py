"""The strip of key shapes: which there are, which two are on the canvases, where the playhead is."""

from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal, Slot
from PySide6.QtGui import QColor, QContextMenuEvent, QHelpEvent, QKeyEvent, QMouseEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QApplication, QMenu, QSizePolicy, QToolTip, QWidget

from app.model.selection import Selection
from app.model.sequence import Sequence
from app.session import Session
from app.view.commands.actions import Actions
from app.view.commands.sequence import SEQUENCE
from app.view.painting.drawing import painting
from app.view.painting.theme import theme_of
from app.view.sequence.sequencing import Sequencing
from app.view.sequence.strip_layout import StripLayout
from app.view.sequence.strip_painter import StripPainter
from app.view.timeline.player import Player
from app.view.wording import words
from app.view.wording.counts import COUNTS
from starskel.files.projects.project import letter


class KeyStrip(QWidget):
    """A click on a shape or between two shows them; a drag moves a shape to another place."""

    shown = Signal(QRectF)
    """The place of what is on the canvases now, for who scrolls."""

    def __init__(self, session: Session, player: Player, sequencing: Sequencing, actions: Actions) -> None:
        super().__init__()
        self._session = session
        self._player = player
        self._sequencing = sequencing
        self._actions = actions
        self._pressed: QPointF | None = None
        self._held: int | None = None
        self.slot: int | None = None
        self._step = 0
        self.setObjectName("key-strip")
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self.setSizePolicy(QSizePolicy.Policy.MinimumExpanding, QSizePolicy.Policy.Fixed)
        session.document_changed.connect(self._follow)
        session.changed.connect(self.update)
        player.t_changed.connect(self._follow_player)
        self._follow()

    @property
    def places(self) -> StripLayout:
        """Where everything lies."""
        return StripLayout(len(self._sequence.shapes))

    @property
    def _sequence(self) -> Sequence:
        return self._session.document.sequence

    def sizeHint(self) -> QSize:
        return self.places.size

    def minimumSizeHint(self) -> QSize:
        return self.places.size

    @Slot()
    def _follow(self) -> None:
        document = self._session.document
        name = self.tr("Key shapes, {step} on the canvases").format(step=words.step_letters(document.step))
        self.setAccessibleName(name)
        self.setMinimumSize(self.places.size)
        self.update()
        if document.step != self._step:
            self._step = document.step
            self.shown.emit(self.places.tile(document.step).united(self.places.tile(document.step + 1)))

    @Slot()
    def _follow_player(self) -> None:
        """Paint the playhead anew, which moves within the step that is shown."""
        self.update(self.places.step(self._session.document.step).toAlignedRect())

    # pointer

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self._pressed = event.position()
            self._held = self.places.tile_at(event.position())

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._pressed is None or self._held is None:
            self._point_out(event.position())
            return
        way = (event.position() - self._pressed).manhattanLength()
        if self.slot is not None or way >= QApplication.startDragDistance():
            self.slot = self.places.slot_at(event.position().x())
            self.setCursor(Qt.CursorShape.ClosedHandCursor)
            self.update()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        pressed, held, slot = self._pressed, self._held, self.slot
        self._let_go()
        if pressed is None:
            return
        if held is not None and slot is not None:
            self._drop(held, slot)
        elif held is not None:
            self.show_shape(held)
        elif (step := self.places.step_at(event.position())) is not None:
            self._session.show_step(step)
        elif self.places.addition.contains(event.position()):
            self._sequencing.add(len(self._sequence.shapes) - 1)

    def show_shape(self, shape: int) -> None:
        """Have a shape on one of the canvases, moving as little as possible, and work on it."""
        step = self._session.document.step
        if shape not in (step, step + 1):
            self._session.show_step(shape if shape < step else shape - 1)
        self._session.choose(Selection("source" if shape == self._session.document.step else "target"))

    def _drop(self, shape: int, slot: int) -> None:
        to = slot if slot <= shape else slot - 1
        if to != shape:
            self._sequencing.move(shape, to)

    def _let_go(self) -> None:
        self._pressed = self._held = self.slot = None
        self.unsetCursor()
        self.update()

    def _point_out(self, place: QPointF) -> None:
        on_something = self.places.step_at(place) is not None or self.places.addition.contains(place)
        if self.places.tile_at(place) is not None:
            self.setCursor(Qt.CursorShape.OpenHandCursor)
        elif on_something:
            self.setCursor(Qt.CursorShape.PointingHandCursor)
        else:
            self.unsetCursor()

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        place = QPointF(event.pos())
        shape = self.places.tile_at(place)
        if event.reason() == QContextMenuEvent.Reason.Mouse and shape is None:
            return
        if shape is not None:
            self.show_shape(shape)
        menu = QMenu(self)
        menu.addActions([self._actions[command.name] for command in SEQUENCE if command.name != "alone"])
        menu.exec(event.globalPos())
        menu.deleteLater()

    # keys

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.ShortcutOverride and isinstance(event, QKeyEvent):
            if event.key() in (Qt.Key.Key_Delete, Qt.Key.Key_Escape):
                event.accept()  # here they are about shapes, in the rest of the window about vertices
        elif event.type() == QEvent.Type.ToolTip and isinstance(event, QHelpEvent):
            QToolTip.showText(event.globalPos(), self._tip(QPointF(event.pos())), self)
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        moving = bool(event.modifiers() & Qt.KeyboardModifier.ControlModifier)
        names = {
            Qt.Key.Key_Left: "shape-earlier" if moving else "step-before",
            Qt.Key.Key_Right: "shape-later" if moving else "step-after",
            Qt.Key.Key_Delete: "shape-delete",
        }
        if event.key() == Qt.Key.Key_Escape:
            self._let_go()
        elif (name := names.get(Qt.Key(event.key()))) is not None:
            self._actions[name].trigger()
        else:
            super().keyPressEvent(event)

    def _tip(self, place: QPointF) -> str:
        sequence, shape, step = self._sequence, self.places.tile_at(place), self.places.step_at(place)
        if shape is not None:
            count = sum(map(len, sequence.shapes[shape].rings))
            size = COUNTS.vertices(count) if count else self.tr("empty")
            text = self.tr("Shape {letter}, {size}. Drag it to move it to another place.")
            return text.format(letter=letter(shape), size=size)
        if step is not None:
            text = self.tr("{letters}, {marks}. Click to show them on the canvases.")
            marks = COUNTS.marks(sum(len(link.marks) for link in sequence.steps[step].links))
            return text.format(letters=words.step_letters(step), marks=marks)
        return self.tr("Add a shape") if self.places.addition.contains(place) else ""

    # painting

    def paintEvent(self, event: QPaintEvent) -> None:
        with painting(self) as painter:
            self._paint(painter, QRectF(event.rect()))

    def _paint(self, painter: QPainter, part: QRectF) -> None:
        theme, document = theme_of(self.palette()), self._session.document
        working = document.shape_on(self._session.selection.side)
        strip = StripPainter(painter, theme, self.places, document)
        strip.paint(part, working, self._player.t)
        if self._held is not None and self.slot is not None:
            strip.paint_slot(self._held, self.slot)
        if self.hasFocus():
            painter.setPen(QColor(theme.accent))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRect(self.rect().adjusted(0, 0, -1, -1))
