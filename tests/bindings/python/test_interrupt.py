# SPDX-License-Identifier: GPL-3.0-or-later
"""Long runs: Ctrl-C and exceptions cancel them soon, and other threads go on meanwhile."""

import os
import signal
import threading
import time
import unittest

import footfall
import scenes


class Interrupt(unittest.TestCase):
    def setUp(self):
        # Whoever started the tests may have signals ignored.
        self.addCleanup(signal.signal, signal.SIGINT, signal.signal(signal.SIGINT, signal.default_int_handler))
        # Some 20 s on two threads.
        self.vertices, self.triangles = scenes.slow(12000)

    def test_ctrl_c_cancels_within_50_ms(self):
        waits = []
        for delay in (0.2, 0.3, 0.4, 0.5, 0.6):
            pressed = []

            def press():
                pressed.append(time.monotonic())
                os.kill(os.getpid(), signal.SIGINT)

            timer = threading.Timer(delay, press)
            timer.start()
            with self.assertRaises(KeyboardInterrupt):
                footfall.walkable_area(self.vertices, self.triangles, height=0.5)
                timer.join()
            waits.append(time.monotonic() - pressed[0])
        # A machine that is busy with something else may be late, but not every time.
        self.assertLess(min(waits), 0.05, waits)
        self.assertLess(max(waits), 1, waits)

    def test_the_cache_keeps_what_was_finished(self):
        level, cache = footfall.Environment(self.vertices, self.triangles), footfall.ResultCache()
        steps = [("SlopeFilter", 45), ("VerticalClearanceFilter", 0.5)]

        def stop(step, name, fraction):
            if name == "VerticalClearanceFilter":
                raise KeyboardInterrupt

        with self.assertRaises(KeyboardInterrupt):
            footfall.run(level, steps, cache=cache, progress=stop)
        self.assertEqual(footfall.run(level, steps[:1], cache=cache).statistics()["start_ms"], 0)

    def test_what_progress_raises_cancels_and_arrives(self):
        class Enough(Exception):
            pass

        seen = []

        def stop(step, name, fraction):
            self.assertIs(threading.current_thread(), threading.main_thread())
            seen.append(name)
            raise Enough("that will do")

        start = time.monotonic()
        with self.assertRaisesRegex(Enough, "^that will do$"):
            footfall.walkable_area(self.vertices, self.triangles, height=0.5, progress=stop)
        self.assertLess(time.monotonic() - start, 1)
        self.assertEqual(len(seen), 1)

    def test_other_threads_go_on(self):
        done = threading.Event()
        turns = 0

        def count():
            nonlocal turns
            while not done.is_set():
                turns += 1
                time.sleep(0.001)

        counter = threading.Thread(target=count)
        counter.start()
        try:
            start = time.monotonic()
            with self.assertRaises(KeyboardInterrupt):
                threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT)).start()
                footfall.walkable_area(self.vertices, self.triangles, height=0.5)
            took = time.monotonic() - start
        finally:
            done.set()
            counter.join()
        self.assertGreater(took, 0.4)
        self.assertGreater(turns, 20)

    def test_runs_in_several_threads_give_the_same(self):
        level = footfall.Environment(*scenes.slow(60))
        expected = footfall.run(level).vertices
        results = [None] * 4

        def work(i):
            results[i] = footfall.run(level, threads=1 + i % 2).vertices

        threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertGreater(len(expected), 0)
        for result in results:
            self.assertEqual(result.tobytes(), expected.tobytes())


if __name__ == "__main__":
    unittest.main()
