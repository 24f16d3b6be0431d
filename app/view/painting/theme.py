"""Colours by role, light and dark.

Each colour that carries a meaning has a second sign beside it (a label, a glyph, a dash pattern), so that
nothing is told by colour alone.
"""

from dataclasses import dataclass

from PySide6.QtGui import QColor, QPalette, QPixmapCache
from PySide6.QtWidgets import QApplication

from app.model.marks import Side


@dataclass(frozen=True)
class Theme:
    """A set of colours as "#rrggbb".

    Attributes
    ----------
    window, base, button, edge : str
        Grounds: of the window, of canvases and fields, of controls; and the thin lines between them.
    frame : str
        What the style darkens to outline boxes that are checked; of the theme's lightness.
    text, muted : str
        Writing, and writing that may be overlooked.
    accent, on_accent : str
        What is selected or under the pointer, and writing on it.
    source, middle, target : str
        The two shapes, and frames half-way between them.
    refused, simple : str
        What does not go, and what is in order.
    pins, pieces, methods : tuples of str
        Colours that follow each other: of marks (with white writing on them), star pieces and method curves.
    """

    name: str
    window: str
    base: str
    button: str
    edge: str
    frame: str
    text: str
    muted: str
    accent: str
    on_accent: str
    source: str
    middle: str
    target: str
    refused: str
    simple: str
    pins: tuple[str, ...]
    pieces: tuple[str, ...]
    methods: tuple[str, ...]

    def side(self, side: Side) -> QColor:
        """Give the colour of a shape."""
        return QColor(self.source if side == "source" else self.target)

    @property
    def ends(self) -> tuple[str, str]:
        """The colours of source and target."""
        return self.source, self.target

    def between(self, t: float) -> QColor:
        """Give the colour of a frame, by way of a third: the mean of the two would be grey."""
        source, middle, target = (QColor(c) for c in (self.source, self.middle, self.target))
        return mixed(source, middle, 2 * t) if t < 0.5 else mixed(middle, target, 2 * t - 1)


STRONG = ("#1f5fbf", "#b3401f", "#2e7d32", "#8e3aa8", "#9a6700", "#00727a", "#c2185b", "#5d4037")
"""Colours that white writing can be read on, and that lines on white can be told apart by."""

LIGHT = Theme(
    name="light",
    window="#eef0f3",
    base="#ffffff",
    button="#fafbfc",
    edge="#cfd4da",
    frame="#eef0f3",
    text="#1d2329",
    muted="#5b6570",
    accent="#1a66d6",
    on_accent="#ffffff",
    source="#2f74d0",
    middle="#9555b5",
    target="#d0701c",
    refused="#c8102e",
    simple="#1b7a3d",
    pins=STRONG,
    pieces=("#8fb8ea", "#f3b983", "#9fd6a8", "#d6a6e0", "#efd27a", "#8fd3d6", "#eda3b8", "#c4b5a8"),
    methods=STRONG,
)

DARK = Theme(
    name="dark",
    window="#22262b",
    base="#181b1f",
    button="#2d3238",
    edge="#444b53",
    frame="#707a85",
    text="#e6e9ec",
    muted="#a3adb8",
    accent="#5b9cf5",
    on_accent="#0d1116",
    source="#6ba4ee",
    middle="#c58be0",
    target="#ef9a4d",
    refused="#ff6b78",
    simple="#6fcf8b",
    pins=STRONG,
    pieces=("#35588a", "#8a5527", "#3a7047", "#704a80", "#7d6a24", "#2c6f73", "#84435a", "#655748"),
    methods=("#6ba4ee", "#ef9a4d", "#7ccf86", "#d08be6", "#5cc8ce", "#e0b64a"),
)


FRAMED = ("QCheckBox", "QRadioButton", "QListView", "QTreeView", "QTableView")
"""Widgets with boxes to be checked, which Fusion outlines darker than the window: unseen on a dark one."""

PAINTED_ICONS = 2048
"""Kilobytes of icons that Qt keeps as it painted them; by itself it keeps 10 MB, most of shapes long gone."""


def mixed(a: QColor, b: QColor, share: float) -> QColor:
    channels = zip((a.redF(), a.greenF(), a.blueF()), (b.redF(), b.greenF(), b.blueF()), strict=True)
    return QColor.fromRgbF(*(x + share * (y - x) for x, y in channels))


def theme_of(palette: QPalette) -> Theme:
    """Give the theme that a palette belongs to."""
    return DARK if palette.color(QPalette.ColorRole.Window).lightnessF() < 0.5 else LIGHT


def apply_theme(application: QApplication, theme: Theme) -> None:
    """Set style and palette of the whole program."""
    QPixmapCache.setCacheLimit(PAINTED_ICONS)
    application.setStyle("Fusion")
    application.setPalette(palette_of(theme))
    framed = palette_of(theme)
    framed.setColor(QPalette.ColorRole.Window, QColor(theme.frame))
    for widgets in FRAMED:
        application.setPalette(framed, widgets)  # type: ignore[arg-type]  # its stub says bytes, it takes str


def palette_of(theme: Theme) -> QPalette:
    """Give the palette for Qt's own widgets."""
    role = QPalette.ColorRole
    palette = QPalette(QColor(theme.button), QColor(theme.window))
    for roles, colour in (
        ((role.WindowText, role.Text, role.ButtonText, role.ToolTipText), theme.text),
        ((role.Base, role.ToolTipBase), theme.base),
        ((role.AlternateBase,), theme.window),
        ((role.PlaceholderText,), theme.muted),
        ((role.Highlight, role.Link, role.Accent), theme.accent),
        ((role.HighlightedText, role.BrightText), theme.on_accent),
        ((role.Mid,), theme.edge),
    ):
        for each in roles:
            palette.setColor(each, QColor(colour))
    faded = QColor(theme.muted)
    faded.setAlphaF(0.55)
    for each in (role.WindowText, role.Text, role.ButtonText):
        palette.setColor(QPalette.ColorGroup.Disabled, each, faded)
    return palette
