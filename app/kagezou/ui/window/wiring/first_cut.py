"""Who tells whom about the guided first cut: it begins with the demo, and every step is looked at when it is done."""

from PySide6.QtWidgets import QMainWindow, QVBoxLayout

from kagezou.export.exporters.exporter import ExportOutcome
from kagezou.ui.help.first_cut import FirstCut
from kagezou.ui.help.first_cut_bar import FirstCutBar
from kagezou.ui.project.demo import DemoOpener
from kagezou.ui.window.panel_layout import PanelLayout
from kagezou.ui.window.parts import Parts


def connect_first_cut(window: QMainWindow, parts: Parts, layout: PanelLayout) -> None:
    """Connect the guide, where there is a demo to be guided through; its bar stands over the picture."""
    if parts.demo is None:
        return
    guide, bridge = FirstCut(), parts.bridge
    bar = FirstCutBar(guide)
    guide.setParent(bar)
    middle = window.centralWidget()
    column = None if middle is None else middle.layout()
    assert isinstance(column, QVBoxLayout)
    column.insertWidget(0, bar)
    _begin_with_demo(parts, parts.demo, guide)
    bridge.history_changed.connect(lambda: guide.see(bridge.document))
    parts.exporting.ended.connect(lambda outcome: _see_export(parts, guide, outcome))
    bar.show_me.clicked.connect(lambda: _show_step(parts, guide, layout))
    bar.skip.clicked.connect(lambda: guide.skip(bridge.document))
    bar.leave.clicked.connect(guide.end)


def _begin_with_demo(parts: Parts, demo: DemoOpener, guide: FirstCut) -> None:
    wanted = False

    def ask() -> None:
        nonlocal wanted
        wanted = True
        demo.open()

    def follow_project() -> None:
        nonlocal wanted
        is_demo = parts.open_project.path == demo.project
        if wanted and is_demo:
            guide.begin(parts.bridge.document)
        elif not is_demo:
            guide.end()
        wanted = wanted and not is_demo

    parts.actions.on("first_cut", ask)
    parts.welcome.guide_asked.connect(ask)
    parts.open_project.path_changed.connect(follow_project)


def _see_export(parts: Parts, guide: FirstCut, outcome: ExportOutcome) -> None:
    if outcome.problem is None and not outcome.cancelled:
        guide.see_export(parts.bridge.document)


def _show_step(parts: Parts, guide: FirstCut, layout: PanelLayout) -> None:
    """Mark the rows of the properties that the step is about, as far as they mean something in this light."""
    if guide.step is None or not guide.step.about:
        return
    layout.show("inspector")
    rows = [parts.panels.inspector.row(prop.name) for prop in guide.step.about]
    parts.panels.inspector.reveal(row.address for row in rows if not row.label.isHidden())
