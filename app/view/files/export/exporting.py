"""Export from the user's side: what and where is asked, and the file written."""

from pathlib import Path

from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QWidget

from app.compute.errands import Work
from app.export import FORMATS, Choice, ExportedStep, write_choice
from app.session import Session
from app.view.asking import accepted
from app.view.files.dialogs import complain, may_overwrite, path_to_save
from app.view.files.export.dialog import ExportDialog
from app.view.files.waiting import Waiting
from app.view.painting.display import Display
from app.view.timeline.player import Player
from starskel.errors import Cancelled, StarskelError
from starskel.export.write import paths_of
from starskel.files.projects.part_looks import part_looks
from starskel.files.projects.project import letter

translate = QCoreApplication.translate


class Exporting:
    """Asks what to export and where, and writes it; the next time it begins with what was chosen.

    Parameters
    ----------
    window : QWidget
        Over which it is asked.
    session, player, display
        What there is to export, and how it is shown.
    """

    def __init__(self, window: QWidget, session: Session, player: Player, display: Display) -> None:
        self._window = window
        self._session = session
        self._player = player
        self._display = display
        self._choice: Choice | None = None
        self._endings: dict[str, str] = {}  # in which format each layout was written last

    def export(self, name: str) -> Path | None:
        """Ask, write, and give where; None where nothing was written.

        Parameters
        ----------
        name : str
            What the file may be called, without the ending.
        """
        document, whole = self._session.document, whole_sequence(self._session)
        shown = exported_steps(self._session)[document.sequence.drawn_step(document.step)]
        choice = self._chosen(shown, whole=bool(whole))
        if choice is None:
            return None
        last = self._endings.get(choice.layout)
        endings = sorted((each.ending for each in FORMATS[choice.layout]), key=lambda ending: ending != last)
        path = path_to_save(self._window, translate("Files", "Export"), name, endings)
        if path is None or not _may_write(self._window, path, choice):
            return None
        self._endings[choice.layout] = path.suffix
        film, chosen = document.name or name, whole if choice.whole else (shown,)
        return self._written(path, lambda task: write_choice(path, film, choice, chosen, task))

    def _chosen(self, shown: ExportedStep, *, whole: bool) -> Choice | None:
        dialog = ExportDialog(shown, self._player, self._display, self._window, whole=whole)
        if self._choice is not None:
            dialog.begin_with(self._choice)
        if not accepted(dialog):
            return None
        self._choice = dialog.choice
        return self._choice

    def _written(self, path: Path, work: Work) -> Path | None:
        """Write a file beside the window, and give where; None where that failed or was given up."""
        waiting = Waiting(translate("Files", "Writing {name}…").format(name=path.name), self._window)
        try:
            waiting.awaited(work)
        except Cancelled:
            return None
        except StarskelError as error:
            complain(self._window, translate("Files", "{name} was not written").format(name=path.name), error)
            return None
        return path


def _may_write(window: QWidget, path: Path, choice: Choice) -> bool:
    """Ask before numbered files are overwritten; of the file that was named the dialog has asked."""
    if choice.layout == "morph":
        return True
    there = [own for own in paths_of(path, choice.settings) if own != path and own.exists()]
    return not there or may_overwrite(window, there)


def exported_steps(session: Session) -> tuple[ExportedStep, ...]:
    """Give what there is to export of each step."""
    steps, shapes = session.document.sequence.steps, session.document.sequence.shapes
    return tuple(
        ExportedStep(
            session.blends.fresh_of(number),
            step,
            f"{letter(number)}-{letter(number + 1)}" if len(steps) > 1 else "",
            (shapes[number].picture, shapes[number + 1].picture),
            part_looks(shapes[number], step, shapes[number + 1]) if all(shapes[number : number + 2]) else (),
        )
        for number, step in enumerate(steps)
    )


def whole_sequence(session: Session) -> tuple[ExportedStep, ...]:
    """Give all steps, where there are several and all have the same methods; else none.

    Steps from or to a shape that is still empty do not count at both ends of the sequence.
    """
    places = [number for number, drawn in enumerate(session.document.sequence.drawn) if drawn]
    own = exported_steps(session)[places[0] : places[-1] + 1] if places else ()
    if not own:
        return ()
    methods = {result.method for result in own[0].results}
    done = methods and all(methods == {result.method for result in each.results} for each in own)
    return own if done and len(own) > 1 else ()
