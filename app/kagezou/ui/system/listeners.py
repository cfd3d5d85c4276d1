"""Listeners of what outlives a window, and of what a window leaves behind."""

from collections.abc import Iterable, Iterator
from dataclasses import fields, is_dataclass

from PySide6.QtCore import QMetaMethod, QObject
from shiboken6 import isValid


def forget_listeners(senders: Iterable[QObject]) -> None:
    """Take every receiver from the signals of objects, but from those that every object has.

    What is connected by functions is not let go of when what they use goes: it would be called in vain, and as nobody
    sees what such functions hold, circles through them would stay in memory for good.
    """
    # A window has hundreds of objects, of few classes.
    known: dict[type[QObject], tuple[str, ...]] = {}
    for sender in senders:
        if not isValid(sender):
            continue
        kind = type(sender)
        if kind not in known:
            known[kind] = _signals_of(sender)
        for name in known[kind]:
            # None is any receiver, which PySide's types do not know.
            QObject.disconnect(sender, name, None, None)  # type: ignore[call-overload] # see above


def _signals_of(sender: QObject) -> tuple[str, ...]:
    """Return the signals of an object's class, as the macro SIGNAL writes their names."""
    kind, first = sender.metaObject(), QObject().metaObject().methodCount()
    methods = map(kind.method, range(first, kind.methodCount()))
    signals = (each for each in methods if each.methodType() == QMetaMethod.MethodType.Signal)
    return tuple(f"2{bytes(each.methodSignature().data()).decode()}" for each in signals)


def senders_within(part: object, beside: Iterable[object]) -> Iterator[QObject]:
    """Yield the objects with signals of its own that a part of the window is made of, but for what lies beside it."""
    yield from _walked(part, {id(each) for each in beside})


def _walked(part: object, seen: set[int]) -> Iterator[QObject]:
    if id(part) in seen:
        return
    seen.add(id(part))
    if isinstance(part, QObject) and _is_ours(part):
        yield part
    for inner in _inside(part):
        yield from _walked(inner, seen)


def _inside(part: object) -> Iterable[object]:
    match part:
        case list() | tuple():
            return part
        case dict():
            return part.values()
    if not _is_ours(part):
        return ()
    if is_dataclass(part):
        return [getattr(part, field.name) for field in fields(part)]
    return list(vars(part).values()) if hasattr(part, "__dict__") else ()


def _is_ours(part: object) -> bool:
    return type(part).__module__.startswith("kagezou.ui.")
