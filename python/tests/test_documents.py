"""Examples of the documentation, run as a reader does."""

import doctest
import importlib
import re
from pathlib import Path

import pelletflow as pf
import pytest
import small_scenes

ROOT = Path(__file__).parents[2]
GUIDE = (ROOT / "docs/guide/python.md").read_text(encoding="utf-8")
MODULES = sorted(
    module.relative_to(Path(pf.__file__).parent).with_suffix("").as_posix().replace("/", ".")
    for module in Path(pf.__file__).parent.rglob("*.py")
    if ">>>" in module.read_text(encoding="utf-8") and module.name != "__init__.py"
)
#: Functions that answer, and classes that a reader makes: each shows how in its doc comment.
SHOWN = {
    "Scene",
    "Simulation",
    "Table",
    "impact",
    "read",
    "run",
    "safe_setting",
    "safe_speed",
    "score",
    "sweep",
    "to_rerun",
}


@pytest.fixture
def scenes(tmp_path, monkeypatch):
    """A working folder with the scenes that examples name."""
    small_scenes.write(tmp_path)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MPLBACKEND", "Agg")
    return tmp_path


@pytest.mark.parametrize("name", ["", *MODULES])
def test_the_examples_of_doc_comments_give_what_they_show(name, scenes):
    module = importlib.import_module(f"pelletflow.{name}".rstrip("."))
    if name == "_rerun":
        pytest.importorskip("rerun")
    failed, tried = doctest.testmod(module)
    assert failed == 0
    assert tried > 0


def test_every_function_and_every_class_that_a_reader_makes_has_an_example():
    assert set(pf.__all__) >= SHOWN
    for name in SHOWN:
        assert ">>>" in getattr(pf, name).__doc__, name
    for name in pf.__all__:
        public = getattr(pf, name)
        if callable(public) and not isinstance(public, type):
            assert name in SHOWN, name


def test_no_example_is_left_out():
    for module in Path(pf.__file__).parent.rglob("*.py"):
        assert "doctest: +SKIP" not in module.read_text(encoding="utf-8"), module


def test_the_examples_of_a_simulation_give_what_they_show(scenes):
    # The module in which it is built is no Python, so that `testmod` does not find it.
    example = doctest.DocTestFinder(recurse=False).find(
        pf.Simulation, "Simulation", module=False, globs={}
    )
    results = [doctest.DocTestRunner().run(each) for each in example]
    assert sum(result.failed for result in results) == 0
    assert sum(result.attempted for result in results) > 0


def blocks(executor: str | None) -> list[str]:
    """Examples of the guide up to those of executors, or that of one executor."""
    found = re.findall(r"```python\n(.*?)```", GUIDE, re.DOTALL)
    own = [block for block in found if executor and re.search(rf"^(from|import) {executor}", block)]
    plain = [block for block in found if not re.match(r"(from|import) (?!numpy|pelletflow)", block)]
    return own if executor else plain


def test_the_guide_runs_from_its_beginning(scenes):
    pytest.importorskip("matplotlib")
    names: dict = {}
    for block in blocks(None):
        exec(compile(block, "python.md", "exec"), names)
    assert names["result"].table.rows == 6
    assert names["recording"].bodies.rows > 0
    assert names["found"].low < names["found"].value < names["found"].high


@pytest.mark.parametrize("executor", ["distributed", "ray", "joblib", "optuna"])
def test_the_guide_runs_on_every_executor_that_it_names(executor, scenes):
    library = pytest.importorskip(executor)
    (block,) = blocks(executor)
    names = {"pf": pf, "scene": "chute.toml", "points": {"scene.seed": [1, 2]}}
    block = block.replace("/shared/sweep", "out/shared").replace("n_trials=30", "n_trials=2")
    if executor == "distributed":
        with library.LocalCluster(
            n_workers=1, threads_per_worker=1, dashboard_address=None
        ) as cluster:
            exec(block.replace("scheduler:8786", cluster.scheduler_address), names)
        return
    try:
        exec(block.replace("ray.init()", "ray.init(num_cpus=1, include_dashboard=False)"), names)
    finally:
        if executor == "ray":
            library.shutdown()
    assert executor != "optuna" or 0.02 <= names["study"].best_params["rolling_friction"] <= 0.4


def test_the_exceptions_of_the_guide_are_those_there_are():
    names = set(re.findall(r"`(?:pf\.)?(\w+Error)`", GUIDE))
    errors = {name for name in pf.__all__ if name.endswith("Error")}
    assert names == errors


def test_the_notebook_of_the_breakage_map_runs(tmp_path, monkeypatch, hang_guard):
    nbformat = pytest.importorskip("nbformat")
    nbclient = pytest.importorskip("nbclient")
    pytest.importorskip("ipykernel")
    # The kernel chooses how pictures are shown.
    monkeypatch.delenv("MPLBACKEND", raising=False)
    notebook = nbformat.read(ROOT / "examples/breakage_map.ipynb", as_version=4)
    nbclient.NotebookClient(
        notebook,
        timeout=int(hang_guard),
        kernel_name="python3",
        resources={"metadata": {"path": str(tmp_path)}},
    ).execute()
    outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
    assert any("image/png" in output.get("data", {}) for output in outputs)


def test_the_notebook_in_the_repository_holds_no_outputs():
    nbformat = pytest.importorskip("nbformat")
    notebook = nbformat.read(ROOT / "examples/breakage_map.ipynb", as_version=4)
    assert not any(cell.get("outputs") for cell in notebook.cells)
