"""The exceptions of the package that Python has not already."""

from __future__ import annotations


class MeshError(ValueError):
    """An item of a mesh, or its value, is wrong.

    Attributes
    ----------
    vertex, triangle, edge, tetrahedron : int or None
        The number of what is wrong, from 0, as in the arrays that were handed in; None for the others.
    face : int or None
        The same as `triangle`.
    """

    def __init__(self, message: str, item: str | None = None, number: int | None = None) -> None:
        super().__init__(message, item, number)
        self.vertex = number if item == "vertex" else None
        self.triangle = self.face = number if item == "triangle" else None
        self.edge = number if item == "edge" else None
        self.tetrahedron = number if item == "tetrahedron" else None

    def __str__(self) -> str:
        return str(self.args[0])


class NumberError(IndexError, ValueError):
    """There is no node or arc of this number."""


class StoppedError(RuntimeError):
    """The function that was given as `progress` has returned False."""
