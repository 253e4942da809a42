"""Weights by the view (``seen_weights``), found when first asked for: where that is, or on a thread."""

from __future__ import annotations

import logging
import threading
import weakref
from collections.abc import Callable

from brdf_suite.errors import FittingError
from brdf_suite.realtime.values import WeightsOverAngle
from brdf_suite.reflectance.protocol import Reflectance

REST_S = 0.05
"""How long no weights may have been asked for before any are found on the thread."""
_log = logging.getLogger(__name__)


class SeenWeights:
    """The weights of one reflectance, found when first asked for.

    ``later``: where given, it is called with this object to have :meth:`find` called on a thread, and until that is
    done ``found`` is None. Where they cannot be found, the log says why and there are none.
    """

    def __init__(
        self,
        reflectance: Reflectance,
        exponents: tuple[float, ...],
        later: Callable[[SeenWeights], None] | None = None,
    ) -> None:
        self.reflectance = reflectance
        self.exponents = exponents
        self._later = later
        self._begun = self._ended = False
        self.found: WeightsOverAngle | None = None

    @property
    def is_pending(self) -> bool:
        """Whether the weights were asked for and the search for them has not ended."""
        return self._begun and not self._ended

    def weights(self) -> WeightsOverAngle | None:
        """Return the weights, the same object from the first time on; None: not yet, or never."""
        if not self._begun:
            self._begun = True
            if self._later is None:
                self.find()
            else:
                self._later(self)
        return self.found

    def find(self) -> None:
        """Find the weights, in 20 ms for a designed paint and up to half a second for others."""
        # Most paints do not need it, and it would add 20 ms to the start of the Viewer.
        from brdf_suite.pipeline.seen_weights import seen_weights

        try:
            self.found = seen_weights(self.reflectance, self.exponents)
        except FittingError as error:
            _log.warning("The picture shows the fit of one incidence. %s", error)
        finally:
            self._ended = True


class SeenQueue:
    """Finds weights on one thread, the newest request first, and calls ``changed`` (on it) after each.

    A paint that is being edited asks for weights at every step: the work begins when no request has come for
    :data:`REST_S`, and what is no longer referenced by then, the paints of the steps between, is left out.
    """

    def __init__(self, changed: Callable[[], None]) -> None:
        self._changed = changed
        self._waiting: list[weakref.ref[SeenWeights]] = []
        self._asked = threading.Condition()
        self._running = self._closed = False

    def add(self, wanted: SeenWeights) -> None:
        """Have these weights found."""
        with self._asked:
            self._waiting.append(weakref.ref(wanted))
            self._asked.notify()
            if not self._running and not self._closed:
                self._running = True
                threading.Thread(target=self._run, name="weights by the view", daemon=True).start()

    def close(self) -> None:
        """Find nothing more."""
        with self._asked:
            self._closed = True
            self._waiting.clear()
            self._asked.notify()

    def _run(self) -> None:
        while True:
            with self._asked:
                while self._asked.wait(REST_S):
                    pass
                if not self._waiting:
                    self._running = False
                    return
                wanted = self._waiting.pop()()
            if wanted is not None:
                try:
                    wanted.find()
                    self._changed()
                except BaseException:  # ends this thread; the next request starts another
                    with self._asked:
                        self._running = False
                    raise
            del wanted
