"""Easings that can be chosen by name."""

from app.model.texts import QT_TRANSLATE_NOOP
from starskel.easing import Easing

PRESETS = (
    (QT_TRANSLATE_NOOP("Easing", "Even"), Easing()),
    (QT_TRANSLATE_NOOP("Easing", "Ease in"), Easing((0.45, 0.0), (1.0, 1.0))),
    (QT_TRANSLATE_NOOP("Easing", "Ease out"), Easing((0.0, 0.0), (0.55, 1.0))),
    (QT_TRANSLATE_NOOP("Easing", "Ease in and out"), Easing((0.4, 0.0), (0.6, 1.0))),
    (QT_TRANSLATE_NOOP("Easing", "Linger at both ends"), Easing((0.8, 0.0), (0.2, 1.0))),
    (QT_TRANSLATE_NOOP("Easing", "Linger half-way"), Easing((0.0, 0.8), (1.0, 0.2))),
)
"""Easings by name."""
