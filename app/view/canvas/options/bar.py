"""The options bar: what can be set for the tool in hand, and what the pointer snaps to."""

from dataclasses import replace

from PySide6.QtCore import QSize, Qt, Signal, Slot
from PySide6.QtWidgets import QSizePolicy, QStackedWidget, QToolBar

from app.session import Session
from app.view.canvas.options.pages import NumberField, Page, TextPage, TolerancePage
from app.view.canvas.options.picture_page import PicturePage
from app.view.canvas.options.placement_page import SelectionPage
from app.view.commands.actions import Actions
from app.view.wording.decimal_field import DecimalField
from app.view.wording.plain import Label

SWITCHES = {
    "snap-vertices": "vertices",
    "snap-edges": "edges",
    "snap-angles": "angles",
    "snap-grid": "grid",
}
"""The command that switches each part of snapping."""


class OptionsBar(QToolBar):
    """Shows the tool's name and a page of its options at the left, snapping at the right."""

    left = Signal()
    """A number was entered: the keys belong to the canvas again."""

    def __init__(self, session: Session, actions: Actions) -> None:
        super().__init__()
        self._session = session
        self._actions = actions
        self.setWindowTitle(self.tr("Options"))
        self.setObjectName("options")
        self.setMovable(False)
        self.setIconSize(QSize(20, 20))
        self.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonIconOnly)
        self.name = Label()
        font = self.name.font()
        font.setBold(True)
        self.name.setFont(font)
        self.name.setContentsMargins(8, 0, 12, 0)
        self.pages = self._make_pages()
        self._stack = QStackedWidget()
        self._stack.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        for page in self.pages.values():
            self._stack.addWidget(page)
            page.left.connect(self.left)
        self._spacing = DecimalField()
        self._arrange()
        session.tool_changed.connect(self._follow_tool)
        session.settings_changed.connect(self._follow_settings)
        self._follow_tool()
        self._follow_settings()

    def switch(self) -> None:
        """Follow the switches for snapping."""
        switches = {part: self._actions[name].isChecked() for name, part in SWITCHES.items()}
        self._set_snapping(**switches)

    def _make_pages(self) -> dict[str, Page]:
        session = self._session
        return {
            "": Page(session),
            "select": SelectionPage(session),
            "freehand": TolerancePage(session),
            "simplify": TolerancePage(session),
            "refine": Page(session, NumberField(self.tr("Vertices to add"), "added", 1, 500)),
            "ellipse": Page(session, NumberField(self.tr("Vertices"), "roundness", 6, 360)),
            "regular-polygon": Page(session, NumberField(self.tr("Corners"), "corners", 3, 100)),
            "star": Page(
                session,
                NumberField(self.tr("Points"), "points", 3, 100),
                NumberField(self.tr("Inner radius"), "inner", 5, 95, " %", 0.01),
            ),
            "text": TextPage(session),
            "picture": PicturePage(session, self._actions),
        }

    def _arrange(self) -> None:
        self.addWidget(self.name)
        self.addWidget(self._stack)
        snap = Label(self.tr("Snap to"))
        snap.setContentsMargins(8, 0, 6, 0)
        self.addWidget(snap)
        for name in SWITCHES:
            self.addAction(self._actions[name])
        self._spacing.setObjectName("spacing")
        self._spacing.setAccessibleName(self.tr("Spacing of the grid"))
        self._spacing.setToolTip(self.tr("Spacing of the grid"))
        self._spacing.setRange(0.01, 10_000)
        self._spacing.setFixedWidth(76)
        self._spacing.valueChanged.connect(self._space)
        self.addWidget(self._spacing)

    @Slot(float)
    def _space(self, spacing: float) -> None:
        self._set_snapping(spacing=spacing)

    def _set_snapping(self, **values: bool | float) -> None:
        settings = self._session.settings
        self._session.set(replace(settings, snapping=replace(settings.snapping, **values)))  # type: ignore[arg-type] # each value is of its own field

    @Slot()
    def _follow_tool(self) -> None:
        tool = self._session.tool
        name = tool.options or tool.name
        self._stack.setCurrentWidget(self.pages.get(name, self.pages[""]))
        said = self._actions[name if name in self._actions else tool.name]
        self.name.setText(said.text().replace("&", "").replace("…", ""))

    @Slot()
    def _follow_settings(self) -> None:
        snapping = self._session.settings.snapping
        for name, part in SWITCHES.items():
            self._actions[name].setChecked(getattr(snapping, part))
        self._spacing.setValue(snapping.spacing)
        self._spacing.setEnabled(snapping.grid)
        for page in self.pages.values():
            page.follow()
