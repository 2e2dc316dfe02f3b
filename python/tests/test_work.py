"""Long work: the GIL is free, progress is told, a callback or Ctrl-C ends it."""

import os
import signal
import threading
import time

import numpy as np
import pytest

import strandline


def test_progress_is_told_in_the_calling_thread(drawings):
    told, threads = [], set()

    def progress(what, share):
        told.append((what, share))
        threads.add(threading.current_thread())

    strandline.plan(drawings / "starfish.svg", progress=progress)
    assert len({what for what, _ in told}) > 1
    assert all(0 <= share <= 1 for _, share in told)
    assert threads == {threading.main_thread()}


def test_an_exception_in_the_callback_ends_the_work(drawings):
    class Enough(Exception):
        pass

    def progress(what, share):
        raise Enough(what)

    with pytest.raises(Enough):
        strandline.plan(drawings / "mandala.svg", progress=progress)


def test_a_callback_that_returns_false_keeps_the_best_so_far(drawings):
    plan = strandline.plan(drawings / "mandala.svg", progress=lambda what, share: False)
    assert not plan.figures["reproducible"] and plan.figures["strokes"] > 10


def test_so_does_one_that_returns_the_false_of_numpy(drawings):
    plan = strandline.plan(drawings / "mandala.svg", progress=lambda what, share: np.float64(share) < 0)
    assert not plan.figures["reproducible"]
    for go_on in (lambda what, share: np.float64(share) >= 0, lambda what, share: None, lambda what, share: 0):
        assert strandline.plan(drawings / "hello.svg", progress=go_on).figures["reproducible"]


def test_ctrl_c_ends_the_work(drawings):
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        # Longer than the timer, however fast the machine.
        strandline.plan(drawings / "mandala.svg", tour_moves=100_000_000)
    timer.join()


def test_other_threads_run_meanwhile(drawings):
    counted, stop = [0], threading.Event()

    def count():
        while not stop.is_set():
            counted[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    strandline.plan(drawings / "starfish.svg")
    stop.set()
    thread.join()
    # Under a held GIL it would have counted once or twice.
    assert counted[0] > 20


def test_two_plans_at_once_are_the_two_plans(drawings, small):
    from conftest import SMALL
    results = {}

    def work(name):
        results[name] = strandline.plan_svg(SMALL, title="small.svg").export("csv")

    threads = [threading.Thread(target=work, args=(k,)) for k in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert results[0] == results[1] == small.export("csv")


def test_edits_of_one_plan_from_two_threads_wait_for_each_other(small):
    results = {}

    def work(style):
        results[style] = small.edited(fill_style=style)

    threads = [threading.Thread(target=work, args=(style,)) for style in ("zigzag", "spiral")]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert {style: plan.settings["fill.style"] for style, plan in results.items()} == {
        "zigzag": "zigzag", "spiral": "spiral"}
