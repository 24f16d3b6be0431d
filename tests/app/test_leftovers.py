import pytest
from PySide6.QtCore import QThread, QTimer
from PySide6.QtWidgets import QMessageBox, QWidget

from tests.app.leftovers import every_dialog_answered, left_alive


def test_a_window_left_open_is_named(qapp) -> None:  # type: ignore[no-untyped-def]
    widget = QWidget()
    widget.show()
    assert len(left_alive()) == 1
    widget.deleteLater()
    assert left_alive() == []


def test_a_running_thread_is_named(qapp) -> None:  # type: ignore[no-untyped-def]
    thread = QThread()
    thread.start()
    assert len(left_alive()) == 1
    thread.quit()
    thread.wait()
    assert left_alive() == []


def test_a_dialog_that_nobody_answers_is_closed_and_fails_the_test(qapp) -> None:  # type: ignore[no-untyped-def]
    question = QMessageBox(windowTitle="Well?")
    with pytest.raises(AssertionError, match=r"nobody answered.*Well"), every_dialog_answered(50):
        question.exec()
    question.deleteLater()


def test_dialogs_that_are_answered_one_after_another_fail_nothing(qapp) -> None:  # type: ignore[no-untyped-def]
    with every_dialog_answered(50):
        for _ in range(8):
            question = QMessageBox()
            QTimer.singleShot(30, question.accept)
            question.exec()
            question.deleteLater()
