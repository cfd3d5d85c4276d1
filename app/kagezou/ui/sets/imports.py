"""Imported sets in the window: one is put into the picture at once, and a bar settles what its file leaves open."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QPushButton

from kagezou.document.address import Address
from kagezou.document.edits import set_canvas, set_constant
from kagezou.document.model import Document, Piece
from kagezou.document.properties import GROUND_POSITION
from kagezou.document.set_pieces import TAKEN_NAME
from kagezou.document.set_properties import PIECE_UP
from kagezou.document.values import value_at
from kagezou.errors import Problem, UsageProblem
from kagezou.geometry.set_camera import SetCamera
from kagezou.geometry.vectors import Point2, Vector3
from kagezou.importing.imported_sets import SetImport, import_set, point_under, stand_at
from kagezou.importing.set_following import follow_camera
from kagezou.importing.set_placing import of_piece
from kagezou.importing.set_sizing import FIGURE_METRES, sized
from kagezou.io.sets.cameras import cameras_of
from kagezou.io.sets.mesh_cache import MeshCache
from kagezou.ui.sets.import_bar import KEEP_VIEW, Measure, SetBar
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.waiting import waiting
from kagezou.ui.system.words import translated
from kagezou.ui.widgets.picking import Picking

_FOOT_OF_HEIGHT = 0.8
"""Where one stands on a canvas without characters."""


@dataclass(frozen=True, slots=True)
class _Settled:
    """The set that the bar is about.

    Parameters
    ----------
    piece_id, path
        The piece and its file.
    cameras
        Those of the file.
    camera, up
        What is chosen.
    base, made
        The document before the import and the one it made: while that is still the present one, other choices import
        anew instead of changing what is there.
    """

    piece_id: str
    path: Path
    cameras: tuple[SetCamera, ...]
    camera: int = KEEP_VIEW
    up: str | None = None
    base: Document | None = None
    made: Document | None = None


class SetImports(QObject):
    """Brings sets in and settles them.

    Parameters
    ----------
    bridge
        The session.
    meshes
        The sets that are read already.
    bar
        The choices.
    picking
        Who says which place of the picture was clicked.
    """

    failed = Signal(str)
    """Why something cannot be done; empty once it could."""
    noted = Signal(str)

    def __init__(self, bridge: Bridge, meshes: MeshCache, bar: SetBar, picking: Picking) -> None:
        super().__init__()
        self._bridge, self._meshes = bridge, meshes
        self._bar = bar
        self._picking = picking
        self._settled: _Settled | None = None
        self._points: tuple[tuple[Point2, Vector3], ...] = ()
        bar.camera_chosen.connect(self._choose_camera)
        bar.up_chosen.connect(self._choose_up)
        bar.standing.connect(self._begin_standing)
        bar.sizing.connect(self._begin_sizing)
        bar.length_entered.connect(self._size)
        bar.closed.connect(self.close)
        picking.picked.connect(self._take)
        picking.stopped.connect(self._stop_picking)
        bridge.document_changed.connect(self._follow)
        bridge.session_replaced.connect(self.close)

    def bring(self, path: Path, cameras: tuple[SetCamera, ...]) -> None:
        """Put the set of a file into the picture, seen by its first camera where it has one."""
        self._try(lambda: self._bring(path, cameras))

    def settle(self) -> None:
        """Show the bar for the set worked on, or for the last there is."""
        sets = [each for each in self._bridge.document.pieces if each.source is not None]
        # The one worked on, else the last.
        piece = max(reversed(sets), key=lambda each: each.id == self._bridge.piece_id, default=None)
        if piece is None or piece.source is None:
            self.failed.emit(self.tr("There is no set from a file in this project"))
            return
        path, piece_id = piece.source, piece.id
        up = value_at(piece.tracks, PIECE_UP, 1)

        def read() -> None:
            cameras = cameras_of(path, self._bridge.document.canvas.frame_rate)
            self._settled = _Settled(piece_id, path, cameras, up=up)
            self._show_bar()

        self._try(read)

    def close(self) -> None:
        """Put the bar away."""
        self._stop_picking()
        self._settled = None
        self._bar.hide()

    def _bring(self, path: Path, cameras: tuple[SetCamera, ...]) -> None:
        base = self._bridge.document
        if self._bridge.document.is_blank and cameras:
            longest = max(camera.length_frames for camera in cameras)
            base = set_canvas(base, replace(base.canvas, length_frames=max(base.canvas.length_frames, longest)))
        if not base.layers:
            stand = (base.canvas.width_px / 2, _FOOT_OF_HEIGHT * base.canvas.height_px)
            base = set_constant(base, Address(GROUND_POSITION), stand)
        wanted = _Settled("", path, cameras, 0 if cameras else KEEP_VIEW, base=base)
        try:
            self._import(wanted)
        except UsageProblem as problem:
            # A camera that cannot be followed does not keep the set away.
            if not cameras:
                raise
            self._import(replace(wanted, camera=KEEP_VIEW))
            self.noted.emit(translated(problem))

    def _import(self, wanted: _Settled) -> None:
        """Make the choices of an import the present document, as one step, whatever was chosen before."""
        assert wanted.base is not None
        session, before = self._bridge.session, self._settled
        camera = None if wanted.camera == KEEP_VIEW else wanted.cameras[wanted.camera].name
        how = SetImport(wanted.path, _name_of(wanted.path), camera, up=wanted.up)
        imported = import_set(wanted.base, how, self._meshes)
        if before is not None and before.made is session.document and before.base is wanted.base:
            session.undo()
        # The bar's set is the new one before the document is: what listens to it looks whether it is still there.
        up = value_at(imported.document.piece(imported.piece_id).tracks, PIECE_UP, 1)
        self._settled = replace(wanted, piece_id=imported.piece_id, up=up, made=imported.document)
        with session.gesture(self.tr("Import set")) as gesture:
            gesture.show(imported.document)
            # Chosen within the step, so that redo brings it back chosen.
            session.select_piece(imported.piece_id)
        for note in imported.notes:
            self.noted.emit(translated(note))
        self._show_bar()

    def _choose_camera(self, number: int) -> None:
        self._try(lambda: self._choose(camera=number))

    def _choose_up(self, up: str) -> None:
        self._try(lambda: self._choose(up=up))

    def _choose(self, *, camera: int | None = None, up: str | None = None) -> None:
        settled, session = self._settled, self._bridge.session
        if settled is None:
            return
        self._stop_picking()
        wanted = replace(settled, camera=settled.camera if camera is None else camera, up=up or settled.up)
        if settled.made is session.document:
            self._import(wanted)
            return
        document = set_constant(session.document, of_piece(PIECE_UP, settled.piece_id), wanted.up)
        if wanted.camera != KEEP_VIEW:
            document = follow_camera(document, settled.piece_id, wanted.cameras[wanted.camera])
        self._settled = replace(wanted, base=None, made=None)
        session.edit(self.tr("Settle set"), document)
        self._show_bar()

    def _begin_standing(self, on: bool) -> None:
        self._begin(on, self._bar.stand, self.tr("Click where the character's feet are on the set. Esc ends it."))

    def _begin_sizing(self, on: bool) -> None:
        words = self.tr("Click two points of the set whose distance you know. Esc ends it.")
        self._begin(on, self._bar.size_by_points, words)

    def _begin(self, on: bool, switch: QPushButton, words: str) -> None:
        self._stop_picking()
        if not on:
            return
        self._bar.hold(switch)
        self._picking.turn(on=True)
        self._bar.say(words)

    def _take(self, place: Point2) -> None:
        self._try(lambda: self._take_place(place))

    def _take_place(self, place: Point2) -> None:
        settled, bridge = self._settled, self._bridge
        if settled is None:
            return
        mesh = self._meshes.mesh(settled.path)
        point = point_under(bridge.document, settled.piece_id, mesh, place, bridge.frame)
        if point is None:
            self._bar.say(self.tr("There is nothing of the set at that place; click another. Esc ends it."))
        elif self._bar.stand.isChecked():
            bridge.session.edit(self.tr("Stand on the set"), stand_at(bridge.document, settled.piece_id, point))
            self._stop_picking()
        elif len(self._points) < 2:
            self._points = (*self._points, (place, point))
            self._bar.say(self.tr("Now the other point. Esc ends it."))
            self._picking.mark(tuple(each for each, _ in self._points))
            self._bar.show_length(shown=len(self._points) == 2)

    def _size(self, length: float, measure: str) -> None:
        settled, bridge = self._settled, self._bridge
        if settled is None or len(self._points) < 2:
            return
        (_, first), (_, second) = self._points
        heights = length / FIGURE_METRES if measure == Measure.METRES else length

        def size() -> None:
            document = sized(bridge.document, settled.piece_id, (first, second), heights, bridge.frame)
            bridge.session.edit(self.tr("Size of the set"), document)
            self._stop_picking()

        self._try(size)

    def _stop_picking(self) -> None:
        self._points = ()
        self._picking.turn(on=False)
        self._bar.release()
        self._bar.show_length(shown=False)
        self._bar.say("")

    def _follow(self) -> None:
        if self._settled is not None and _piece_of(self._bridge.document, self._settled) is None:
            self.close()

    def _show_bar(self) -> None:
        settled, piece = self._settled, _piece_of(self._bridge.document, self._settled)
        if settled is not None and piece is not None:
            names = [camera.name for camera in settled.cameras]
            self._bar.show_set(piece.name, names, settled.camera, settled.up or "y")

    def _try(self, do: Callable[[], None]) -> None:
        try:
            with waiting():
                do()
        except Problem as problem:
            self.failed.emit(translated(problem))
            self._show_bar()
        else:
            self.failed.emit("")


def _piece_of(document: Document, settled: _Settled | None) -> Piece | None:
    """Return the piece that is settled, if it is still there."""
    return next((piece for piece in document.pieces if settled is not None and piece.id == settled.piece_id), None)


def _name_of(path: Path) -> str:
    name = "".join(letter for letter in path.stem if letter.isprintable())[:100].strip()
    return "set" if name in ("", TAKEN_NAME) else name
