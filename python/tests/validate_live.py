"""Watch a run over its web socket as viewers do, and hold what comes against its recording.

    python validate_live.py PELLETFLOW

Needs `websockets`, `mcap` and `mcap-protobuf-support`. Exits with 1 when a promise is broken.
"""

from __future__ import annotations

import base64
import json
import re
import struct
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

from mcap.reader import make_reader
from mcap_protobuf.decoder import DecoderFactory
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection, connect

SUBPROTOCOL = "foxglove.sdk.v1"
# Operation, subscription and log time [ns] before a message.
HEAD = struct.Struct("<BIQ")
MESSAGE = 1
# Operation before a time [ns].
CLOCK = 2
# What is followed; the number of a topic here is that of its subscription.
TOPICS = ["/pellets", "/equipment", "/tf"]
# No more than this is waited for the next word [s]; the machine may be busy with other work.
PATIENCE = 120.0


class Broken(Exception):
    """A promise that a run breaks."""


def expect(condition: bool, message: str) -> None:
    if not condition:
        raise Broken(message)


def told(viewer: ClientConnection, kind: str) -> dict[str, Any]:
    """The next word of a kind."""
    while True:
        word = viewer.recv(timeout=PATIENCE)
        if isinstance(word, str):
            content: dict[str, Any] = json.loads(word)
            if content["op"] == kind:
                return content


def watched(address: str) -> dict[str, dict[int, bytes]]:
    """Messages by topic and time, until the run is over."""
    messages: dict[str, dict[int, bytes]] = {topic: {} for topic in TOPICS}
    with connect(address, subprotocols=[SUBPROTOCOL], max_size=None) as viewer:  # type: ignore[list-item]
        expect(viewer.subprotocol == SUBPROTOCOL, f"it speaks {viewer.subprotocol}")
        capabilities = told(viewer, "serverInfo")["capabilities"]
        expect(capabilities == ["time"], "a viewer may do more than watch, or has no clock")
        waiting = set(TOPICS)
        clock = 0
        try:
            while True:
                word = viewer.recv(timeout=PATIENCE)
                if isinstance(word, bytes):
                    if word[0] == CLOCK:
                        (now,) = struct.unpack_from("<Q", word, 1)
                        expect(now >= clock, f"the clock goes back to {now} ns")
                        clock = now
                        continue
                    operation, topic, time = HEAD.unpack_from(word)
                    expect(operation == MESSAGE, f"operation {operation}")
                    before = messages[TOPICS[topic]]
                    # The last message before the subscription may come twice.
                    expect(
                        time >= max(before, default=0), f"{TOPICS[topic]} goes back to {time} ns"
                    )
                    before[time] = word[HEAD.size :]
                    continue
                content = json.loads(word)
                for channel in content["channels"] if content["op"] == "advertise" else []:
                    if channel["topic"] in waiting:
                        waiting.remove(channel["topic"])
                        subscribe(viewer, channel)
        except ConnectionClosed:
            last = max(messages["/pellets"], default=0)
            expect(clock == last, f"the clock ends at {clock} ns, the run at {last} ns")
            return messages


def subscribe(viewer: ClientConnection, channel: dict[str, Any]) -> None:
    topic = channel["topic"]
    expect(channel["encoding"] == "protobuf", f"{topic} is {channel['encoding']}")
    expect(len(base64.b64decode(channel["schema"])) > 0, f"{topic} has no schema")
    asked = [{"id": TOPICS.index(topic), "channelId": channel["id"]}]
    viewer.send(json.dumps({"op": "subscribe", "subscriptions": asked}))


def recorded(path: Path) -> dict[str, dict[int, bytes]]:
    messages: dict[str, dict[int, bytes]] = {topic: {} for topic in TOPICS}
    with path.open("rb") as file:
        for _, channel, message in make_reader(file).iter_messages(topics=TOPICS):
            messages[channel.topic][message.log_time] = message.data
    return messages


def check_schemas(path: Path) -> None:
    """What came is of the schemas of the recording, which a reader of the format decodes."""
    with path.open("rb") as file:
        reader = make_reader(file, decoder_factories=[DecoderFactory()])
        for _, _, _, content in reader.iter_decoded_messages(topics=["/pellets"]):
            expect(content.frame_id == "world", "pellets are not in the world")


def validate(program: str) -> str:
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(
            [program, "new", "hopper"], cwd=folder, stdout=subprocess.DEVNULL, check=True
        )
        command = [program, "run", "hopper.toml", "--live=127.0.0.1:0"]
        run = subprocess.Popen(command, cwd=folder, stdout=subprocess.PIPE, text=True)
        assert run.stdout is not None
        invitation = run.stdout.readline()
        found = re.match(r"watch at (ws://127\.0\.0\.1:\d+) in .* layout (\S+)$", invitation)
        if found is None:
            run.kill()
            raise Broken(f"it does not say where to watch: {invitation!r}")
        try:
            messages = watched(found[1])
            run.stdout.read()
            expect(run.wait() == 0, f"the run ends with exit code {run.returncode}")
        finally:
            run.kill()
        layout = Path(folder) / found[2]
        expect(layout.is_file(), f"there is no layout {found[2]}")
        recording = layout.with_name("run.mcap")
        check_schemas(recording)
        kept = recorded(recording)
    for topic, live in messages.items():
        expect(len(live) > 0, f"nothing came of {topic}")
        for time, content in live.items():
            expect(kept[topic].get(time) == content, f"{topic} at {time} ns is not that recorded")
    frames, all_frames = len(messages["/pellets"]), len(kept["/pellets"])
    return f"{frames} of {all_frames} frames came live, and are those recorded"


def main(arguments: list[str]) -> int:
    if len(arguments) != 1:
        print(__doc__, file=sys.stderr)
        return 1
    try:
        print("ok", validate(arguments[0]))
    except Exception as error:  # a closed connection is a failure as well
        print(f"BROKEN {arguments[0]}: {type(error).__name__}: {error}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
