"""Read recordings with the format's own Python readers, and check what they promise.

    python validate_recording.py FILE...

Needs `mcap` and `mcap-protobuf-support`. Exits with 1 when a recording breaks a promise.
"""

from __future__ import annotations

import struct
import sys
from collections import Counter
from pathlib import Path

from mcap.reader import make_reader
from mcap_protobuf.decoder import DecoderFactory

SCHEMAS = {
    "/pellets": "foxglove.PointCloud",
    "/equipment": "foxglove.SceneUpdate",
    "/tf": "foxglove.FrameTransforms",
    "/log": "foxglove.Log",
    "/ledger/mass": "pelletflow.MassLedger",
    "/ledger/energy": "pelletflow.EnergyLedger",
}
ATTACHMENTS = {"scene.toml", "layout.json"}
FACTS = {"version", "scene_hash", "seed", "threads", "step_s", "step_reason"}
POINT = struct.Struct("<6fI")
FIELDS = ["x", "y", "z", "radius", "speed", "force", "id"]


class Broken(Exception):
    """A promise that a recording breaks."""


def expect(condition: bool, message: str) -> None:
    if not condition:
        raise Broken(message)


def finite(values: tuple[float, ...]) -> bool:
    return all(abs(value) < float("inf") for value in values)


def check_cloud(cloud, time: float) -> int:
    """Check one frame of pellets, and count them."""
    expect([field.name for field in cloud.fields] == FIELDS, f"fields at {time} s")
    expect(cloud.point_stride == POINT.size, f"point stride at {time} s")
    expect(len(cloud.data) % POINT.size == 0, f"a point is cut off at {time} s")
    expect(cloud.frame_id == "world", f"frame of the pellets at {time} s")
    last = -1
    for *values, number in POINT.iter_unpack(cloud.data):
        expect(finite(tuple(values)), f"pellet {number} is not finite at {time} s")
        expect(values[3] > 0.0, f"pellet {number} has no radius at {time} s")
        expect(number > last, f"pellet {number} is out of order at {time} s")
        last = number
    return len(cloud.data) // POINT.size


def check_ledger(ledger, time: float) -> int:
    """Check the mass ledger, and count the pellets inside."""
    total = ledger.inside + ledger.discharged + ledger.lost
    expect(ledger.inserted == total, f"the pellets do not add up at {time} s")
    allowed = 1e-9 * max(ledger.inserted_kg, 1e-9)
    expect(abs(ledger.residual_kg) <= allowed, f"the masses do not add up at {time} s")
    return int(ledger.inside)


def check_equipment(update, names: set[str]) -> None:
    """Check the walls, and gather their frames."""
    for wall in update.entities:
        expect(bool(wall.triangles), f"wall {wall.id} has no triangles")
        for mesh in wall.triangles:
            expect(len(mesh.indices) % 3 == 0, f"wall {wall.id} has a cut triangle")
            expect(
                all(index < len(mesh.points) for index in mesh.indices),
                f"wall {wall.id} has a triangle without corners",
            )
        keys = {pair.key for pair in wall.metadata}
        expect({"name", "material"} <= keys, f"wall {wall.id} has no name or material")
        names.add(wall.frame_id)


def validate(path: Path) -> str:
    """Check one recording, and describe it in a line."""
    counts: Counter[str] = Counter()
    pellets: dict[int, int] = {}
    inside: dict[int, int] = {}
    last_time: dict[str, int] = {}
    walls: set[str] = set()
    frames: set[str] = set()
    with path.open("rb") as file:
        reader = make_reader(file, validate_crcs=True, decoder_factories=[DecoderFactory()])
        for schema, channel, message, decoded in reader.iter_decoded_messages(log_time_order=False):
            topic, time = channel.topic, message.log_time
            wanted = SCHEMAS.get(topic)
            expect(wanted in (None, schema.name), f"{topic} has schema {schema.name}")
            expect(time >= last_time.get(topic, 0), f"{topic} goes back in time")
            is_frame = topic in ("/pellets", "/ledger/mass", "/ledger/energy")
            expect(
                not is_frame or time > last_time.get(topic, -1),
                f"{topic} has two messages at {time} ns",
            )
            last_time[topic] = time
            counts[topic] += 1
            if topic == "/pellets":
                pellets[time] = check_cloud(decoded, time * 1e-9)
            elif topic == "/ledger/mass":
                inside[time] = check_ledger(decoded, time * 1e-9)
            elif topic == "/equipment":
                check_equipment(decoded, walls)
            elif topic == "/tf":
                frames |= {frame.child_frame_id for frame in decoded.transforms}
            elif topic.startswith("/meters/"):
                for field, value in decoded.ListFields():
                    expect(finite((value,)), f"{topic}.{field.name} is not finite")
        attachments = {item.name for item in reader.iter_attachments()}
        metadata = {item.name: item.metadata for item in reader.iter_metadata()}
    for topic in SCHEMAS:
        expect(counts[topic] > 0, f"there is no {topic}")
    expect(pellets == inside, "frames and mass ledger count different pellets")
    expect(walls <= frames, f"walls without a frame: {sorted(walls - frames)}")
    expect(attachments >= ATTACHMENTS, f"attachments are {sorted(attachments)}")
    facts = metadata.get("pelletflow.run", {})
    expect(facts.keys() >= FACTS, f"facts of the run are {sorted(facts)}")
    most = max(pellets.values())
    return (
        f"{path}: {sum(counts.values())} messages on {len(counts)} topics, "
        f"{len(pellets)} frames to {max(pellets) * 1e-9:.3f} s, at most {most} pellets, "
        f"{len(walls)} walls, {path.stat().st_size} B"
    )


def main(arguments: list[str]) -> int:
    if not arguments:
        print(__doc__, file=sys.stderr)
        return 1
    failures = 0
    for argument in arguments:
        try:
            print("ok", validate(Path(argument)))
        except Exception as error:  # a reader's own complaint is a failure as well
            print(f"BROKEN {argument}: {type(error).__name__}: {error}")
            failures += 1
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
