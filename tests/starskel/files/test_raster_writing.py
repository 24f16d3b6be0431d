import numpy as np
import pytest

from starskel.errors import InvalidFile
from starskel.files.raster import read_image
from starskel.files.raster_writing import MOVING, write_animation, write_image
from tests.starskel.files.moving import read_animation
from tests.starskel.images.drawn import noise, waves


def test_png_keeps_every_level(tmp_path):
    pixels = noise(31, 17)
    write_image(tmp_path / "picture.png", pixels)
    assert np.array_equal(read_image(tmp_path / "picture.png"), pixels)


@pytest.mark.parametrize("ending", MOVING)
def test_what_moves_comes_back(tmp_path, ending):
    path = tmp_path / f"morph{ending}"
    frames = [waves(40, 30, phase) for phase in (0, 0.7, 1.4)]
    for k, frame in enumerate(frames):
        frame[:, : 5 + k, 3] = 0
    write_animation(path, frames, [0.1, 0.25, 0.05])
    found, durations = read_animation(path)
    assert np.allclose(durations, [0.1, 0.25, 0.05])
    for frame, own in zip(found, frames, strict=True):
        assert np.array_equal(frame[..., 3], own[..., 3])
        shown = own[..., 3] > 0
        assert np.abs(frame[shown].astype(int) - own[shown]).mean() < (6 if ending == ".gif" else 0.01)


def test_durations_that_are_no_whole_hundredths_add_up(tmp_path):
    path = tmp_path / "morph.gif"
    write_animation(path, [waves(8, 8, k) for k in range(30)], [2 / 30] * 30)
    assert sum(read_animation(path)[1]) == pytest.approx(2)


def test_an_unknown_ending_leaves_no_file(tmp_path):
    with pytest.raises(InvalidFile, match=r'"\.avi"; end it in \.gif or \.apng or \.webp'):
        write_animation(tmp_path / "morph.avi", [waves(4, 4)], [1.0])
    assert not list(tmp_path.iterdir())
