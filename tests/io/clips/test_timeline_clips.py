"""Keys and exposures as text: what goes out comes in, and nothing else does any harm."""

from dataclasses import replace

import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

from kagezou.document.address import addresses
from kagezou.document.exposure_edits import ExposureClip
from kagezou.document.key_edits import all_keys, copy_keys, paste_keys
from kagezou.document.model import Canvas, Document
from kagezou.io.clips.timeline_clips import dumps_drawings, dumps_keys, loads_drawings, loads_keys
from tests.documents import documents

_EMPTY = Document(Canvas(100, 100))


@st.composite
def clips(draw: st.DrawFn) -> ExposureClip:
    names = st.none() | st.text(st.characters(codec="utf-8"), min_size=1, max_size=20)
    length = draw(st.integers(1, 500))
    frames = draw(st.sets(st.integers(0, length - 1), min_size=1, max_size=20))
    return ExposureClip(tuple((frame, draw(names)) for frame in sorted(frames)), length)


@given(clips())
def test_exposures_come_back(clip: ExposureClip) -> None:
    assert loads_drawings(dumps_drawings(clip)) == clip


@settings(suppress_health_check=[HealthCheck.too_slow])
@given(documents())
def test_keys_come_back_to_where_they_were(document: Document) -> None:
    clip = copy_keys(document, frozenset().union(*(all_keys(document, each) for each in addresses(document))))
    assume(clip is not None)
    assert clip is not None
    found = loads_keys(dumps_keys(document, clip), document)
    assert found is not None
    assert found.frame == clip.frame
    assert set(found.keys) == set(clip.keys)


@settings(suppress_health_check=[HealthCheck.too_slow])
@given(documents())
def test_keys_of_a_layer_go_onto_a_layer_of_another_name(document: Document) -> None:
    assume(document.layers)
    layer = document.layers[0]
    own = [each for each in addresses(document) if each.layer_id == layer.id]
    clip = copy_keys(document, frozenset().union(*(all_keys(document, each) for each in own)))
    assume(clip is not None)
    assert clip is not None
    text = dumps_keys(document, clip)
    other = replace(layer, id="other", name="b.shadow", tracks={})
    elsewhere = replace(document, layers=(other,), linked=frozenset())
    found = loads_keys(text, elsewhere)
    assert found is not None
    pasted, refs = paste_keys(elsewhere, found, None, "other")
    assert {(ref.address.property.name, ref.frame) for ref in refs} == {
        (address.property.name, key.frame) for address, key in clip.keys
    }
    assert pasted.layer("other").tracks


@given(st.text(max_size=200))
def test_other_text_is_no_copy(text: str) -> None:
    assert loads_keys(text, _EMPTY) is None
    assert loads_drawings(text) is None


@pytest.mark.parametrize(
    "text",
    [
        '{"kagezou-keys": {}}',
        '{"kagezou-keys": {"light.position": [{"frame": 1}]}}',
        '{"kagezou-keys": {"light.position": [{"frame": 0, "value": [1, 2, 3], "interpolation": "hold"}]}}',
        '{"kagezou-keys": {"no.such": [{"frame": 1, "value": 2, "interpolation": "hold"}]}}',
        '{"kagezou-keys": {"layers.": []}, "more": 1}',
        '{"kagezou-keys": ' + "[" * 5000,
        '{"kagezou-drawings": {"length_frames": 4, "entries": [[4, "1"]]}}',
        '{"kagezou-drawings": {"length_frames": 0, "entries": [[0, "1"]]}}',
        '{"kagezou-drawings": {"length_frames": 4, "entries": []}}',
        '{"kagezou-drawings": {"length_frames": 4, "entries": [[0, 1]]}}',
        '{"kagezou-drawings": [',
    ],
)
def test_what_is_not_whole_is_no_copy(text: str) -> None:
    assert loads_keys(text, _EMPTY) is None
    assert loads_drawings(text) is None
