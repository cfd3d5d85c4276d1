"""When others end the program: signals of the system reach the window's event loop, which may finish what it must."""

import signal
import socket

from PySide6.QtCore import QObject, QSocketNotifier, Signal

_ENDS = tuple(getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP", "SIGBREAK") if hasattr(signal, name))


class EndSignals(QObject):
    """Tells which signal asks the program to end; a second one of the same kind ends it at once."""

    came = Signal(int)

    def __init__(self) -> None:
        super().__init__()
        # Python's own handlers run only when the event loop next meets Python; what is written here wakes it.
        self._read, self._written = socket.socketpair()
        self._read.setblocking(False)
        self._written.setblocking(False)
        self._notifier = QSocketNotifier(self._read.fileno(), QSocketNotifier.Type.Read, self)
        self._notifier.activated.connect(self._look)

    def watch(self) -> None:
        """Begin to tell; a signal that the program was started to ignore, as by nohup, stays ignored."""
        signal.set_wakeup_fd(self._written.fileno(), warn_on_full_buffer=False)
        for number in _ENDS:
            if signal.getsignal(number) is not signal.SIG_IGN:
                signal.signal(number, _leave_it_to_the_event_loop)

    def finish(self) -> None:
        """Tell no more; from now on a signal ends the program at once."""
        signal.set_wakeup_fd(-1)
        self._notifier.setEnabled(False)
        self._read.close()
        self._written.close()
        for number in _ENDS:
            if signal.getsignal(number) is _leave_it_to_the_event_loop:
                signal.signal(number, signal.SIG_DFL)

    def _look(self) -> None:
        for number in self._read.recv(64):
            if number in _ENDS:
                signal.signal(number, signal.SIG_DFL)
                self.came.emit(number)


def _leave_it_to_the_event_loop(_number: int, _frame: object) -> None:
    """Do nothing: the number is in the socket by now."""
