"""Export from the user's side: what and where is asked, and the file written."""

from pathlib import Path

from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QWidget

from app.export import FORMATS, Choice, Stretch, write_choice
from app.session import Session
from app.view.asking import accepted
from app.view.files.dialogs import complain, may_overwrite, path_to_save
from app.view.files.export_dialog import ExportDialog
from app.view.files.waiting import Waiting
from app.view.painting.display import Display
from app.view.timeline.player import Player
from starskel.errors import StarskelError
from starskel.export.write import paths_of
from starskel.files.part_looks import part_looks
from starskel.files.project import letter

translate = QCoreApplication.translate


def export(window: QWidget, session: Session, player: Player, display: Display, name: str) -> Path | None:
    """Ask what to export and where, write it, and give where; None where nothing was written.

    Parameters
    ----------
    window : QWidget
        Over which it is asked.
    session, player, display
        What there is to export, and how it is shown.
    name : str
        What the file may be called, without the ending.
    """
    number = session.document.sequence.drawn_step(session.document.step)
    shown, whole = stretches(session)[number], whole_sequence(session)
    dialog = ExportDialog(shown, player, display, window, whole=bool(whole))
    if not accepted(dialog):
        return None
    choice = dialog.choice
    title = translate("Files", "Export")
    endings = tuple(each.ending for each in FORMATS[choice.layout])
    path = path_to_save(window, title, name, endings)
    if path is None or not _may_write(window, path, choice):
        return None
    film, chosen = session.document.name or name, whole if choice.whole else (shown,)
    waiting = Waiting(translate("Files", "Writing {name}…").format(name=path.name), window)
    outcome = waiting.wait(lambda task: write_choice(path, film, choice, chosen, task))
    if outcome is None:
        return None
    if isinstance(outcome.error, StarskelError):
        complain(window, translate("Files", "{name} was not written").format(name=path.name), outcome.error)
        return None
    if outcome.error is not None:
        raise outcome.error
    return path


def _may_write(window: QWidget, path: Path, choice: Choice) -> bool:
    """Ask before numbered files are overwritten; of the file that was named the dialog has asked."""
    if choice.layout == "morph":
        return True
    there = [own for own in paths_of(path, choice.settings) if own != path and own.exists()]
    return not there or may_overwrite(window, there)


def stretches(session: Session) -> tuple[Stretch, ...]:
    """Give what there is to export of each step."""
    steps, shapes = session.document.sequence.steps, session.document.sequence.shapes
    return tuple(
        Stretch(
            session.blends.fresh_of(number),
            step,
            f"{letter(number)}-{letter(number + 1)}" if len(steps) > 1 else "",
            (shapes[number].picture, shapes[number + 1].picture),
            part_looks(shapes[number], step, shapes[number + 1]) if all(shapes[number : number + 2]) else (),
        )
        for number, step in enumerate(steps)
    )


def whole_sequence(session: Session) -> tuple[Stretch, ...]:
    """Give all steps, where there are several and all have the same methods; else none.

    Steps from or to a shape that is still empty do not count at both ends of the sequence.
    """
    places = [number for number, drawn in enumerate(session.document.sequence.drawn) if drawn]
    own = stretches(session)[places[0] : places[-1] + 1] if places else ()
    if not own:
        return ()
    methods = {result.method for result in own[0].results}
    done = methods and all(methods == {result.method for result in each.results} for each in own)
    return own if done and len(own) > 1 else ()
