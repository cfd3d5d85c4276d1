"""The program with a window: makes the application, its one window, and runs until that is closed."""

import sys
from collections.abc import Sequence
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QEvent, Qt, qVersion
from PySide6.QtGui import QGuiApplication, QSurfaceFormat
from PySide6.QtWidgets import QApplication

from kagezou.document.model import Document
from kagezou.io.files.crash_reports import left_by_dead
from kagezou.io.project.recovery_file import RecoveredWork
from kagezou.ui.project.autosave import Autosave
from kagezou.ui.project.demo import MakeDemo
from kagezou.ui.project.keepsakes import left_behind
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.project.recovery import RecoveryDialog
from kagezou.ui.project.saving import is_saved_by_now
from kagezou.ui.system import theme
from kagezou.ui.system.clipboard import SystemClipboard
from kagezou.ui.system.ending import EndSignals
from kagezou.ui.system.giving_back import GivingBack
from kagezou.ui.system.icons import application_icon
from kagezou.ui.system.language import Language
from kagezou.ui.system.listeners import forget_listeners, senders_within
from kagezou.ui.system.offscreen_context import surface_format
from kagezou.ui.system.opened_files import OpenedFiles
from kagezou.ui.system.settings import Settings
from kagezou.ui.system.unforeseen import UnforeseenErrors, log
from kagezou.ui.widgets.message_bar import Severity
from kagezou.ui.window.main_window import MainWindow
from kagezou.ui.window.wiring.crashes import say_incident, say_last_end
from kagezou.version import __version__

_KEEPING = "autosave"
_RECOVERED = "recovered"


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
    incidents.about = program.about_now
    incidents.happened.connect(lambda sentence: say_incident(program.window.parts, sentence, incidents.report))
    # Whatever went wrong, the work so far is not to go with it.
    incidents.happened.connect(lambda _: program.keep_after_incident())
    ends = EndSignals()
    ends.came.connect(program.end)
    ends.watch()
    if sys.platform == "darwin":
        # Elsewhere files come by the command line, and who looks at every event would slow down all of them.
        files = OpenedFiles(application)
        files.came.connect(program.open)
    application.commitDataRequest.connect(program.be_ended)
    application.saveStateRequest.connect(lambda _: program.keep())
    program.show()
    if project is not None:
        program.window.parts.project.open_path(project)
    for report in left_by_dead()[:1]:
        say_last_end(program.window.parts, report)
    program.offer_recovery()
    code = application.exec()
    program.put_away()
    ends.finish()
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
        self._left: Document | None = None
        self.autosave = Autosave(
            self.open_project,
            settings.recovery_folder,
            lambda: self.window.parts.project.project_name,
            settings.spare_recovery_folder,
        )
        self.autosave.failed.connect(lambda sentence: self._say_of_keeping(sentence, Severity.ERROR))
        self.autosave.kept_elsewhere.connect(lambda sentence: self._say_of_keeping(sentence, Severity.WARNING))
        self.autosave.kept.connect(lambda: self.window.parts.bar.withdraw(_KEEPING))
        self._giving_back = GivingBack()

    def show(self) -> None:
        """Bring the window to the screen."""
        self.window.show()

    def say(self, sentence: str) -> None:
        """Say what went wrong, in the window."""
        self.window.parts.bar.say("incident", sentence)

    def keep_after_incident(self) -> None:
        """Put the work aside, and write down beside what went wrong where it lies."""
        self.autosave.keep()
        log.info("unsaved work is kept in %s", self.autosave.file)

    def about_now(self) -> list[str]:
        """Return what a report of a crash says of the work and of what draws it."""
        return [
            f"Qt {qVersion()}, graphics: {self.window.parts.viewport.device or 'none'}",
            f"unsaved work is kept in: {self.autosave.file}",
        ]

    def offer_recovery(self) -> None:
        """Ask about work that a program put aside and did not come back for, if there is any."""
        files = left_behind(self._settings.recovery_folder, self._settings.spare_recovery_folder)
        if files:
            dialog = RecoveryDialog(files, self.window)
            dialog.recovered.connect(self._recover)
            dialog.failed.connect(self.say)
            dialog.open()

    def open(self, path: Path) -> None:
        """Open what the desktop hands over, unless what is open is not to be left."""
        self.window.parts.project.bring([path])
        self.window.activateWindow()

    def keep(self) -> None:
        """Put unsaved work aside, and wait until it lies there."""
        self.autosave.keep()
        self.autosave.wait()

    def end(self, number: int) -> None:
        """End because a signal of the system says so: nobody is asked, and unsaved work is found at the next start."""
        self.be_ended()
        QCoreApplication.exit(128 + number)

    def be_ended(self, _manager: object = None) -> None:
        """Be ready to be ended from outside, as at logout: the work is kept, and no question holds anybody up."""
        self.keep()
        # Whoever goes on after a logout that was called off is asked again when closing.
        self._left = self.open_project.bridge.document
        self.window.close_without_question(self._left)

    def put_away(self) -> None:
        """Destroy the window before the application goes, with everything that needs it."""
        self.autosave.finish(leave=self._left is self.open_project.bridge.document)
        self.window.close_unasked()
        self.window.deleteLater()
        QCoreApplication.sendPostedEvents(self.window, QEvent.Type.DeferredDelete)
        self._language.fall_silent()

    def speak(self, code: str) -> None:
        """Change the language: the window is made anew, the open project stays."""
        if self.window.parts.exporting.is_running:
            self.window.parts.exporting.say_running()
            return
        saving = self.window.parts.project.saving
        if not is_saved_by_now(saving, self.window) and saving.is_running:
            return
        self._settings.language = code
        self._language.speak(code)
        old = self.window
        # For a moment there is no window, which must not end the program; closing is what remembers the layout.
        QGuiApplication.setQuitOnLastWindowClosed(False)
        old.close_unasked()
        outliving = (self.open_project, self.open_project.bridge)
        forget_listeners((*outliving, *senders_within(old.parts, beside=outliving)))
        self.autosave.listen()
        self.window = self._make_window()
        self.window.show()
        QGuiApplication.setQuitOnLastWindowClosed(True)
        old.deleteLater()

    def _recover(self, work: RecoveredWork, file: Path) -> None:
        is_behind = work.is_behind
        if not self.window.parts.project.recover(work):
            return
        self.autosave.adopt(file)
        if is_behind and work.path is not None:
            words = QCoreApplication.translate(
                "Application", "“%1” was saved after this work began from it. Saving asks which of them stays."
            )
            self.window.parts.bar.say(_RECOVERED, words.replace("%1", work.path.name), Severity.WARNING)

    def _say_of_keeping(self, sentence: str, severity: Severity) -> None:
        self.window.parts.bar.say(_KEEPING, sentence, severity)

    def _make_window(self) -> MainWindow:
        window = MainWindow(self.open_project, self._settings, SystemClipboard(), self._make_demo)
        window.language_chosen.connect(self.speak)
        return window
