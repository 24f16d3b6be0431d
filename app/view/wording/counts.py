"""Texts with a number in them: the translation tools find plurals only where a QObject says them by `tr`."""

from PySide6.QtCore import QObject


class Counts(QObject):
    """Says how many there are of something, in the plural or singular of the user's language."""

    def vertices(self, count: int) -> str:
        return self.tr("%n vertices", "", count)

    def marks(self, count: int) -> str:
        return self.tr("%n marks", "", count)

    def parts(self, count: int) -> str:
        return self.tr("%n parts", "", count)

    def holes(self, count: int) -> str:
        return self.tr("%n holes", "", count)

    def seconds_left(self, count: int) -> str:
        return self.tr("about %n seconds left", "", count)

    def shapes_in(self, name: str, count: int) -> str:
        """Say how many shapes a file holds."""
        return self.tr("{name} holds %n shapes.", "", count).format(name=name)

    def lost_marks(self, count: int) -> str:
        """Say that an edit took marks away."""
        return self.tr("%n marks went with this edit. Undo brings them back.", "", count)


COUNTS = Counts()
