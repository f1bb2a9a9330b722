"""Read what `pelletflow export` writes with the readers of VTK, and hold it against the recording.

    python validate_export.py RUN.mcap VTK-DIRECTORY

Needs `mcap`, `mcap-protobuf-support`, `numpy` and `vtk`. Exits with 1 where a number differs.
"""

from __future__ import annotations

import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np
from mcap.reader import make_reader
from mcap_protobuf.decoder import DecoderFactory
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

POINT = np.dtype(
    [
        ("place", "<f4", 3),
        ("radius_m", "<f4"),
        ("speed_m_per_s", "<f4"),
        ("force_n", "<f4"),
        ("id", "<u4"),
    ]
)


def read(path: Path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def listed(folder: Path, name: str) -> list[tuple[float, Path]]:
    root = ElementTree.parse(folder / name).getroot()
    entries = root.iter("DataSet")
    return [(float(entry.attrib["timestep"]), folder / entry.attrib["file"]) for entry in entries]


def frames(recording: Path):
    with recording.open("rb") as file:
        reader = make_reader(file, decoder_factories=[DecoderFactory()])
        for _, _, message, cloud in reader.iter_decoded_messages(topics=["/pellets"]):
            yield message.log_time * 1e-9, np.frombuffer(cloud.data, POINT)


def validate(recording: Path, folder: Path) -> str:
    files = listed(folder, "pellets.pvd")
    count = 0
    for (time, pellets), (told, path) in zip(frames(recording), files, strict=True):
        data = read(path)
        assert abs(time - told) < 1e-9, path
        assert data.GetNumberOfPoints() == data.GetNumberOfVerts() == len(pellets), path
        if len(pellets):
            assert np.array_equal(vtk_to_numpy(data.GetPoints().GetData()), pellets["place"]), path
        for name in ("id", "radius_m", "speed_m_per_s", "force_n"):
            found = vtk_to_numpy(data.GetPointData().GetArray(name))
            assert np.array_equal(found, pellets[name]), (path, name)
        count += len(pellets)
    walls = {path for _, path in listed(folder, "walls.pvd")}
    for path in walls:
        data = read(path)
        assert data.GetNumberOfPolys() > 0, path
        bounds = np.array(data.GetBounds())
        assert np.isfinite(bounds).all(), path
    assert walls, "there are no walls"
    hits = read(folder / "hits.vtp")
    forces = vtk_to_numpy(hits.GetPointData().GetArray("peak_force_n"))
    assert len(forces) == hits.GetNumberOfPoints()
    assert (forces >= 0).all()
    return f"{folder}: {len(files)} frames, {count} places, {len(walls)} walls, {len(forces)} hits"


if __name__ == "__main__":
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        sys.exit(1)
    print("ok", validate(Path(sys.argv[1]), Path(sys.argv[2])))
