"""Menus of projects, each with a small picture: the examples, and the files that were open."""

from pathlib import Path

from PySide6.QtCore import QCoreApplication, QEvent, QRectF, QSize, Signal, Slot
from PySide6.QtGui import QAction, QColor, QIcon, QPalette
from PySide6.QtWidgets import QMenu, QProxyStyle, QStyle, QStyleOption, QWidget

from app.view.files.remembered import forget_files, recent_files
from app.view.painting.drawing import layer_of, painting
from app.view.painting.theme import theme_of
from app.view.painting.thumbnail import paint_thumbnail
from app.view.wording import plain, words
from starskel.errors import StarskelError
from starskel.files.documents import format_of
from starskel.files.projects.examples import example, example_names, figure_number
from starskel.files.projects.project import Project
from starskel.files.projects.project_document import FORMAT
from starskel.files.projects.project_file import read_project

translate = QCoreApplication.translate

PICTURE = QSize(40, 40)
"""Size of a project's picture, in pixels."""

LARGE = 200_000
"""Bytes of a file that takes too long to be read for its picture: ten of them are read at once."""


class _LargeIcons(QProxyStyle):
    """Fusion with icons in menus as large as a picture of a shape needs to be."""

    def pixelMetric(
        self,
        metric: QStyle.PixelMetric,
        option: QStyleOption | None = None,
        widget: QWidget | None = None,
    ) -> int:
        if metric == QStyle.PixelMetric.PM_SmallIconSize:
            return PICTURE.width()
        return super().pixelMetric(metric, option, widget)


class ProjectMenu(QMenu):
    """A menu whose entries are projects; it is filled when it is about to be seen."""

    chosen = Signal(object)
    """What stands for the project: the name of an example, or a path."""

    def __init__(self, title: str, parent: QWidget) -> None:
        super().__init__(title, parent)
        style = _LargeIcons("Fusion")
        style.setParent(self)
        self.setStyle(style)
        self.setToolTipsVisible(True)
        self.triggered.connect(self._choose)
        self.aboutToShow.connect(self.fill)

    @Slot()
    def fill(self) -> None:
        """Show the projects that there are now."""
        raise NotImplementedError

    def changeEvent(self, event: QEvent) -> None:
        """Make pictures anew in other colours, when they are seen again."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self.clear()

    def add(self, text: str, project: Project | None, tip: str, data: object) -> None:
        """Add an entry."""
        action = self.addAction(plain.entry(text))
        if project is not None:
            action.setIcon(project_icon(project, self.palette()))
        action.setToolTip(plain.tip(tip))
        action.setStatusTip(tip)
        action.setData(data)

    @Slot(QAction)
    def _choose(self, action: QAction) -> None:
        if action.data() is not None:
            self.chosen.emit(action.data())


class ExamplesMenu(ProjectMenu):
    """The projects that come with the program."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(translate("Menus", "E&xamples"), parent)

    @Slot()
    def fill(self) -> None:
        for name in () if self.actions() else example_names():
            if figure_number(name) == 1:
                self.addSection(translate("Menus", "Figures of the paper"))
            project = example(name)
            self.add(words.example(project.name), project, words.example(project.description), name)


class RecentMenu(ProjectMenu):
    """The files that were open, the last one first."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(translate("Menus", "Open &Recent"), parent)

    @Slot()
    def fill(self) -> None:
        self.clear()
        paths = recent_files()
        for path in paths:
            self.add(path.stem, _project(path), str(path), path)
        if paths:
            self.addSeparator()
        forget = self.addAction(translate("Menus", "&Clear List"), forget_files)
        forget.setEnabled(bool(paths))


def project_icon(project: Project, palette: QPalette, size: QSize = PICTURE) -> QIcon:
    """Give a picture of the first shape that has been drawn, in a second colour for where it is chosen."""
    shape = next((each for each in project.shapes if each.parts), None)
    icon = QIcon()
    theme = theme_of(palette)
    for mode, colour in (
        (QIcon.Mode.Normal, theme.side("source")),
        (QIcon.Mode.Active, QColor(theme.on_accent)),
        (QIcon.Mode.Selected, QColor(theme.on_accent)),
    ):
        picture = layer_of(size, 2.0)
        if shape is not None:
            with painting(picture) as painter:
                box = QRectF(0, 0, size.width(), size.height())
                paint_thumbnail(painter, box, shape, colour)
        icon.addPixmap(picture, mode)
    return icon


def _project(path: Path) -> Project | None:
    """Give what is in a file, for its picture.

    A large one has none, for the menu must not wait; nor a damaged one, which complains when it is opened.
    """
    try:
        if path.stat().st_size > LARGE or format_of(path) != FORMAT:
            return None
        return read_project(path)
    except (OSError, StarskelError):
        return None
