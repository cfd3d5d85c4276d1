"""The program with a window: makes the application, its one window, and runs until that is closed."""

import signal
import sys
from collections.abc import Sequence
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QEvent, Qt
from PySide6.QtGui import QGuiApplication, QSurfaceFormat
from PySide6.QtWidgets import QApplication

from kagezou import __version__
from kagezou.ui.project.autosave import Autosave, left_behind
from kagezou.ui.project.demo import MakeDemo
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.project.recovery import RecoveryDialog
from kagezou.ui.system import theme
from kagezou.ui.system.clipboard import SystemClipboard
from kagezou.ui.system.icons import application_icon
from kagezou.ui.system.language import Language
from kagezou.ui.system.offscreen_context import surface_format
from kagezou.ui.system.settings import Settings
from kagezou.ui.system.unforeseen import UnforeseenErrors
from kagezou.ui.window.main_window import MainWindow


def run(project: Path | None, *, arguments: Sequence[str] = (), make_demo: MakeDemo | None = None) -> int:
    """Open the window, with a project if one is given, and return the exit code when it is closed.

    Parameters
    ----------
    project
        The project to open; one that cannot be opened is reported in the window.
    arguments
        What Qt itself may take from the command line, such as ``-platform``.
    make_demo
        Who makes the demo; without it none is offered.
    """
    application = make_application(arguments)
    incidents = UnforeseenErrors()
    incidents.watch()
    program = Application(application, Settings(), make_demo)
    incidents.happened.connect(program.say)
    # Whatever went wrong, the work so far is not to go with it.
    incidents.happened.connect(lambda _: program.autosave.keep())
    # Python's own handler would only run when the event loop next meets Python.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    program.show()
    if project is not None:
        program.window.parts.project.open_path(project)
    program.offer_recovery()
    code = application.exec()
    program.put_away()
    return code


def make_application(arguments: Sequence[str] = ()) -> QApplication:
    """Return the application, with everything set that must be set before it is made."""
    QSurfaceFormat.setDefaultFormat(surface_format())
    QGuiApplication.setHighDpiScaleFactorRoundingPolicy(Qt.HighDpiScaleFactorRoundingPolicy.PassThrough)
    QGuiApplication.setDesktopFileName("kagezou")
    application = QApplication([sys.argv[0] or "kagezou", *arguments])
    application.setApplicationName("Kagezou")
    application.setApplicationVersion(__version__)
    application.setWindowIcon(application_icon())
    theme.apply(application)
    return application


class Application:
    """The open_project and the window over it; another language means another window over the same open_project.

    Parameters
    ----------
    application
        The application.
    settings
        What is remembered.
    make_demo
        Who makes the demo, if anyone does.
    """

    def __init__(self, application: QApplication, settings: Settings, make_demo: MakeDemo | None = None) -> None:
        self._settings = settings
        self._make_demo = make_demo
        self._language = Language(application)
        self._language.speak(settings.language)
        self.open_project = OpenProject()
        self.window = self._make_window()
        self.autosave = Autosave(
            self.open_project, settings.recovery_folder, lambda: self.window.parts.project.project_name
        )
        self.autosave.failed.connect(lambda sentence: self.window.parts.bar.say("autosave", sentence))

    def show(self) -> None:
        """Bring the window to the screen."""
        self.window.show()

    def say(self, sentence: str) -> None:
        """Say what went wrong, in the window."""
        self.window.parts.bar.say("incident", sentence)

    def offer_recovery(self) -> None:
        """Ask about work that a program put aside and did not come back for, if there is any."""
        files = left_behind(self._settings.recovery_folder)
        if files:
            dialog = RecoveryDialog(files, self.window)
            dialog.recovered.connect(self.window.parts.project.recover)
            dialog.failed.connect(self.say)
            dialog.open()

    def put_away(self) -> None:
        """Destroy the window before the application goes, with everything that needs it."""
        self.autosave.finish()
        self.window.close_unasked()
        self.window.deleteLater()
        QCoreApplication.sendPostedEvents(self.window, QEvent.Type.DeferredDelete)
        self._language.fall_silent()

    def speak(self, code: str) -> None:
        """Change the language: the window is made anew, the open project stays."""
        if self.window.parts.exporting.is_running:
            self.window.parts.exporting.say_running()
            return
        self._settings.language = code
        self._language.speak(code)
        old = self.window
        # For a moment there is no window, which must not end the program; closing is what remembers the layout.
        QGuiApplication.setQuitOnLastWindowClosed(False)
        old.close_unasked()
        self.window = self._make_window()
        self.window.show()
        QGuiApplication.setQuitOnLastWindowClosed(True)
        old.deleteLater()

    def _make_window(self) -> MainWindow:
        window = MainWindow(self.open_project, self._settings, SystemClipboard(), self._make_demo)
        window.language_chosen.connect(self.speak)
        return window
