"""The live link between real processes: relaying, take-over, garbage, floods."""

from __future__ import annotations

import json
import os
import queue
import signal
import socket
import stat
import subprocess
import sys
import threading
import time
import uuid
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from brdf_qt.link.address import LinkAddress, link_name, private_folder
from brdf_qt.link.messages import MAX_BYTES, encode

PROGRAM = Path(__file__).with_name("link_program.py")


class Program:
    """One real process on the link; what it prints is read in a thread."""

    def __init__(self, role: str) -> None:
        self.process = subprocess.Popen(
            [sys.executable, str(PROGRAM), role],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        self.events: list[dict[str, Any]] = []
        self.log: list[str] = []
        self._queue: queue.Queue[dict[str, Any]] = queue.Queue()
        self._threads = [threading.Thread(target=t, daemon=True) for t in (self._out, self._err)]
        for thread in self._threads:
            thread.start()
        self.hub = self.wait(lambda e: e["event"] == "ready")["hub"]

    def _out(self) -> None:
        for line in self.process.stdout:
            self._queue.put(json.loads(line))

    def _err(self) -> None:
        for line in self.process.stderr:
            self.log.append(line)

    def send_line(self, line: str) -> None:
        self.process.stdin.write(line + "\n")
        self.process.stdin.flush()

    def publish(self, n: int, topic: str = "paint", **more: object) -> None:
        self.send_line(f"publish {topic} {json.dumps({'n': n, **more})}")

    def wait(self, wanted: Callable[[dict[str, Any]], bool], seconds: float = 120) -> dict[str, Any]:
        """Return the first event from now on that is wanted."""
        end = time.monotonic() + seconds
        while True:
            try:
                event = self._queue.get(timeout=max(0.01, end - time.monotonic()))
            except queue.Empty:
                pytest.fail(f"nothing came; before: {self.events[-3:]}, log: {self.log[-5:]}")
            self.events.append(event)
            if wanted(event):
                return event

    def wait_log(self, word: str, seconds: float = 120) -> None:
        """Wait until a line of the log holds the word: it comes through another pipe than the events."""
        end = time.monotonic() + seconds
        while not any(word in line for line in list(self.log)):
            assert time.monotonic() < end, self.log[-5:]
            time.sleep(0.02)

    def wait_n(self, n: int, topic: str = "paint") -> None:
        self.wait(lambda e: e["event"] == "received" and e["topic"] == topic and e["value"]["n"] == n)

    def wait_peers(self, count: int) -> dict[str, Any]:
        return self.wait(lambda e: e["event"] == "peers" and e["count"] == count)

    def kill(self) -> None:
        os.kill(self.process.pid, signal.SIGKILL)
        self.process.wait()

    def end(self) -> None:
        if self.process.poll() is None:
            self.process.stdin.close()
            try:
                self.process.wait(60)
            except subprocess.TimeoutExpired:
                self.kill()
        for thread in self._threads:
            thread.join(60)
        for pipe in (self.process.stdin, self.process.stdout, self.process.stderr):
            if not pipe.closed:
                pipe.close()


@pytest.fixture
def start(monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[..., Program]]:
    monkeypatch.setenv("BRDF_SUITE_LINK", f"test-{uuid.uuid4().hex[:12]}")
    programs: list[Program] = []

    def starter(role: str) -> Program:
        programs.append(Program(role))
        return programs[-1]

    yield starter
    for program in programs:
        program.end()


def raw_socket() -> socket.socket:
    """A connection of a program that is none of ours."""
    connection = socket.socket(socket.AF_UNIX)
    connection.connect(LinkAddress(link_name()).socket_name)
    return connection


def test_a_paint_reaches_all_others_through_the_hub(start: Callable[..., Program]) -> None:
    hub, designer, viewer = start("viewer"), start("designer"), start("viewer")
    assert (hub.hub, designer.hub, viewer.hub) == (True, False, False)
    assert hub.wait_peers(2)["roles"] == ["designer", "viewer"]
    assert viewer.wait_peers(2)["roles"] == ["designer", "viewer"]
    designer.publish(7)
    hub.wait_n(7)
    viewer.wait_n(7)
    hub.publish(8)
    designer.wait_n(8)
    viewer.wait_n(8)
    assert not [e for e in designer.events if e["event"] == "received" and e["value"]["n"] == 7]


def test_a_newcomer_is_reported_the_newest_of_each_topic(start: Callable[..., Program]) -> None:
    hub, designer = start("viewer"), start("designer")
    for n in (1, 2, 3):
        designer.publish(n)
    hub.wait_n(3)
    hub.publish(9, "view")
    designer.wait_n(9, "view")
    newcomer = start("viewer")
    # Of two topics either may come first; both come, and nothing older.
    reported = [
        newcomer.wait(lambda e: e["event"] == "received")["value"]["n"] for _topic in ("paint", "view")
    ]
    assert sorted(reported) == [3, 9]


def test_another_takes_over_when_the_hub_is_killed(start: Callable[..., Program]) -> None:
    hub, designer, viewer = start("viewer"), start("designer"), start("viewer")
    designer.wait_peers(2)
    viewer.wait_peers(2)
    hub.publish(1)
    designer.wait_n(1)
    viewer.wait_n(1)
    hub.kill()
    designer.wait_peers(0)
    designer.publish(2)  # while there is no hub: must not be lost
    viewer.wait_n(2)
    designer.wait_peers(1)
    newcomer = start("viewer")
    newcomer.wait_n(2)
    viewer.publish(3)
    designer.wait_n(3)
    newcomer.wait_n(3)


def test_it_works_again_after_every_program_was_killed(start: Callable[..., Program]) -> None:
    first, second = start("designer"), start("viewer")
    second.wait_peers(1)
    first.kill()
    second.kill()
    third, fourth = start("designer"), start("viewer")
    assert third.hub
    third.publish(5)
    fourth.wait_n(5)


def test_what_a_restarted_program_publishes_wins_over_the_past(start: Callable[..., Program]) -> None:
    viewer, designer = start("viewer"), start("designer")
    for n in range(50):
        designer.publish(n)
    viewer.wait_n(49)
    designer.kill()
    viewer.wait_peers(0)
    again = start("designer")
    again.publish(100)
    viewer.wait_n(100)


def test_garbage_is_dropped_and_its_sender_cut_off(start: Callable[..., Program]) -> None:
    hub, viewer = start("designer"), start("viewer")
    viewer.wait_peers(1)
    lines = [
        b"\x00\xff\xfe garbage \x80",
        b"[" * 100_000,
        b'{"v":2}',
        b'{"v":1,"topic":"paint","value":{"n":1},"from":"x","seq":5}',
        b'{"v":2,"topic":"paint","value":{"n":1},"from":"x","seq":-5}',
        b'{"v":2,"topic":"paint","value":{"n":NaN},"from":"x","seq":5}',
        b'{"v":2,"topic":"rm -rf","value":{"n":1},"from":"x","seq":5}',
        b'{"v":2,"topic":"hello","value":{"role":17},"from":"x","seq":5}',
        b'{"v":2,"topic":"paint","value":[1],"from":"x","seq":5}',
    ]
    with raw_socket() as stranger:
        stranger.sendall(b"\n".join(lines) + b"\n")
        stranger.sendall(encode("paint", {"n": 77}, "stranger", 5).line)  # still heard
        viewer.wait_n(77)
    with raw_socket() as stranger:  # a well-formed envelope around a bad value hides no good value
        good, bad = encode("paint", {"n": 78}, "s", 6), encode("paint", {"n": "seventy"}, "t", 2**40)
        stranger.sendall(good.line + bad.line)
        viewer.wait_n(78)
    with raw_socket() as stranger:
        stranger.sendall(b"nonsense\n" * 200)
        stranger.settimeout(120)
        assert cut_off(stranger)
    with raw_socket() as stranger:
        stranger.settimeout(120)
        assert sends_until_cut_off(stranger, b"x" * 65536) <= 6 * MAX_BYTES
    hub.publish(5)
    viewer.wait_n(5)
    hub.wait_log("dropped")
    assert not any("Traceback" in line for line in hub.log + viewer.log)


def test_suites_of_two_versions_do_not_meet(start: Callable[..., Program]) -> None:
    """Version 1 listens at a socket of the link's own name, as suite 0.1.0 does; today's programs never call there."""
    with socket.socket(socket.AF_UNIX) as first_version:
        first_version.bind(str(private_folder() / f"{link_name()}.socket"))
        first_version.listen()
        first_version.setblocking(False)
        hub, viewer = start("designer"), start("viewer")
        assert (hub.hub, viewer.hub) == (True, False)
        hub.publish(4)
        viewer.wait_n(4)
        with pytest.raises(BlockingIOError):
            first_version.accept()
    with raw_socket() as stranger:
        stranger.sendall(b'{"v":1,"topic":"paint","value":{"n":6},"from":"x","seq":1795843200000}\n')
        hub.wait_log("version 1, this program knows 2")


def cut_off(stranger: socket.socket) -> bool:
    try:
        while stranger.recv(65536):
            pass
    except ConnectionResetError:
        pass
    return True


def sends_until_cut_off(stranger: socket.socket, block: bytes) -> int:
    sent = 0
    try:
        while True:
            stranger.sendall(block)
            sent += len(block)
    except (BrokenPipeError, ConnectionResetError):
        return sent


def test_a_flood_ends_with_the_newest_and_few_deliveries(start: Callable[..., Program]) -> None:
    hub, designer, viewer = start("viewer"), start("designer"), start("viewer")
    viewer.wait_peers(2)
    designer.send_line("flood paint 10000")
    viewer.wait_n(9999)
    hub.wait_n(9999)
    seen = [e["value"]["n"] for e in viewer.events if e["event"] == "received"]
    assert seen == sorted(seen)


def test_a_flood_through_a_raw_socket_is_coalesced(start: Callable[..., Program]) -> None:
    hub, viewer = start("designer"), start("viewer")
    viewer.wait_peers(1)
    with raw_socket() as stranger:
        stranger.sendall(b"".join(encode("paint", {"n": n}, "s", 1 + n).line for n in range(10_000)))
        viewer.wait_n(9999)
    seen = [e["value"]["n"] for e in viewer.events if e["event"] == "received"]
    assert len(seen) < 2_000
    assert seen == sorted(seen)
    assert hub.process.poll() is None


def test_a_program_that_never_reads_holds_up_no_one(start: Callable[..., Program]) -> None:
    hub, designer, viewer = start("viewer"), start("designer"), start("viewer")
    viewer.wait_peers(2)
    with raw_socket():
        for n in range(40):
            designer.publish(n, filling="y" * 100_000)
        viewer.wait_n(39)
    resident = Path(f"/proc/{hub.process.pid}/statm").read_text().split()[1]
    assert int(resident) * os.sysconf("SC_PAGE_SIZE") < 200e6


@pytest.mark.parametrize("seq", [2**48, 2**48 - 1, 10**12])
def test_a_number_from_the_future_switches_nothing_off(start: Callable[..., Program], seq: int) -> None:
    hub, viewer = start("designer"), start("viewer")
    viewer.wait_peers(1)
    with raw_socket() as stranger:
        stranger.sendall(encode("paint", {"n": 1}, "stranger", seq).line)
        stranger.sendall(encode("view", {"n": 2}, "stranger", 1).line)
        hub.wait_n(2, "view")  # so that the first one has been looked at
    for n in range(3, 6):
        hub.publish(n)
        viewer.wait_n(n)
        viewer.publish(n + 10)
        hub.wait_n(n + 10)
    hub.wait_log("ahead of the time")
    assert not any(e["event"] == "received" and e["value"]["n"] == 1 for e in viewer.events + hub.events)


def test_a_newcomer_is_served_while_others_flood_the_link(start: Callable[..., Program]) -> None:
    hub = start("designer")
    hub.publish(7, "view")
    ended = threading.Event()

    def flood() -> None:
        filling, n = "x" * 2000, 0
        with raw_socket() as stranger:
            while not ended.is_set():
                n += 1
                stranger.sendall(encode("paint", {"n": n, "filling": filling}, "flood", n).line)

    flooding = [threading.Thread(target=flood) for _ in range(2)]
    for thread in flooding:
        thread.start()
    try:
        hub.wait(lambda e: e["event"] == "received" and e["topic"] == "paint")
        newcomer = start("viewer")
        newcomer.wait_n(7, "view")
        hub.publish(8, "view")
        newcomer.wait_n(8, "view")
        assert all(thread.is_alive() for thread in flooding)
    finally:
        ended.set()
        for thread in flooding:
            thread.join()


def test_values_are_checked_on_another_thread_than_the_windows(qtbot, monkeypatch) -> None:
    from brdf_qt.link.link import LiveLink

    monkeypatch.setenv("BRDF_SUITE_LINK", f"test-{uuid.uuid4().hex[:12]}")
    threads: list[threading.Thread] = []
    links = [
        LiveLink(role, checks={"paint": lambda _: threads.append(threading.current_thread())})
        for role in ("designer", "viewer")
    ]
    for link in links:
        link.start()
    qtbot.waitUntil(lambda: len(links[0].peers) == 1)
    with qtbot.waitSignal(links[1].received) as received:
        links[0].publish("paint", {"n": 1})
    for link in links:
        link.close()
    assert received.args == ["paint", {"n": 1}]
    assert threads
    assert threading.main_thread() not in threads
    assert not any(thread.is_alive() for thread in threads)


def test_the_socket_is_for_this_user_alone(start: Callable[..., Program]) -> None:
    start("designer")
    assert stat.S_IMODE(private_folder().stat().st_mode) == 0o700
    assert stat.S_IMODE(Path(LinkAddress(link_name()).socket_name).stat().st_mode) & 0o077 == 0
    assert str(os.getuid()) in link_name()


def test_a_folder_that_others_can_enter_switches_the_link_off(tmp_path, monkeypatch, qtbot, caplog) -> None:
    from brdf_qt.link.link import LiveLink

    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path))
    private_folder().chmod(0o777)
    link = LiveLink("viewer", checks={})
    link.start()
    link.publish("paint", {"n": 1})
    assert not link.is_hub
    assert "other users" in caplog.text
    link.close()
