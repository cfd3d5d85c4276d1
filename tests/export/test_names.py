import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.export.names import digits_for, safe_names

DEVICES = ["CON", "con", "Aux", "NUL", "COM1", "lpt9", "COM¹", "CONIN$"]


def one(name: str) -> str:
    return safe_names([name])[name]


@pytest.mark.parametrize("name", ["A", "Hero 2", "影像", "été", "a-b_c", "v1.2", "Ünïcode 😀"])
def test_ordinary_names_stay(name: str) -> None:
    assert one(name) == name


@pytest.mark.parametrize(
    ("name", "safe"),
    [
        ("a/b", "a_b"),
        ("..", "_"),
        ("../../etc", "__.._etc"),
        ("a\\b:c*d?e", "a_b_c_d_e"),
        ("<|>", "___"),
        ("tail.", "tail_"),
        ("tail ", "tail"),
        (".hidden", "_hidden"),
        ("line\nend", "line_end"),
        ("right\u202eleft", "right_left"),
    ],
)
def test_what_a_system_refuses_is_replaced(name: str, safe: str) -> None:
    assert one(name) == safe


@pytest.mark.parametrize("name", [*DEVICES, "con.walk", "nul .x"])
def test_device_names_are_set_apart(name: str) -> None:
    assert one(name).startswith("_")


def test_names_that_some_systems_take_for_the_same_get_numbers() -> None:
    names = ["Hero", "hero", "HERO", "caf\u00e9", "cafe\u0301", "a/b", "a:b"]
    safe = safe_names(names)
    assert list(safe.values()) == ["Hero", "hero_2", "HERO_3", "café", "cafe\u0301_2", "a_b", "a_b_2"]


def test_a_number_does_not_clash_with_a_name_that_is_there() -> None:
    safe = safe_names(["a/b", "a_b_2", "a:b", "a?b"])
    assert len({name.casefold() for name in safe.values()}) == 4


def test_very_long_names_fit_into_a_file_name() -> None:
    safe = safe_names(["影" * 200, "影" * 199 + "x"])
    assert len(set(safe.values())) == 2
    assert all(len(f"{name}_shadow_000001.png".encode()) <= 200 for name in safe.values())


@given(st.lists(st.text(min_size=1, max_size=30), unique=True, max_size=8))
def test_any_names_become_different_plain_ones(names: list[str]) -> None:
    safe = safe_names(names)
    folded = {name.casefold() for name in safe.values()}
    assert len(folded) == len(names)
    for name in safe.values():
        assert name
        assert name.strip(" .") == name or not name.endswith((" ", "."))
        assert not set(name) & set('<>:"/\\|?*\0\n')
        assert name.isprintable()


@pytest.mark.parametrize(("last", "digits"), [(1, 4), (9999, 4), (10000, 5), (1_000_000, 7)])
def test_every_number_of_a_cut_has_as_many_digits(last: int, digits: int) -> None:
    assert digits_for(last) == digits
