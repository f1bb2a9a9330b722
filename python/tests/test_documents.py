"""Examples of the documentation, run as a reader does."""

import ast
import doctest
import importlib
import re
import time
from pathlib import Path

import pelletflow as pf
import pytest

ROOT = Path(__file__).parents[2]
MODULES = ["_impact", "_recording", "_run", "_scene", "_score", "_sweep.sweep", "_table"]


@pytest.mark.parametrize("name", ["", *MODULES])
def test_the_examples_of_doc_comments_give_what_they_show(name):
    module = importlib.import_module(f"pelletflow.{name}".rstrip("."))
    failed, tried = doctest.testmod(module)
    assert failed == 0
    assert tried > 0 or name == "_run"


def test_the_guide_names_only_what_there_is():
    guide = (ROOT / "docs/guide/python.md").read_text(encoding="utf-8")
    blocks = re.findall(r"```python\n(.*?)```", guide, re.DOTALL)
    assert blocks
    for block in blocks:
        for node in ast.walk(ast.parse(block)):
            is_ours = isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name)
            if is_ours and node.value.id == "pf":
                assert hasattr(pf, node.attr), node.attr
    names = set(re.findall(r"`(?:pf\.)?(\w+Error)`", guide))
    assert names <= set(pf.__all__)


def test_the_notebook_of_the_breakage_map_runs_in_under_a_minute(tmp_path, monkeypatch):
    nbformat = pytest.importorskip("nbformat")
    nbclient = pytest.importorskip("nbclient")
    pytest.importorskip("ipykernel")
    # The kernel chooses how pictures are shown.
    monkeypatch.delenv("MPLBACKEND", raising=False)
    notebook = nbformat.read(ROOT / "examples/breakage_map.ipynb", as_version=4)
    began = time.perf_counter()
    nbclient.NotebookClient(
        notebook,
        timeout=120,
        kernel_name="python3",
        resources={"metadata": {"path": str(tmp_path)}},
    ).execute()
    assert time.perf_counter() - began < 60.0
    outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
    assert any("image/png" in output.get("data", {}) for output in outputs)


def test_the_notebook_in_the_repository_holds_no_outputs():
    nbformat = pytest.importorskip("nbformat")
    notebook = nbformat.read(ROOT / "examples/breakage_map.ipynb", as_version=4)
    assert not any(cell.get("outputs") for cell in notebook.cells)
