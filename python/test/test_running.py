# Copyright (c) 2026 The Intrinsic_triangulations authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Threads, interruption, progress and memory. Nothing depends on how fast the machine is."""

import os
import signal
import subprocess
import sys
import threading
import time
import unittest

import numpy as np

import intrinsic
import support


class Enough(Exception):
    """Stops a call from its progress."""


def stop_at_once(stage, steps):
    raise Enough(stage)


class Progress(unittest.TestCase):
    def test_stages(self):
        V, F = intrinsic.shapes.folded_sphere(4)
        stages = []
        intrinsic.flatten(V, F, progress=lambda stage, steps: stages.append((stage, steps)))
        names = list(dict.fromkeys(stage for stage, _ in stages))
        self.assertEqual(names[:2], ["cones", "optimize"])
        self.assertIn("layout", names)

    def test_exceptions_leave_windows(self):
        V, F = intrinsic.shapes.folded_sphere(7)
        T = intrinsic.Triangulation(V, F)
        with self.assertRaisesRegex(Enough, "windows"):
            intrinsic.distance(T, None, 0, "exact", progress=stop_at_once)

    def test_exceptions_leave(self):
        V, F = intrinsic.shapes.folded_sphere(4)
        for call in (lambda: intrinsic.flatten(V, F, progress=stop_at_once),
                     lambda: intrinsic.to_sphere(V, F, progress=stop_at_once),
                     lambda: intrinsic.uniformize(V, F, progress=stop_at_once)):
            with self.assertRaises(Enough):
                call()

    def test_triangulations_stay_valid(self):
        V, F = support.turned(*intrinsic.shapes.torus(60, 40))
        T = intrinsic.Triangulation(V * [9, 1, 1], F)

        def stop(stage, steps):
            raise KeyboardInterrupt

        try:  # it is called some times a second: perhaps never
            T.refine(30, 0.05, max_insertions=20000, progress=stop)
            is_stopped = False
        except KeyboardInterrupt:
            is_stopped = True
        T.delaunay()
        self.assertTrue(T.is_delaunay() and T.certify().is_geodesic)
        self.assertTrue(is_stopped or T.n_vertices > len(V))

    def test_changes_by_progress_are_refused(self):
        V, F = intrinsic.shapes.torus(60, 40)
        T = intrinsic.Triangulation(V * [9, 1, 1], F)
        seen = []

        def change(stage, steps):
            seen.append(T.n_vertices)  # reading is allowed
            with self.assertRaises(intrinsic.InputError):
                T.delaunay()

        T.refine(25, 0.1, max_insertions=5000, progress=change)
        self.assertEqual(seen, sorted(seen))


class Interruption(unittest.TestCase):
    def test_signal(self):
        """A signal that comes while the compiled part works leaves it, at the next step."""

        def handler(number, frame):
            raise KeyboardInterrupt

        V, F = intrinsic.shapes.torus(60, 40)
        before = signal.signal(signal.SIGUSR1, handler)
        try:
            started = threading.Event()

            def progress(stage, steps):
                if not started.is_set():
                    started.set()
                    os.kill(os.getpid(), signal.SIGUSR1)

            with self.assertRaises(KeyboardInterrupt):
                intrinsic.flatten(V, F, progress=progress)
        finally:
            signal.signal(signal.SIGUSR1, before)

    def test_signal_during_exact_distances(self):
        """Exact distances and paths on a large surface end at the first look at the clock after
        a signal, which a timer of this process sends."""

        def handler(number, frame):
            raise KeyboardInterrupt

        V, F = intrinsic.shapes.folded_sphere(7)
        T = intrinsic.Triangulation(V, F)
        far = int(np.argmax(np.linalg.norm(V - V[0], axis=1)))
        solver = intrinsic.DistanceSolver(T, method="exact")
        before = signal.signal(signal.SIGALRM, handler)
        try:
            for call in (lambda: intrinsic.distance(T, None, 0, "exact"),
                         lambda: solver.distance(0),
                         lambda: solver.from_each([0, 1, 2]),
                         lambda: solver.from_each([0, 1, 2], parallel=True),
                         lambda: intrinsic.path(T, None, 0, far),
                         lambda: intrinsic.log_map(T, None, 0)):
                with self.assertRaises(KeyboardInterrupt):
                    signal.setitimer(signal.ITIMER_REAL, 0.1)
                    call()
                signal.setitimer(signal.ITIMER_REAL, 0)
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, before)


class Threads(unittest.TestCase):
    def test_other_threads_run(self):
        """The lock is released: another thread takes it while one is in the compiled part."""
        V, F = intrinsic.shapes.folded_sphere(5)
        inside, finished, counted = threading.Event(), threading.Event(), threading.Event()

        def count():
            while not finished.is_set():
                if inside.is_set():
                    counted.set()
                time.sleep(1e-4)  # gives the lock back

        interval = sys.getswitchinterval()
        other = threading.Thread(target=count)
        other.start()
        try:
            sys.setswitchinterval(1e9)  # this thread loses the lock only where it releases it
            for _ in range(1000):  # the other thread may be scheduled late
                T = intrinsic.Triangulation(V, F)
                inside.set()
                T.delaunay(exact=True)
                inside.clear()
                if counted.is_set():
                    break
        finally:
            finished.set()
            sys.setswitchinterval(interval)
        other.join()
        self.assertTrue(counted.is_set())

    def test_one_object_in_many_threads(self):
        V, F = support.turned(*intrinsic.shapes.torus(40, 20))
        T = intrinsic.Triangulation(V, F)
        errors = []

        def work(k):
            try:
                for _ in range(5):
                    if k % 3 == 0:
                        T.refine(20 + k)
                    elif k % 3 == 1:
                        T.common_subdivision()
                    else:
                        T.trace()
                        intrinsic.distance(T, None, 0)
            except Exception as error:
                errors.append(error)

        threads = [threading.Thread(target=work, args=(k,)) for k in range(6)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(errors, [])
        self.assertTrue(T.certify().is_delaunay)

    def test_same_results(self):
        V, F = intrinsic.shapes.folded_sphere(3)
        results = [None] * 4

        def work(k):
            results[k] = intrinsic.flatten(V, F).subdivision.image

        threads = [threading.Thread(target=work, args=(k,)) for k in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for image in results[1:]:
            np.testing.assert_array_equal(image, results[0])


MEMORY = """
import gc, resource, sys
import intrinsic
V, F = intrinsic.shapes.folded_sphere(2)
lengths = intrinsic.Triangulation(V, F).face_lengths

def once():
    T = intrinsic.Triangulation(V, F)
    T.refine(20)
    T.common_subdivision(), T.trace(), T.transfer(V[:, 0]), T.certify()
    intrinsic.laplacian(None, F, lengths=lengths), intrinsic.distance(V, F, 0, "heat")
    m = intrinsic.flatten(V, F)
    m.subdivision, m([0], [[1, 0, 0]])
    intrinsic.simplify(V, F, 30).prolongation
    try:
        intrinsic.flatten(V, F, progress=lambda *_: 1 / 0)
    except ZeroDivisionError:
        pass
    try:
        intrinsic.Triangulation(V * float("nan"), F)
    except intrinsic.InputError:
        pass

def peak():
    gc.collect()
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss

for _ in range(60):
    once()
before = peak()
for _ in range(125):
    once()
print(peak() - before)
"""


class Memory(unittest.TestCase):
    def test_thousand_calls(self):
        """In a loop of 125 rounds of eight calls, the peak, in KiB, does not grow: a copy of the
        surface that each round keeps would be more."""
        done = subprocess.run([sys.executable, "-c", MEMORY], capture_output=True, text=True,
                              check=True)
        self.assertLess(int(done.stdout), 6000)


if __name__ == "__main__":
    unittest.main()
