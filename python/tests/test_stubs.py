"""What the package shows of itself."""

import ast
import inspect
import re
from dataclasses import is_dataclass
from importlib.metadata import entry_points, version
from pathlib import Path

import pelletflow as pf
from pelletflow import _pelletflow

#: What functions return and nobody makes; the tests of those functions use it.
RETURNED = {
    "Impact",
    "Recording",
    "SafeSetting",
    "SafeSpeed",
    "Score",
    "SweepResult",
    "__version__",
}
#: Where our classes are made.
OURS = {
    "pelletflow",
    *(f"pelletflow.{path.stem}" for path in Path(pf.__file__).parent.glob("*.py")),
}
OURS |= {"pelletflow._sweep.result"}
STUB = Path(pf.__file__).with_name("_pelletflow.pyi")


def test_the_installed_wheel_is_what_is_tested():
    source = Path(__file__).parents[1] / "pelletflow"
    assert Path(pf.__file__).parent != source


def test_the_wheel_carries_types_and_one_version():
    assert STUB.exists()
    assert STUB.with_name("py.typed").exists()
    assert pf.__version__ == version("pelletflow")


def test_the_stub_and_the_module_name_the_same_things():
    tree = ast.parse(STUB.read_text(encoding="utf-8"))
    functions = {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}
    classes = {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}
    module = {name for name in dir(_pelletflow) if not name.startswith("_")}
    assert functions | set(classes) == module
    for name, stub in classes.items():
        members = {node.name for node in stub.body if isinstance(node, ast.FunctionDef)}
        built = {member for member in vars(getattr(_pelletflow, name)) if member[0] != "_"}
        assert {member for member in members if member[0] != "_"} == built, name


def test_every_quantity_is_documented_with_its_unit():
    for name, member in vars(pf.Simulation).items():
        if name.startswith("_"):
            continue
        doc = inspect.getdoc(member)
        assert doc, name
        if name != "state_hash":
            assert "[" in doc, f"{name} states no unit"


def members(public: object) -> set[str]:
    """Names of what a class has for its users: methods, properties and fields."""
    if not inspect.isclass(public):
        return set()
    fields = public.__dataclass_fields__ if is_dataclass(public) else {}
    own = {name for base in public.__mro__ for name in vars(base) if base.__module__ in OURS}
    return {name for name in own | set(fields) if not name.startswith("_")}


def test_everything_public_is_documented():
    for name in pf.__all__:
        if name == "__version__":
            continue
        public = getattr(pf, name)
        assert inspect.getdoc(public), name
        source = inspect.getsource(public) if not is_built(public) else ""
        for member in members(public):
            doc = inspect.getdoc(getattr(public, member, None))
            # What is a field has its text below it.
            assert doc or f"    {member}: " in source or f"self.{member}" in source, (
                f"{name}.{member}"
            )


def test_every_public_name_and_all_that_it_has_is_used_by_a_test():
    tests = "".join(path.read_text(encoding="utf-8") for path in Path(__file__).parent.glob("*.py"))
    for name in pf.__all__:
        if name not in RETURNED:
            assert f"pf.{name}" in tests, f"no test uses {name}"
        for member in members(getattr(pf, name)):
            assert re.search(rf"\.{member}\b", tests), f"no test uses {name}.{member}"


def is_built(public: object) -> bool:
    """Whether it is of the Rust module."""
    return getattr(_pelletflow, getattr(public, "__name__", ""), None) is public


def test_the_command_is_an_entry_point():
    (command,) = entry_points(group="console_scripts", name="pelletflow")
    assert command.value == "pelletflow._command:main"
