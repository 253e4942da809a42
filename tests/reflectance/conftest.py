"""The colours of the sixteen paints that the project starts from."""

from __future__ import annotations

import numpy as np
import pytest

# L*a*b* at 15, 45 and 110° with the light at 45°; the first eight follow published fits of measured paints.
COMPUTED = {
    "silver-metallic": ((108.6, 0.3, 1.5), (40.9, 0.4, 0.3), (8.7, 1.2, -2.1)),
    "silver-metallic2": ((101.9, 1.6, 6.4), (53.1, 0.1, 1.7), (33.4, -1.2, -1.9)),
    "blue-metallic": ((61.8, 16.7, -34.0), (22.3, 9.7, -18.1), (4.6, 7.8, -12.5)),
    "gold-metallic": ((87.8, 4.1, 44.0), (37.8, 2.1, 23.5), (13.6, 1.2, 14.5)),
    "gold-metallic3": ((75.2, 2.7, 24.7), (26.9, 1.3, 11.6), (9.9, 0.8, 6.7)),
    "green-metallic": ((68.2, -13.2, -7.5), (26.0, -10.2, -7.1), (17.0, -11.5, -8.5)),
    "red-metallic": ((43.4, 34.2, 25.3), (10.8, 15.4, 10.4), (2.3, 4.4, 2.2)),
    "pearl-paint": ((84.5, 0.7, 15.5), (54.9, 0.7, 8.0), (48.1, 0.7, 5.8)),
}
INVENTED = {
    "fine silver": ((128.0, -1.0, 0.5), (62.0, -0.8, -0.5), (36.0, -0.5, -2.0)),
    "champagne": ((115.0, 3.0, 22.0), (60.0, 3.0, 15.0), (34.0, 2.5, 10.0)),
    "dark grey": ((78.0, -0.5, -1.0), (28.0, -0.3, -2.0), (12.0, 0.0, -2.5)),
    "blue": ((62.0, -4.0, -45.0), (25.0, 4.0, -38.0), (9.0, 8.0, -28.0)),
    "red": ((58.0, 52.0, 32.0), (30.0, 44.0, 26.0), (16.0, 36.0, 20.0)),
    "copper": ((82.0, 38.0, 48.0), (45.0, 36.0, 42.0), (26.0, 30.0, 32.0)),
    "white pearl": ((104.0, -1.0, 4.0), (88.0, -1.0, 1.5), (84.0, -1.0, 2.0)),
    "violet shift": ((66.0, -8.0, -42.0), (24.0, 22.0, -36.0), (9.0, 18.0, -8.0)),
}


@pytest.fixture(scope="session")
def computed_labs() -> dict[str, np.ndarray]:
    return {name: np.array(labs) for name, labs in COMPUTED.items()}


@pytest.fixture(scope="session")
def invented_labs() -> dict[str, np.ndarray]:
    return {name: np.array(labs) for name, labs in INVENTED.items()}
