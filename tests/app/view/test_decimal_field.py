import pytest
from PySide6.QtCore import QLocale
from PySide6.QtTest import QTest

from app.view.wording.decimal_field import DecimalField


@pytest.mark.parametrize("language", ["en", "de"])
@pytest.mark.parametrize("typed", ["1,5", "1.5"])
def test_a_comma_and_a_point_mean_the_same(language, typed, qtbot):
    field = DecimalField()
    qtbot.addWidget(field)
    field.setLocale(QLocale(language))
    field.setSuffix(" s")
    field.selectAll()
    QTest.keyClicks(field, typed)
    field.interpretText()
    assert field.value() == 1.5
    assert field.text() == f"1{field.locale().decimalPoint()}50 s"
