#!/usr/bin/env python3
"""The order of the strokes of a drawing: Strandline's tour beside what else is at hand.

    python3 compare_tours.py [DRAWING.svg] [--seconds 2]

Compared on the same lines and the same measure, straight rake-up metres from end to start:
nearest neighbour, greedy edges, both with 2-opt and Or-opt (all in NumPy, below), and two lower bounds that no
order can beat: the cheapest matching of line ends (networkx) and an assignment of them (scipy), each where it is
installed.
"""

import argparse
import pathlib
import time

import numpy as np

import strandline

HERE = pathlib.Path(__file__).resolve().parent


def open_lines(plan):
    """The strokes as open lines, (N, 2, 2): their first and last points. Closed ones are cut where they are
    entered, so that every solver has the same problem."""
    return np.array([[stroke.points[0], stroke.points[-1]] for stroke in plan.strokes])


def length(ends, order, turned):
    """Straight metres from each line's end to the next one's start."""
    driven = np.array([ends[k][::-1] if back else ends[k] for k, back in zip(order, turned)])
    return np.hypot(*(driven[1:, 0] - driven[:-1, 1]).T).sum()


def nearest_neighbour(ends, first=0):
    left = set(range(len(ends))) - {first}
    order, turned, at = [first], [False], ends[first][1]
    while left:
        candidates = np.array(sorted(left))
        away = np.hypot(*(ends[candidates] - at).transpose(2, 0, 1))
        k, side = np.unravel_index(np.argmin(away), away.shape)
        order.append(int(candidates[k]))
        turned.append(bool(side))
        left.remove(order[-1])
        at = ends[order[-1]][0 if side else 1]
    return order, turned


def greedy(ends):
    """The shortest joints first, each end used once, no rings; then the chains are walked."""
    n = len(ends)
    points = ends.reshape(-1, 2)
    away = np.hypot(*(points[:, None] - points[None]).transpose(2, 0, 1))
    root = list(range(n))

    def find(k):
        while root[k] != k:
            root[k] = root[root[k]]
            k = root[k]
        return k

    joined = {}
    for a, b in zip(*np.unravel_index(np.argsort(away, axis=None, kind="stable"), away.shape)):
        a, b = int(a), int(b)
        if a < b and a not in joined and b not in joined and find(a // 2) != find(b // 2):
            joined[a], joined[b] = b, a
            root[find(a // 2)] = find(b // 2)
            if len(joined) == 2 * (n - 1):
                break
    at = next(p for p in range(2 * n) if p not in joined)
    order, turned = [], []
    while at is not None:
        order.append(at // 2)
        turned.append(at % 2 == 1)
        at = joined.get(at ^ 1)
    return order, turned


def improved(ends, order, turned, seconds):
    """2-opt (a part of the order run backwards) and Or-opt (up to three lines put elsewhere), until neither
    gains or the time is up."""
    order, turned = list(order), list(turned)
    stop = time.perf_counter() + seconds

    def start(k):
        return ends[order[k]][1 if turned[k] else 0]

    def end(k):
        return ends[order[k]][0 if turned[k] else 1]

    def away(p, q):
        return float(np.hypot(*(p - q)))

    n = len(order)
    gained = True
    while gained and time.perf_counter() < stop:
        gained = False
        for i in range(n):
            for j in range(i, n):
                before = (away(end(i - 1), start(i)) if i else 0) + (away(end(j), start(j + 1)) if j + 1 < n else 0)
                after = (away(end(i - 1), end(j)) if i else 0) + (away(start(i), start(j + 1)) if j + 1 < n else 0)
                if after < before - 1e-9:
                    order[i:j + 1] = order[i:j + 1][::-1]
                    turned[i:j + 1] = [not back for back in turned[i:j + 1]][::-1]
                    gained = True
        now = length(ends, order, turned)
        for size in (1, 2, 3):
            for i in range(n - size + 1):
                part, part_turned = order[i:i + size], turned[i:i + size]
                rest, rest_turned = order[:i] + order[i + size:], turned[:i] + turned[i + size:]
                for j in range(0, len(rest) + 1, max(1, len(rest) // 60)):
                    other = rest[:j] + part + rest[j:], rest_turned[:j] + part_turned + rest_turned[j:]
                    if length(ends, *other) < now - 1e-9:
                        order, turned = other
                        now = length(ends, order, turned)
                        gained = True
                        break
                if time.perf_counter() > stop:
                    return order, turned
    return order, turned


#: networkx takes minutes for more.
MOST_MATCHED = 60


def matching_bound(ends):
    """Every order joins the lines' ends in pairs but for two: no order is shorter than the cheapest such pairs
    (networkx), where a line's own two ends are no pair."""
    import networkx

    graph = networkx.Graph()
    points = ends.reshape(-1, 2)
    for a in range(len(points)):
        graph.add_edge(a, "first", weight=0.0)
        graph.add_edge(a, "last", weight=0.0)
        for b in range(a + 1, len(points)):
            if a // 2 != b // 2:
                graph.add_edge(a, b, weight=float(np.hypot(*(points[a] - points[b]))))
    pairs = networkx.min_weight_matching(graph)
    return sum(graph.edges[pair]["weight"] for pair in pairs)


def assignment_bound(ends):
    """The same by scipy, looser and for many lines: half of what each end pays for a partner of its own."""
    from scipy.optimize import linear_sum_assignment

    points = ends.reshape(-1, 2)
    n = len(points)
    cost = np.zeros((n + 2, n + 2))
    cost[:n, :n] = np.hypot(*(points[:, None] - points[None]).transpose(2, 0, 1))
    own = np.arange(n)
    cost[own, own] = cost[own, own ^ 1] = np.inf
    cost[n:, n:] = np.inf
    cost[~np.isfinite(cost)] = 1e9
    rows, columns = linear_sum_assignment(cost)
    return cost[rows, columns].sum() / 2


def main():
    parser = argparse.ArgumentParser(description="tours of a drawing's strokes compared")
    parser.add_argument("drawing", nargs="?", default=HERE.parents[1] / "drawings" / "mandala.svg")
    parser.add_argument("--seconds", type=float, default=2, help="for 2-opt and Or-opt")
    arguments = parser.parse_args()

    plan = strandline.plan(arguments.drawing, tour_method="file", settings={"tour.inner_first": False})
    ends = open_lines(plan)
    print(f"{len(ends)} strokes of {plan.title}, straight rake-up metres")

    def row(name, make):
        begin = time.perf_counter()
        order, turned = make()
        took = time.perf_counter() - begin
        assert sorted(order) == list(range(len(ends)))
        print(f"  {name:<34} {length(ends, order, turned):9.3f}   {took:7.2f} s")

    row("as in the file", lambda: (range(len(ends)), [False] * len(ends)))
    row("nearest neighbour", lambda: nearest_neighbour(ends))
    row("greedy", lambda: greedy(ends))
    row("nearest neighbour, 2-opt, Or-opt", lambda: improved(ends, *nearest_neighbour(ends), arguments.seconds))
    row("greedy, 2-opt, Or-opt", lambda: improved(ends, *greedy(ends), arguments.seconds))
    proof = []

    def ours():
        tour = strandline.tour(list(ends))
        proof.append(" (proven optimal)" if tour.proven_optimal else "")
        return tour.order.tolist(), tour.reversed.tolist()

    row("strandline.tour", ours)
    print(f"  {'':<34} {proof[0]}" if proof[0] else "  no proof that this is the optimum")
    for name, bound, most in (("bound: matching (networkx)", matching_bound, MOST_MATCHED),
                              ("bound: assignment (scipy)", assignment_bound, 2000)):
        try:
            print(f"  {name:<34} " + (f"{bound(ends):9.3f}" if len(ends) <= most else f"not for over {most} strokes"))
        except ImportError as error:
            print(f"  {name:<34} not at hand: {error}")


if __name__ == "__main__":
    main()
