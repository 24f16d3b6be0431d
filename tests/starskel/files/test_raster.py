import contextlib
import io
import struct
import zlib
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from starskel.errors import InvalidFile
from starskel.files import raster
from starskel.files.raster import image_of, read_image
from tests.starskel.images.drawn import waves


def content(pixels, kind, **options):
    stream = io.BytesIO()
    Image.fromarray(pixels).save(stream, kind, **options)
    return stream.getvalue()


@pytest.mark.parametrize(("kind", "off"), [("JPEG", 3), ("WEBP", 3), ("BMP", 0), ("GIF", 8)])
def test_other_formats_are_read(kind, off):
    pixels = waves(64, 48)
    found = image_of(content(pixels[..., :3], kind))
    assert found.shape == (48, 64, 4)
    assert np.abs(found[..., :3].astype(int) - pixels[..., :3]).mean() <= off
    assert (found[..., 3] == 255).all()


def test_grey_palettes_and_16_bits_become_colours():
    grey = waves(20, 10)[..., 0]
    assert np.array_equal(image_of(content(grey, "PNG"))[..., 2], grey)
    assert np.array_equal(image_of(content(grey.astype(np.uint16) * 257, "PNG"))[..., 1], grey)
    stream = io.BytesIO()
    Image.fromarray(waves(20, 10)[..., :3]).quantize(16).save(stream, "PNG", transparency=0)
    assert set(np.unique(image_of(stream.getvalue())[..., 3])) == {0, 255}


def test_a_picture_taken_sideways_stands_upright():
    pixels = waves(40, 20)[..., :3]
    exif = Image.Exif()
    exif[0x0112] = 6
    found = image_of(content(pixels, "PNG", exif=exif))
    assert np.array_equal(found[..., :3], np.rot90(pixels, -1))


def png_of_size(width, height):
    """A PNG that says it is large, with hardly anything in it."""

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)
    return (
        b"\x89PNG\r\n\x1a\n"
        + chunk(b"IHDR", header)
        + chunk(b"IDAT", zlib.compress(b""))
        + chunk(b"IEND", b"")
    )


@pytest.mark.parametrize(
    "size", [(100_000, 100_000), (100_000, 1), (16_000, 16_000), (10_000, 9_000), (8_000, 6_501)]
)
def test_pictures_with_too_many_pixels_are_refused_before_memory_is_taken(size):
    with pytest.raises(InvalidFile, match=r"too many pixels.*at most 52000000 pixels, 16384 a side"):
        image_of(png_of_size(*size))


def test_too_large_files_are_refused(monkeypatch):
    monkeypatch.setattr(raster, "PICTURE_BYTES", 100)
    with pytest.raises(InvalidFile, match="at most 100 bytes"):
        image_of(bytes(101))


@pytest.mark.parametrize(("most", "parts"), [(1200, 1), (1199, 2), (300, 2), (299, 3), (80, 4), (1, 40)])
@pytest.mark.parametrize("kind", ["PNG", "BMP", "GIF"])
def test_large_pictures_are_read_smaller(kind, most, parts, monkeypatch):
    file = content(waves(40, 30)[..., :3], kind)
    whole = image_of(file)
    monkeypatch.setattr(raster, "PICTURE_PIXELS", most)
    found = raster.decoded(file)
    assert found.size == (40, 30)
    assert np.array_equal(found.pixels, np.asarray(Image.fromarray(whole).reduce(parts)))
    height, width = found.pixels.shape[:2]
    assert np.allclose(found.placed.to_document([(0, 0), (width, height)]), [(0, 30), (40, 0)])


@pytest.mark.parametrize(("most", "parts"), [(300, 2), (80, 4), (20, 8)])
def test_photographs_are_decoded_smaller(most, parts, monkeypatch):
    file = content(waves(40, 32)[..., :3], "JPEG")
    whole = image_of(file)
    monkeypatch.setattr(raster, "PICTURE_PIXELS", most * 32 // 30)
    found = raster.decoded(file)
    expected = np.asarray(Image.fromarray(whole).reduce(parts)).astype(int)
    assert found.size == (40, 32)
    assert found.pixels.shape == expected.shape
    assert np.abs(found.pixels - expected).mean() < 2


def test_a_large_picture_taken_sideways_stands_upright(monkeypatch):
    pixels = waves(40, 20)[..., :3]
    exif = Image.Exif()
    exif[0x0112] = 6
    whole = raster.decoded(content(pixels, "PNG", exif=exif))
    monkeypatch.setattr(raster, "PICTURE_PIXELS", 200)
    found = raster.decoded(content(pixels, "PNG", exif=exif))
    assert found.size == whole.size == (20, 40)
    assert np.array_equal(found.pixels, np.asarray(Image.fromarray(whole.pixels).reduce(2)))


@pytest.mark.parametrize(
    ("kind", "options", "most"),
    [("WEBP", {}, 100), ("JPEG", {"progressive": True}, 300), ("JPEG", {}, 500), ("PNG", {}, 300)],
)
def test_how_large_a_picture_may_be_depends_on_what_decoding_takes(kind, options, most, monkeypatch):
    monkeypatch.setattr(raster, "WHOLE_PIXELS", 300)
    monkeypatch.setattr(raster, "_MOST", {"WEBP": 100, "JPEG": 500})
    image_of(content(np.zeros((1, most, 3), dtype=np.uint8), kind, **options))
    with pytest.raises(InvalidFile, match=f"too many pixels: {most + 1} × 1; .*at most {most} pixels"):
        image_of(content(np.zeros((1, most + 1, 3), dtype=np.uint8), kind, **options))


@pytest.mark.parametrize("kind", ["PNG", "JPEG", "GIF", "WEBP", "BMP"])
def test_cut_off_and_flipped_files_are_damaged_or_read(kind):
    whole = content(waves(32, 24)[..., :3], kind)
    rng = np.random.default_rng(1)
    for _ in range(60):
        broken = bytearray(whole)
        if rng.random() < 0.5:
            del broken[rng.integers(1, len(whole)) :]
        for place in rng.integers(0, len(broken), 3):
            broken[place] ^= 1 << rng.integers(8)
        with contextlib.suppress(InvalidFile):  # no other error, and no memory without end
            assert image_of(bytes(broken)).nbytes <= 4 * raster.PICTURE_PIXELS


@pytest.mark.parametrize("junk", [b"", b"GIF89a", b"<svg/>", b"\x89PNG\r\n\x1a\n", bytes(1000)])
def test_what_is_no_picture_is_refused(junk, tmp_path):
    path = Path(tmp_path / "picture.png")
    path.write_bytes(junk)
    with pytest.raises(InvalidFile, match=r"picture\.png"):
        read_image(path)


@pytest.mark.parametrize("mode", ["L", "LA", "P", "RGB", "I;16"])
def test_pictures_of_any_kind_are_converted_strip_by_strip(mode, monkeypatch):
    grey = np.add.outer(np.arange(37), np.arange(21)).astype(np.uint8)
    image = (
        Image.fromarray(grey.astype(np.uint16) * 257)
        if mode == "I;16"
        else Image.fromarray(grey).convert(mode)
    )
    stream = io.BytesIO()
    image.save(stream, "PNG")
    whole = image_of(stream.getvalue())
    monkeypatch.setattr(raster, "_STRIP", 5)
    assert np.array_equal(image_of(stream.getvalue()), whole)
    assert np.array_equal(whole[..., 0], grey)
    assert (whole[..., 3] == 255).all()
