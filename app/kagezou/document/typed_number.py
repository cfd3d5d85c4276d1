"""What may be typed into a number field: a number, a sum, or a change of what is there (``*2``, ``/3``, ``+10``)."""

import ast
from math import isfinite

from kagezou.errors import UsageProblem
from kagezou.message import Message

_MAX_LENGTH = 60


def evaluate(text: str, current: float) -> float:
    """Return the number that ``text`` asks for.

    Parameters
    ----------
    text
        ``12.5``, ``(3+4)*2``, ``*2``, ``/3``, ``+10``, ``-=10``, ``50%`` of what is there. A leading minus is a
        negative number, because that is how people type one.
    current
        What is there.

    Raises
    ------
    UsageProblem
        If the text is no such thing, or its result is not finite.
    """
    typed = text.strip().replace("−", "-").replace("×", "*").replace(",", ".")
    refused = UsageProblem(
        Message("{text!r} is not a number; type 12.5, *2, /3, +10, -=10 or 50%", text=text.strip()[:30])
    )
    if not typed or len(typed) > _MAX_LENGTH:
        raise refused
    try:
        result = _relative(typed, current)
    except (SyntaxError, ZeroDivisionError, OverflowError, ValueError) as cause:
        raise refused from cause
    if not isfinite(result):
        raise refused
    return result


def is_relative(text: str) -> bool:
    """Return whether a text asks for a change of what is there."""
    typed = text.strip().replace("×", "*")
    return typed.endswith("%") or typed.startswith(("+", "*", "/", "-="))


def _relative(typed: str, current: float) -> float:
    if typed.endswith("%"):
        return current * _number(typed[:-1]) / 100
    for sign in ("+=", "-=", "*=", "/="):
        if typed.startswith(sign):
            return _applied(sign[0], current, _number(typed[2:]))
    if typed[0] in "+*/":
        return _applied(typed[0], current, _number(typed[1:]))
    return _number(typed)


def _applied(sign: str, left: float, right: float) -> float:
    match sign:
        case "+":
            return left + right
        case "-":
            return left - right
        case "*":
            return left * right
        case _:
            return left / right


def _number(text: str) -> float:
    return _value(ast.parse(text.strip(), mode="eval").body)


def _value(node: ast.expr) -> float:
    """Return the value of a syntax tree of plain arithmetic; ValueError for anything else, names and calls included."""
    match node:
        case ast.Constant(value=bool()):
            raise ValueError
        case ast.Constant(value=int() | float() as number):
            return float(number)
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return -_value(operand)
        case ast.UnaryOp(op=ast.UAdd(), operand=operand):
            return _value(operand)
        case ast.BinOp(left=left, op=ast.Add(), right=right):
            return _value(left) + _value(right)
        case ast.BinOp(left=left, op=ast.Sub(), right=right):
            return _value(left) - _value(right)
        case ast.BinOp(left=left, op=ast.Mult(), right=right):
            return _value(left) * _value(right)
        case ast.BinOp(left=left, op=ast.Div(), right=right):
            return _value(left) / _value(right)
        case _:
            raise ValueError
