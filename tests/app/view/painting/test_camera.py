import numpy as np
import pytest

from app.view.painting.camera import FARTHEST, NEAREST, Camera

CAMERA = Camera(400, 300, 2.5, (30.0, -20.0))


def test_screen_and_document_are_inverse_and_y_points_up() -> None:
    place = CAMERA.to_document(120, 40)
    np.testing.assert_allclose(CAMERA.to_screen(np.array(place)), (120, 40))
    assert CAMERA.to_document(120, 39)[1] > place[1]


@pytest.mark.parametrize("factor", [0.1, 1.25, 8])
def test_zooming_keeps_what_is_under_the_cursor(factor: float) -> None:
    zoomed = CAMERA.zoomed(factor, 37, 251)
    np.testing.assert_allclose(zoomed.to_document(37, 251), CAMERA.to_document(37, 251))
    assert zoomed.scale == CAMERA.scale * factor


def test_panning_moves_the_plane_with_the_hand() -> None:
    under = CAMERA.to_document(100, 100)
    np.testing.assert_allclose(CAMERA.panned(30, -12).to_document(130, 88), under)


@pytest.mark.parametrize("size", [1e-6, 1.0, 1e6])
def test_what_is_fitted_fills_the_view_up_to_the_margin(size: float) -> None:
    box = np.array([(0.0, 0.0), (2.0, 1.0)]) * size
    low, high = np.sort(CAMERA.fitting(box, margin=20).to_screen(box), axis=0)
    assert low[0] == pytest.approx(20)
    assert high[0] == pytest.approx(380)
    assert low[1] + high[1] == pytest.approx(300)


def test_a_view_smaller_than_its_margins_still_shows_something() -> None:
    assert Camera(10, 10).fitting(np.array([(0.0, 0.0), (1.0, 1.0)]), margin=40).scale > 0


@pytest.mark.parametrize(("factor", "most"), [(1.25, NEAREST), (1 / 1.25, FARTHEST)])
def test_a_wheel_that_spins_on_does_not_lose_the_shape(factor, most):
    fitted = Camera(200, 100).fitting(np.array([(0.0, 0.0), (1e-3, 2e-3)]), 10)
    camera = fitted
    for _ in range(1000):
        camera = camera.zoomed(factor, 30, 40)
    np.testing.assert_allclose(camera.scale, most * fitted.scale)
    np.testing.assert_allclose(camera.to_document(30, 40), fitted.to_document(30, 40), atol=1e-12)
    back = camera.zoomed(1 / factor, 30, 40)
    np.testing.assert_allclose(back.scale, camera.scale / factor)
