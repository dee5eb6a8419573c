# Runs off the main thread. The newest request wins: it cancels the run before it.
# SPDX-License-Identifier: GPL-3.0-or-later
import threading


class Stopped(Exception):
    pass


class Job:
    """One run of a pipeline at a time. Everything but the run itself happens in the thread that calls these methods."""

    def __init__(self, footfall):
        self._footfall = footfall
        self._cache = footfall.ResultCache()
        self._thread = None
        self._stop = threading.Event()
        self._outcome = None
        self.fraction = 0.0
        self.step = ""

    @property
    def is_running(self):
        return self._thread is not None

    def start(self, environment, pipeline):
        self.cancel()
        self._stop = stop = threading.Event()
        self._outcome = outcome = {}
        self.fraction, self.step = 0.0, ""

        def progress(_number, name, fraction):
            if stop.is_set():
                raise Stopped
            self.step, self.fraction = name, fraction

        def work():
            try:
                outcome["area"] = self._footfall.run(environment, pipeline, cache=self._cache, progress=progress)
            except Stopped:
                pass
            except Exception as error:  # becomes a message in the panel
                outcome["error"] = str(error)

        self._thread = threading.Thread(target=work, name="footfall", daemon=True)
        self._thread.start()

    def cancel(self):
        """End the run, if there is one. It takes some 50 ms."""
        if self._thread is None:
            return
        self._stop.set()
        self._thread.join()
        self._thread = None

    def take(self, wait=False):
        """The outcome of a run that has ended, once: {"area": ...} or {"error": ...}; None while it goes on."""
        if self._thread is None:
            return None
        if wait:
            self._thread.join()
        if self._thread.is_alive():
            return None
        self._thread.join()
        self._thread = None
        return self._outcome
