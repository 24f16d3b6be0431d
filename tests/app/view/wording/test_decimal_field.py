import pytest
from PySide6.QtCore import QLocale, Qt
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


def test_it_follows_a_number_but_not_while_another_one_is_typed(qtbot):
    field = DecimalField()
    qtbot.addWidget(field)
    with qtbot.waitExposed(field):
        field.show()
    field.setFocus()
    field.setKeyboardTracking(False)
    heard = []
    field.valueChanged.connect(heard.append)
    field.follow(2)
    field.selectAll()
    QTest.keyClicks(field, "50")
    field.follow(3)
    assert field.text() == "50"
    QTest.keyClick(field, Qt.Key.Key_Return)
    field.follow(4)
    assert (heard, field.value()) == ([50.0], 4.0)
