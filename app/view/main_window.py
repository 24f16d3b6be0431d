"""The main window: canvases above, methods side by side, timeline and status below."""

from collections.abc import Callable

from PySide6.QtCore import QEvent, QSize, Qt, Slot
from PySide6.QtGui import QAction, QCloseEvent
from PySide6.QtWidgets import QApplication, QDockWidget, QMainWindow, QSplitter, QVBoxLayout, QWidget

from app.model.marks import SIDES, Side, other
from app.model.texts import QT_TRANSLATE_NOOP
from app.session import Session
from app.tools.tool import Key
from app.view.beginning import Beginning
from app.view.canvas.canvas import Canvas
from app.view.canvas.edits import Edits
from app.view.canvas.mark_line import MarkLine
from app.view.canvas.options.bar import SWITCHES, OptionsBar
from app.view.commands.actions import Actions
from app.view.commands.menus import fill_menu_bar, layers_menu, methods_menu, tool_bar, tool_palette
from app.view.commands.table import LANGUAGES, PALETTE
from app.view.files.drops import Drops
from app.view.files.files import Files
from app.view.files.importing import Importing
from app.view.files.project_menus import ExamplesMenu, RecentMenu
from app.view.files.recovering import Recovering
from app.view.files.remembered import remember_theme
from app.view.help import Help
from app.view.lists.history_list import HistoryList
from app.view.lists.marks_table import MarksPanel
from app.view.lists.partnering import Partnering
from app.view.lists.parts_list import PartsPanel
from app.view.painting.display import Display
from app.view.painting.theme import DARK, LIGHT, Theme, apply_theme, theme_of
from app.view.panels.panels import Panels
from app.view.pictures.backgrounds import Backgrounds
from app.view.sequence.sequence_bar import SequenceBar
from app.view.sequence.sequencing import Sequencing
from app.view.status import Status
from app.view.timeline.player import Player
from app.view.timeline.timeline import Timeline
from app.view.watching import LAYERS, Watching
from app.view.window_state import keep_window
from app.view.wording import language, plain, words

SIZE = QSize(1280, 860)
"""Of a window that has not been given another one."""

FRAME = QSize(16, 48)
"""So much of a screen may be taken by what the desktop puts around a window."""


class MainWindow(QMainWindow):
    """One window for one document."""

    def __init__(self, session: Session) -> None:
        super().__init__()
        self.session = session
        self.player = Player(self)
        self.display = Display(self)
        self.canvases: dict[Side, Canvas] = {side: Canvas(session, side, self.display) for side in SIDES}
        self._make_commands(session)
        self.sequence = SequenceBar(session, self.player, self.sequencing, self.actions_table)
        self.panels = Panels(session, self.player, self.display)
        self.timeline = Timeline(session, self.player, self.actions_table)
        self._make_bars(session)
        self.beginning = Beginning(self.actions_table)
        self.setCentralWidget(self._body())
        self._make_docks(session)
        self.help.begin(self.actions_table)
        self.actions_table[f"language-{language.chosen()}"].setChecked(True)
        self._take_drops()
        self.setStatusBar(self._status())
        self.resize(SIZE.boundedTo(self.screen().availableSize() - FRAME))
        self.canvases["source"].setFocus()
        session.document_changed.connect(self._follow)
        session.changed.connect(self._follow_selection)
        session.tool_changed.connect(self._follow_tool)
        self.watching.begin(self.actions_table)
        for follow in (self._follow, self._follow_selection, self._follow_tool, self._follow_theme):
            follow()

    # parts

    def _make_commands(self, session: Session) -> None:
        """Make what handles the commands, and the commands."""
        self.importing = Importing(self, session, self.canvases)
        self.files = Files(self, session, self.player, self.display, self.importing)
        self.recovering = Recovering(self, session, self.files)
        self.edits = Edits(self, session, self.canvases)
        self.sequencing = Sequencing(self, session, self.player)
        self.partnering = Partnering(self, session)
        self.backgrounds = Backgrounds(self, session, self.canvases)
        self.watching = Watching(self, session, self.player, self.display, self.canvases)
        self.help = Help(self)
        self.actions_table = Actions(self, self._handlers())

    def _make_bars(self, session: Session) -> None:
        """Make menus and toolbars."""
        self._examples, self.recent = ExamplesMenu(self), RecentMenu(self)
        self._methods = methods_menu(self)
        layers = layers_menu(self, self.actions_table, LAYERS)
        submenus = {
            "examples": self._examples,
            "recent": self.recent,
            "methods": self._methods,
            "layers": layers,
        }
        fill_menu_bar(self.menuBar(), self.actions_table, submenus)
        self.addToolBar(tool_bar(self.actions_table, submenus))
        self.addToolBarBreak()
        self.options = OptionsBar(session, self.actions_table)
        self.addToolBar(self.options)
        self.options.left.connect(self._focus_canvas)
        self.addToolBar(Qt.ToolBarArea.LeftToolBarArea, tool_palette(self.actions_table))
        self._examples.chosen.connect(self.files.open_example)
        self.recent.chosen.connect(self.files.open_recent)
        self._methods.triggered.connect(self._compare)

    def _make_docks(self, session: Session) -> None:
        """Make the lists at the side."""
        self.marks = MarksPanel(session)
        self.parts = PartsPanel(session, self.partnering, self.actions_table)
        self.history = HistoryList(session)
        self._docks = {
            "marks": self._dock(self.marks, self.tr("Marks"), "marks"),
            "parts": self._dock(self.parts, self.tr("Parts"), "parts"),
            "history": self._dock(self.history, self.tr("History"), "history"),
        }
        self.partnering.wanted.connect(self._docks["parts"].show)

    # layout

    def _body(self) -> QWidget:
        canvases = QSplitter(Qt.Orientation.Horizontal)
        canvases.setObjectName("canvases")
        for canvas in self.canvases.values():
            canvases.addWidget(canvas)
        parts = QSplitter(Qt.Orientation.Vertical)
        parts.setObjectName("parts")
        parts.addWidget(canvases)
        parts.addWidget(self.panels)
        parts.setSizes([420, 260])
        parts.setChildrenCollapsible(False)
        body = QWidget()
        layout = QVBoxLayout(body)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addWidget(self.beginning)
        layout.addWidget(self.sequence)
        layout.addWidget(parts, 1)
        self.mark_line = MarkLine(self.session, self.canvases, canvases, body)
        layout.addWidget(self.timeline)
        return body

    def _status(self) -> Status:
        status = Status(self.session, self.importing.reader, self.actions_table)
        self.files.exported.connect(status.tell_written)
        self.importing.told.connect(status.tell)
        return status

    def _take_drops(self) -> None:
        drops = Drops(self, self.session, self.files, self.importing)
        self.setAcceptDrops(True)
        for place in (self, *self.canvases.values()):
            place.installEventFilter(drops)

    def _dock(self, panel: QWidget, title: str, name: str) -> QDockWidget:
        """Give the place at the side for a table; closed until it is wanted, by its command."""
        dock = QDockWidget(title, self)
        dock.setObjectName(f"{name}-dock")
        dock.setWidget(panel)
        self.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, dock)
        dock.hide()
        dock.visibilityChanged.connect(self.actions_table[name].setChecked)
        return dock

    # commands

    def _handlers(self) -> dict[str, Callable[[], object]]:
        session, files = self.session, self.files
        return {
            "new": files.new,
            "open": files.choose,
            "import": self.importing.choose,
            "paste": self.importing.paste,
            "save": files.save,
            "save-as": files.save_as,
            "export": files.export,
            "quit": self.close,
            "undo": session.undo,
            "redo": session.redo,
            "select-all": self._select_all,
            "delete": self._delete,
            "cancel": self._cancel,
            "recover": self.recovering.offer,
            **self.edits.handlers(),
            **self.partnering.handlers(),
            **self.sequencing.handlers(),
            **self.help.handlers(),
            **self.backgrounds.handlers(),
            **dict.fromkeys(PALETTE, self._choose_tool),
            **dict.fromkeys(SWITCHES, self._switch_snapping),
            "suggest": self._suggest_marks,
            **dict.fromkeys(("marks", "parts", "history"), self._switch_dock),
            **self.watching.handlers(),
            "light": self._choose_theme,
            "dark": self._choose_theme,
            **dict.fromkeys(LANGUAGES, self._choose_language),
            "begin": self._show_how_to_begin,
        }

    @Slot()
    def _choose_tool(self) -> None:
        self.session.choose_tool(self.sender().objectName())

    @Slot()
    def _focus_canvas(self) -> None:
        self.canvases[self.session.selection.side].setFocus()

    @Slot()
    def _switch_snapping(self) -> None:
        self.options.switch()

    @Slot()
    def _select_all(self) -> None:
        """Select the shape that was worked on last, or the only one there is."""
        side = self.session.selection.side
        self.session.select_all(side if self.session.document.polygon(side) is not None else other(side))

    @Slot()
    def _delete(self) -> None:
        if not self.session.tool.busy and self.session.tool.name != "picture":
            self.session.choose_tool("select")  # what is selected can be deleted whatever the tool in hand
        self.session.key(Key("delete"))

    @Slot()
    def _cancel(self) -> None:
        """Give up the nearest thing that can be given up; a gesture is nearer than a file being read."""
        if self.importing.reader.busy and not self.session.hand.occupied:
            self.importing.reader.cancel()
        else:
            self.session.cancel()

    @Slot()
    def _suggest_marks(self) -> None:
        self.marks.suggest()

    @Slot()
    def _switch_dock(self) -> None:
        """Show a list at the side, ready for the keys, or put it away."""
        name = self.sender().objectName()
        dock = self._docks[name]
        dock.setVisible(self.actions_table[name].isChecked())
        if dock.isVisible():
            dock.widget().setFocus()

    @Slot()
    def _show_how_to_begin(self) -> None:
        self.beginning.switch(shown=self.actions_table["begin"].isChecked())

    @Slot()
    def _choose_theme(self) -> None:
        theme = DARK if self.actions_table["dark"].isChecked() else LIGHT
        remember_theme(theme.name)
        self._apply(theme)

    @Slot()
    def _choose_language(self) -> None:
        language.choose(self.sender().objectName().removeprefix("language-"))
        self.statusBar().showMessage(self.tr("The language changes with the next start."), 8000)

    @Slot(QAction)
    def _compare(self, action: QAction) -> None:
        chosen = [each.data() for each in self._methods.actions() if each.isChecked()]
        document = self.session.document.compare(tuple(chosen or [action.data()]))
        self.session.store(document, QT_TRANSLATE_NOOP("Step", "Choose methods"))

    # what the window shows of the session's state

    @Slot()
    def _follow(self) -> None:
        session, actions = self.session, self.actions_table
        self.setWindowTitle(f"{plain.title(self.files.name)}[*] - starskel")
        self.setWindowModified(session.unsaved)
        for name, label, edit in (
            ("undo", self.tr("&Undo"), session.undoes),
            ("redo", self.tr("&Redo"), session.redoes),
        ):
            actions[name].setEnabled(edit is not None)
            whole = self.tr("{command} {step}").format(command=label, step=words.step(edit or ""))
            actions[name].setText(whole if edit else label)
            actions[name].setIconText(label.replace("&", ""))
        if session.tool.busy:  # then undo takes back a part of the gesture
            actions["undo"].setEnabled(True)
            actions["redo"].setEnabled(False)
        for action in self._methods.actions():
            action.setChecked(action.data() in session.document.methods)

    @Slot()
    def _follow_selection(self) -> None:
        session = self.session
        placing = session.tool.name == "picture"  # then the picture can be deleted
        self.actions_table["delete"].setEnabled(bool(session.selection) or session.tool.busy or placing)
        self.sequencing.show(self.actions_table)
        self.partnering.show(self.actions_table)

    @Slot()
    def _follow_tool(self) -> None:
        self.actions_table[self.session.tool.name].setChecked(True)
        self._follow()

    # theme and end

    def _apply(self, theme: Theme) -> None:
        application = QApplication.instance()
        assert isinstance(application, QApplication)
        apply_theme(application, theme)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self.actions_table.dress(self.palette())
            self.watching.dress()
            self._follow_theme()

    def _follow_theme(self) -> None:
        self.actions_table[theme_of(self.palette()).name].setChecked(True)

    def closeEvent(self, event: QCloseEvent) -> None:
        if self.files.may_go():
            self.player.pause()
            keep_window(self, self.actions_table, self.session.path)
            self.importing.close()
            self.session.close()
            self.recovering.close()
            event.accept()
        else:
            event.ignore()
