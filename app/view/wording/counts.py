"""Texts with a number in them: the translation tools find plurals only where a QObject says them by `tr`."""

from PySide6.QtCore import QObject

from app.model.news import News


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

    def held(self, count: int) -> str:
        """Say that so large shapes are blended only when that is asked for."""
        return self.tr(
            "%n vertices: blending takes minutes and much memory. F5 begins, Esc ends it.", "", count
        )

    def news(self, news: News) -> str:
        """Say what an edit brought with it."""
        told = (self.lost_marks, news.lost), (self.filled, news.filled), (self.opened, news.opened)
        return " ".join(sentence(count) for sentence, count in told if count)

    def filled(self, count: int) -> str:
        """Say that holes are parts now."""
        return self.tr("%n holes are parts now, as they are no longer inside their outline.", "", count)

    def opened(self, count: int) -> str:
        """Say that parts are holes now."""
        return self.tr("%n parts are holes now, as they are inside another part.", "", count)

    def lost_marks(self, count: int) -> str:
        """Say that an edit took marks away."""
        return self.tr("%n marks went with this edit. Undo brings them back.", "", count)


COUNTS = Counts()
