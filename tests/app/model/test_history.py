from app.model.document import Document
from app.model.history import History


def test_undo_and_redo_go_through_all_snapshots() -> None:
    documents = [Document(name=str(k)) for k in range(4)]
    history = History.of(documents[0])
    for document in documents[1:]:
        history = history.push(document, f"Edit {document.name}")
    assert history.undoes == "Edit 3"
    assert history.redoes is None
    for document in documents[2::-1]:
        history = history.undo()
        assert history.document is document
    assert history.undoes is None
    assert history.redoes == "Edit 1"
    assert history.undo() == history
    for document in documents[1:]:
        history = history.redo()
        assert history.document is document
    assert history.redo() == history


def test_a_new_edit_forgets_what_was_undone() -> None:
    history = History.of(Document()).push(Document(name="a"), "A").undo().push(Document(name="b"), "B")
    assert history.redoes is None
    assert [each.name for each in history.snapshots] == ["", "B"]


def test_steps_of_one_gesture_are_undone_at_once() -> None:
    history = History.of(Document(name="start"))
    for key in range(5):
        history = history.push(Document(name=str(key)), "Nudge", joins="same vertices")
    history = history.push(Document(name="last"), "Nudge", joins="other vertices")
    assert history.undo().document.name == "4"
    assert history.undo().undo().document.name == "start"


def test_what_is_looked_at_or_saved_in_between_ends_a_row_of_joined_steps() -> None:
    history = History.of(Document(name="start")).push(Document(name="a"), "Nudge", joins="vertex 0")
    for between in (history.showing(0, 1), history.saving(history.document)):
        later = between.push(Document(name="b"), "Nudge", joins="vertex 0")
        assert later.undo().document.name == "a"
        assert later.undo().undo().document.name == "start"
