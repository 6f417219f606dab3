"""What the package offers: thin wraps around the extension module, with small classes for results."""
import dataclasses
import os
import signal
import threading
from typing import Dict, List, NamedTuple, Optional, Tuple

import numpy

from . import _mwt, _picture


class Interval(NamedTuple):
    """A certified interval: the true value lies between its ends."""

    lower: float
    upper: float


@dataclasses.dataclass(frozen=True)
class Triangulation:
    """A checked triangulation of points, and what is known about it."""

    points: numpy.ndarray  #: float64, shape (n, 2)
    triangles: numpy.ndarray  #: uint32, shape (m, 3): rows of points, counter-clockwise; of equal points only the first is a corner
    weight: Interval  #: sum of the lengths of all edges, every edge once
    optimum: Optional[Interval]  #: of a minimum weight triangulation's weight, where the algorithm certifies it
    is_proved: bool  #: whether this is one of minimum weight, to 1e-12 of its weight
    stop_reason: Optional[str]  #: what stopped the algorithm early: deadline, memory, size, precision
    counters: Dict[str, float]  #: what the algorithm did, by name
    time_s: float  #: wall time of the algorithm alone

    def alpha(self, optimum: "Triangulation") -> Interval:
        """This weight over the optimum, rounded outwards. `optimum`: what solve() returned for the same points."""
        if optimum.optimum is None:
            raise ValueError("nothing is certified about this optimum; give what mwt.solve() returned")
        return Interval(*_mwt.alpha(self.weight, optimum.optimum))

    def edges(self) -> numpy.ndarray:
        """Every edge once, smaller end first, sorted: uint32, shape (k, 2)."""
        sides = numpy.concatenate([self.triangles[:, [0, 1]], self.triangles[:, [1, 2]], self.triangles[:, [2, 0]]])
        return numpy.unique(numpy.sort(sides, axis=1), axis=0)

    def _repr_svg_(self) -> str:
        return _picture.svg(self.points, self.edges())

    def __repr__(self) -> str:
        state = "proved" if self.is_proved else "bounded" if self.optimum else "not rated"
        return f"<Triangulation of {len(self.points)} points, weight {self.weight.upper:.6g}, optimum {state}>"


class Parameter(NamedTuple):
    name: str
    default: str
    summary: str


class Entry(NamedTuple):
    """An algorithm or a family of points."""

    name: str
    summary: str
    parameters: List[Parameter]


class Proof(NamedTuple):
    """What the verifier proves of a proof file."""

    optimum: Interval
    is_optimal: bool


def _as_points(points) -> numpy.ndarray:
    array = numpy.ascontiguousarray(points, dtype=numpy.float64)
    if array.ndim != 2 or array.shape[1] != 2:
        raise ValueError(f"points must be an array of shape (n, 2), not {array.shape}")
    return array


def _as_texts(parameters) -> Dict[str, str]:
    return {name: str(value).lower() if isinstance(value, bool) else str(value) for name, value in parameters.items()}


def _interruptible(work):
    """Calls work(interrupt) so that Ctrl-C ends it: in a thread of its own, if this is the main thread, which Python interrupts."""
    interrupt = _mwt.Interrupt()
    if threading.current_thread() is not threading.main_thread():
        return work(interrupt)
    outcome = []
    has_ended = threading.Event()  # joining does not do: Thread.join() takes a thread for ended when Ctrl-C interrupts it

    def run():
        try:
            outcome.append((work(interrupt), None))
        except BaseException as error:  # noqa: BLE001  (it is raised again in the thread that waits)
            outcome.append((None, error))
        has_ended.set()

    thread = threading.Thread(target=run, daemon=True)
    thread.start()
    try:
        while not has_ended.wait(0.1):  # Ctrl-C raises KeyboardInterrupt here
            pass
    except BaseException:
        interrupt.set()
        has_ended.wait()  # what it has found by then is dropped; a second Ctrl-C no longer waits for that
        raise
    thread.join()
    result, error = outcome[0]
    if error is not None:
        raise error
    return result


def _triangulation(points, answer) -> Triangulation:
    optimum = answer.pop("optimum")
    return Triangulation(
        points=points,
        weight=Interval(*answer.pop("weight")),
        optimum=None if optimum is None else Interval(*optimum),
        **answer,
    )


# Below this a triangulation takes less time than a thread for it.
_MIN_FOR_THREAD = 2000
_NEVER = _mwt.Interrupt()


def triangulate(points, algorithm: str = "greedy", *, seed: int = 1, threads: int = 1, time_limit: Optional[float] = None,
                **parameters) -> Triangulation:
    """A triangulation of the points by one algorithm (`mwt.algorithms()`).

    points      array-like of shape (n, 2), in any unit; they may repeat and be collinear
    time_limit  seconds; then the best triangulation so far is returned, with its stop_reason
    parameters  of the algorithm, such as k=14

    Deterministic, whatever the number of threads, unless the time limit stops it. Raises ValueError: fewer than three distinct
    points, all on one line, an unknown name, points that the algorithm does not take.
    """
    own = _as_points(points)
    texts = _as_texts(parameters)

    def work(interrupt):
        return _mwt.triangulate(own, algorithm, texts, seed, threads, time_limit, interrupt)

    return _triangulation(own, work(_NEVER) if len(own) < _MIN_FOR_THREAD else _interruptible(work))


def solve(points, proof: Optional[str] = None, *, threads: int = 1, time_limit: Optional[float] = None) -> Triangulation:
    """A minimum weight triangulation, with a certified interval for its weight.

    proof       file to write a proof to, for `mwt.verify()` and the program mwt_verify
    time_limit  seconds; then `optimum` has the bounds that are certified by then

    NP-hard in general; a million random points take seconds. Ctrl-C ends the computation, as it does in triangulate(). Raises as that.
    """
    own = _as_points(points)
    file = "" if proof is None else os.fspath(proof)
    return _triangulation(own, _interruptible(lambda interrupt: _mwt.solve(own, threads, time_limit, file, interrupt)))


def check(points, triangles) -> Optional[str]:
    """The first rule that the triangles (shape (m, 3), counter-clockwise) break as a triangulation of the points; None if they are
    one. Exact."""
    return _mwt.broken_rule(_as_points(points), _as_triangles(triangles))


def weight(points, triangles) -> Interval:
    """The certified sum of the lengths of all edges of a triangulation, every edge once."""
    return Interval(*_mwt.weight(_as_points(points), _as_triangles(triangles)))


def _as_triangles(triangles) -> numpy.ndarray:
    array = numpy.asarray(triangles)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"triangles must be an array of shape (m, 3), not {array.shape}")
    if array.size and (not numpy.issubdtype(array.dtype, numpy.integer) or array.min() < 0 or array.max() >= 2**32 - 1):
        raise ValueError("triangles must be rows of points: integers from 0")
    return numpy.ascontiguousarray(array, dtype=numpy.uint32)


def generate(family: str, n: int, *, seed: int = 1, **parameters) -> numpy.ndarray:
    """n points of a family (`mwt.families()`): float64, shape (n, 2). The same for the same seed on every machine."""
    return _mwt.generate(family, n, seed, _as_texts(parameters))


def read_points(file, columns: Optional[str] = None) -> numpy.ndarray:
    """The points of a file in any format that the program mwt reads: float64, shape (n, 2). `columns`, such as "lon,lat" or "3,4", chooses
    the columns of a table."""
    return _mwt.read_points(os.fspath(file), columns)


def verify(proof, points) -> Proof:
    """What a proof file proves about the points, by a verifier that shares no code with the solvers. ValueError: it is refused."""
    optimum, is_optimal = _mwt.verify_proof(os.fspath(proof), _as_points(points))
    return Proof(Interval(*optimum), is_optimal)


def _entries(raw) -> List[Entry]:
    return [Entry(name, summary, [Parameter(*parameter) for parameter in parameters]) for name, summary, parameters in raw]


def algorithms() -> List[Entry]:
    """All algorithms with their parameters."""
    return _entries(_mwt.algorithms())


def families() -> List[Entry]:
    """All families of points with their parameters."""
    return _entries(_mwt.families())
