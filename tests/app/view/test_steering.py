"""The star-skeleton's root and whole turns."""

from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QSpinBox, QToolButton

from starskel.blending.star_skeleton import StarSkeletonBlend
from starskel.files.examples import example
from tests.app.driver import LEFT, PLAIN, Driver


@pytest.fixture
def arm(driver: Driver) -> Driver:
    driver.session.show_project(example("arm"))
    driver.wait_for_blends()
    return driver


def shown(driver: Driver) -> StarSkeletonBlend:
    result = driver.session.results["star-skeleton"].result
    assert result is not None
    assert isinstance(result.blend, StarSkeletonBlend)
    return result.blend


def click_on_origin(driver: Driver, piece: int) -> None:
    view = driver.window.panels.panel("star-skeleton").view
    places = view.camera.to_screen(shown(driver).skeleton_at(driver.window.player.t))
    place = places[piece].round().astype(int)
    QTest.mouseClick(view, LEFT, PLAIN, view.rect().topLeft() + type(view.rect().topLeft())(*place.tolist()))


def test_a_click_on_a_star_origin_makes_it_the_root(arm: Driver) -> None:
    arm.window.actions_table["skeleton"].trigger()
    others = {m: arm.session.results[m].result for m in ("stitched", "rigid", "vertex")}
    blend = shown(arm)
    piece = next(k for k in range(len(blend.decomposition.pieces)) if k != blend.skeleton.root)
    click_on_origin(arm, piece)
    arm.wait_for_blends()
    assert shown(arm).skeleton.root == piece
    assert {m: arm.session.results[m].result for m in others} == others  # nothing else was computed
    button = arm.window.findChild(QToolButton, "usual-root")
    assert button is not None
    QTest.mouseClick(button, LEFT)
    arm.wait_for_blends()
    assert shown(arm).skeleton.root == blend.skeleton.root


def test_without_a_skeleton_on_the_screen_a_click_chooses_nothing(arm: Driver) -> None:
    blend = shown(arm)
    click_on_origin(arm, next(k for k in range(len(blend.decomposition.pieces)) if k != blend.skeleton.root))
    assert arm.document.way.root is None


def test_whole_turns_are_added(arm: Driver) -> None:
    before = shown(arm)
    field = arm.window.findChild(QSpinBox, "turns")
    assert field is not None
    QTest.keyClick(field, Qt.Key.Key_Up)
    arm.wait_for_blends()
    after = shown(arm)
    size = np.ptp(before.pair.source)
    for t in (0.0, 1.0):
        np.testing.assert_allclose(after.at(t), before.at(t), atol=1e-9 * size)
    assert np.abs(after.at(0.5) - before.at(0.5)).max() > 0.1 * size


def test_another_document_starts_unsteered(arm: Driver) -> None:
    field = arm.window.findChild(QSpinBox, "turns")
    assert field is not None
    QTest.keyClick(field, Qt.Key.Key_Up)
    arm.session.show_project(example("star"))
    assert arm.document.way.turns == 0
    assert field.value() == 0


def test_root_and_turns_are_undone_redone_and_saved(arm: Driver, tmp_path: Path) -> None:
    arm.window.actions_table["skeleton"].trigger()
    blend = shown(arm)
    click_on_origin(arm, next(k for k in range(len(blend.decomposition.pieces)) if k != blend.skeleton.root))
    assert arm.session.undoes == "Choose root"
    field = arm.window.findChild(QSpinBox, "turns")
    assert field is not None
    for _ in range(2):
        QTest.keyClick(field, Qt.Key.Key_Up)
    assert arm.session.undoes == "Set whole turns"
    steered = arm.document
    arm.session.undo()
    assert (field.value(), arm.document.way.turns) == (0, 0)
    arm.session.undo()
    assert arm.document.way.root is None
    assert not arm.session.unsaved
    arm.session.redo()
    arm.session.redo()
    assert arm.session.unsaved
    arm.session.save(tmp_path / "arm.json")
    assert not arm.session.unsaved
    arm.session.new()
    arm.session.open(tmp_path / "arm.json")
    assert arm.document.way == steered.way
    assert field.value() == 2
