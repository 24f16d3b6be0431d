"""The language of the program: which there are, which one the user wants, and loading it."""

from PySide6.QtCore import QLibraryInfo, QLocale, QSettings, QTranslator
from PySide6.QtWidgets import QApplication

from starskel.files.projects.examples import resource_folder

SYSTEM = "system"
"""The choice to follow the system."""

LANGUAGES = ("en", "de")
"""Those that the program speaks, by their codes."""

_KEY = "language"


def chosen() -> str:
    """Give what the user chose: a language, or the system's."""
    choice = str(QSettings().value(_KEY, SYSTEM))
    return choice if choice in LANGUAGES else SYSTEM


def choose(choice: str) -> None:
    """Speak this language from the next start on."""
    QSettings().setValue(_KEY, choice)


def spoken(choice: str, system: QLocale) -> str:
    """Give the language to speak: the one chosen, else the first that the user reads, else English."""
    if choice in LANGUAGES:
        return choice
    wanted = [language.partition("-")[0] for language in system.uiLanguages()]
    return next((language for language in wanted if language in LANGUAGES), "en")


def speak(application: QApplication, language: str) -> list[QTranslator]:
    """Load a language for texts and numbers, those of Qt's own dialogs too; give what was loaded."""
    system = QLocale.system()
    locale = system if system.name().startswith(language) else QLocale(language)
    QLocale.setDefault(locale)  # a decimal comma goes with German, and so on
    folders = {
        "qtbase": QLibraryInfo.path(QLibraryInfo.LibraryPath.TranslationsPath),
        "starskel": str(resource_folder() / "translations"),
    }
    loaded = []
    for name, folder in folders.items():
        translator = QTranslator(application)
        if translator.load(f"{name}_{language}", folder):
            application.installTranslator(translator)
            loaded.append(translator)
    return loaded
