"""The star-skeleton's root and whole turns."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QSpinBox, QToolButton

from starskel.blending.star_skeleton import StarSkeletonBlend
from starskel.cli import main
from starskel.files.projects.examples import example
from starskel.shapes.structure import Structure, structures_at
from tests.app.driver import LEFT, PLAIN, Driver


@pytest.fixture
def arm(driver: Driver) -> Driver:
    driver.session.show_project(example("arm"))
    driver.wait_for_blends()
    return driver


def shown(driver: Driver) -> StarSkeletonBlend:
    result = driver.session.blends.results["star-skeleton"].result
    assert result is not None
    assert isinstance(result.blend, StarSkeletonBlend)
    return result.blend


def click_on_origin(driver: Driver, piece: int, button: Qt.MouseButton = LEFT) -> None:
    view = driver.window.panels.panel("star-skeleton").view
    places = view.camera.to_screen(shown(driver).skeleton_at(driver.window.player.t))
    place = places[piece].round().astype(int)
    QTest.mouseClick(
        view, button, PLAIN, view.rect().topLeft() + type(view.rect().topLeft())(*place.tolist())
    )


def test_a_click_on_a_star_origin_makes_it_the_root(arm: Driver) -> None:
    arm.window.actions_table["skeleton"].trigger()
    others = {m: arm.session.blends.results[m].result for m in ("stitched", "rigid", "vertex")}
    blend = shown(arm)
    piece = next(k for k in range(len(blend.decomposition.pieces)) if k != blend.skeleton.root)
    click_on_origin(arm, piece)
    arm.wait_for_blends()
    assert shown(arm).skeleton.root == piece
    assert {m: arm.session.blends.results[m].result for m in others} == others  # nothing else was computed
    button = arm.window.findChild(QToolButton, "usual-root")
    assert button is not None
    QTest.mouseClick(button, LEFT)
    arm.wait_for_blends()
    assert shown(arm).skeleton.root == blend.skeleton.root


def test_other_buttons_choose_no_root(arm: Driver) -> None:
    arm.window.actions_table["skeleton"].trigger()
    blend = shown(arm)
    piece = next(k for k in range(len(blend.decomposition.pieces)) if k != blend.skeleton.root)
    for button in (Qt.MouseButton.RightButton, Qt.MouseButton.MiddleButton):
        click_on_origin(arm, piece, button)
    assert not arm.document.way.roots


def test_without_a_skeleton_on_the_screen_a_click_chooses_nothing(arm: Driver) -> None:
    blend = shown(arm)
    click_on_origin(arm, next(k for k in range(len(blend.decomposition.pieces)) if k != blend.skeleton.root))
    assert not arm.document.way.roots


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
    assert not arm.document.way.roots
    assert not arm.session.unsaved
    arm.session.redo()
    arm.session.redo()
    assert arm.session.unsaved
    arm.save(tmp_path / "arm.json")
    assert not arm.session.unsaved
    arm.session.new()
    arm.open(tmp_path / "arm.json")
    assert arm.document.way == steered.way
    assert field.value() == 2


def test_each_part_has_a_root_of_its_own(driver: Driver, tmp_path: Path) -> None:
    driver.session.show_project(replace(example("letters-b-8"), methods=("star-skeleton", "stitched")))
    driver.window.actions_table["skeleton"].trigger()
    driver.wait_for_blends()
    stitched = driver.session.blends.results["stitched"].result
    structure = structure_of(driver)
    blend = structure.blend
    piece = next(k for k in range(len(blend.decomposition.pieces)) if k != blend.skeleton.root)
    view = driver.window.panels.panel("star-skeleton").view
    place = view.camera.to_screen(structure.skeleton[piece]).round().astype(int)
    QTest.mouseClick(view, LEFT, PLAIN, QPoint(*place.tolist()))
    driver.wait_for_blends()
    assert structure_of(driver).blend.skeleton.root == piece
    assert driver.session.blends.results["stitched"].result is stitched
    assert [link.root is not None for link in driver.document.way.links] == [True, False, False]
    driver.save(tmp_path / "b.json")
    words = ["render", str(tmp_path / "b.json"), "--method", "star-skeleton", "--at", "0.5"]
    assert main([*words, "-o", str(tmp_path / "frame.json")]) == 0
    written = json.loads((tmp_path / "frame.json").read_text())
    result = driver.session.blends.results["star-skeleton"].result
    assert result is not None
    assert written["frames"][0] == [ring.tolist() for ring in result.rings_at(0.5)]
    driver.session.undo()
    assert not driver.document.way.roots


def structure_of(driver: Driver) -> Structure:
    """Give the star-skeleton of the first part as it is now."""
    result = driver.session.blends.results["star-skeleton"].result
    assert result is not None
    return next(structures_at(result.blend, driver.window.player.t))
