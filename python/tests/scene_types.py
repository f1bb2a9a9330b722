"""Writes `_scene_types.py` from the schema of a scene: ``python scene_types.py > FILE``."""

import keyword
from typing import Any

from pelletflow import _pelletflow

HEAD = '''"""Tables of a scene as types, so that editors complete their keys.

Made from the schema by ``python/tests/scene_types.py``; a test holds the two together.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal, TypeAlias, TypedDict
'''


def type_of(schema: dict[str, Any], path: str, names: dict[str, str], out: dict[str, str]) -> str:
    """Return the type of a value; tables that it holds are written to `out`."""
    if "$ref" in schema:
        return names.get(schema["$ref"], schema["$ref"].rsplit("/", 1)[1])
    if len(schema.get("allOf", [])) == 1:
        return type_of(schema["allOf"][0], path, names, out)
    for key in ("anyOf", "oneOf"):
        if key in schema:
            choices = [
                type_of(choice, f"{path}{_kind(choice, place)}", names, out)
                for place, choice in enumerate(schema[key], 1)
            ]
            return union(choices)
    if "const" in schema:
        return f"Literal[{schema['const']!r}]"
    if "enum" in schema:
        return f"Literal[{', '.join(repr(value) for value in schema['enum'])}]"
    if schema is True or not schema:
        return "Any"
    kinds = schema.get("type", "any")
    kinds = kinds if isinstance(kinds, list) else [kinds]
    return union([plain(kind, schema, path, names, out) for kind in kinds])


def plain(
    kind: str, schema: dict[str, Any], path: str, names: dict[str, str], out: dict[str, str]
) -> str:
    """Return the type of one kind of value."""
    if kind == "object":
        if schema.get("properties"):
            table(path, schema, names, out)
            return path
        inner = schema.get("additionalProperties")
        if isinstance(inner, dict):
            return f"Mapping[str, {type_of(inner, path, names, out)}]"
        return "Mapping[str, Any]"
    if kind == "array":
        items = schema.get("items", {})
        inner = type_of(items, path, names, out) if isinstance(items, dict) else "Any"
        return f"Sequence[{inner}]"
    return {"number": "float", "integer": "int", "string": "str", "boolean": "bool"}.get(
        kind, "Any"
    )


def union(choices: list[str]) -> str:
    """Return one of several types."""
    choices = list(dict.fromkeys(choices))
    return " | ".join(choices)


def _kind(choice: dict[str, Any], place: int) -> str:
    """Return what tells a table from the others: its kind, or its place."""
    kind = choice.get("properties", {}).get("kind", {})
    name = kind.get("const", next(iter(kind.get("enum", [])), str(place)))
    return str(name).title().replace("-", "")


def table(name: str, schema: dict[str, Any], names: dict[str, str], out: dict[str, str]) -> None:
    """Write a table as a type with the keys that it has."""
    out[name] = ""
    required = set(schema.get("required", []))
    lines = []
    for key, value in schema["properties"].items():
        path = name + key.title().replace("_", "").replace("-", "")
        inner = type_of(value, path, names, out)
        lines.append((key, inner, key in required, value.get("description", "")))
    is_plain = all(key.isidentifier() and not keyword.iskeyword(key) for key, *_ in lines)
    doc = schema.get("description", name).split("\n")[0].strip()
    doc = doc if doc.endswith((".", ":")) else f"{doc}."
    if is_plain:
        text = f'class {name}(TypedDict, total=False):\n    """{doc}"""\n'
        for key, inner, _, description in lines:
            text += f"\n    {key}: {inner}\n"
            if description:
                first = " ".join(description.split("\n\n")[0].split()).replace("\\", "\\\\")
                text += f'    """{first}"""\n'
    else:
        text = f"#: {doc}\n{name} = TypedDict(\n    {name!r},\n    {{\n"
        text += "".join(f"        {key!r}: {inner!r},\n" for key, inner, *_ in lines)
        text += "    },\n    total=False,\n)\n"
    out[name] = text


def module() -> str:
    """Return the text of the module."""
    schema = _pelletflow.schema()
    tables: dict[str, str] = {}
    choices: dict[str, dict[str, Any]] = {}
    for name, definition in schema.get("definitions", {}).items():
        if not (definition.get("properties") and definition.get("type") == "object"):
            choices[name] = definition
    # How a choice is referred to; only a checker of types ever sees its name.
    names = {f"#/definitions/{name}": f"_{name}" for name in choices}
    for name, definition in schema.get("definitions", {}).items():
        if name not in choices:
            table(name, definition, names, tables)
    aliases = ""
    for name, definition in choices.items():
        choice = type_of(definition, name.removesuffix("Spec"), names, tables)
        aliases += f"    _{name}: TypeAlias = {choice!r}\n"
    table("SceneSpec", schema, names, tables)
    body = "\n\n".join(tables.values())
    return f"{HEAD}\n\n{body}\n\nif TYPE_CHECKING:\n{aliases}"


if __name__ == "__main__":
    print(module(), end="")
