"""Many threads, many runs."""

import concurrent.futures
import gc
import os
import resource
import threading

import numpy as np

import turgor


def test_threads_get_the_bits_of_one(case):
    radii = [f"{k} mm" for k in range(10, 34)]

    def final(radius):
        changed = case.replace({"inlet.orifice_radius": radius, "solve.samples": 50})
        run = changed.run()
        return run.stretch.tobytes() + run.sol(np.linspace(0, 5, 20)).tobytes() + changed.statics().curve["R"].tobytes()

    alone = [final(radius) for radius in radii]
    with concurrent.futures.ThreadPoolExecutor(8) as pool:
        assert list(pool.map(final, radii)) == alone
        shared = case.run()
        views = list(pool.map(lambda _: shared.stretch.tobytes(), range(64)))
    assert set(views) == {shared.stretch.tobytes()}


def test_other_threads_run_meanwhile(case):
    """Python counts on while C++ computes: with the lock held, it could not."""
    slow = case.replace({"solve.rtol": 1e-12, "solve.t_end": "600 s", "pressure": {
        "harmonic": {"mean": "30 kPa", "amplitude": "3 kPa", "frequency": "3 Hz"}}})
    done = threading.Event()
    worker = threading.Thread(target=lambda: (slow.run(), done.set()))
    ticks = 0
    worker.start()
    while not done.wait(0.001):
        ticks += 1
    worker.join()
    assert ticks > 20


def grown(work, count):
    """Growth of the resident memory over `count` calls [bytes], after some to warm up."""
    def resident():
        gc.collect()
        with open("/proc/self/statm") as stream:
            return int(stream.read().split()[1]) * resource.getpagesize()

    for _ in range(count // 10):
        work()
    before = resident()
    for _ in range(count):
        work()
    return resident() - before


def test_nothing_leaks(tables):
    """A run holds some 20 kB: 2000 leaked ones would be 40 MB. TURGOR_LEAK_RUNS=100000 for the long version."""
    runs = int(os.environ.get("TURGOR_LEAK_RUNS", "2000"))
    case = turgor.Case(**tables | {"solve": {"t_end": "50 ms", "samples": 20}})

    def work():
        run = case.run()
        run.stretch, run.events, run.sol(0.01), run.quantities

    def fails():
        try:
            turgor.Case(**tables | {"inlet": {"orifice_radius": "3 kg"}})
        except turgor.InvalidInput:
            pass

    assert grown(work, runs) < 2e6
    assert grown(fails, 500) < 2e6
    assert grown(lambda: case.replace({"inlet.orifice_radius": "2 cm"}), 500) < 2e6
