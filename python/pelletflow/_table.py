"""Tables: named columns of one type each, with units."""

from __future__ import annotations

import html
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from pelletflow._pelletflow import Batch
from pelletflow.errors import InputError

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: Rows that a notebook shows at each end [-].
SHOWN = 5


class Table(Mapping[str, npt.NDArray[Any]]):
    """Named columns of equal length, which never change.

    A column is a NumPy array: ``table["peak_force_n"]``. It is a copy.
    Data frames take the table as it is, through Arrow's PyCapsule protocol and without a copy:
    ``pandas.DataFrame.from_arrow(table)``, ``polars.DataFrame(table)``, ``pyarrow.table(table)``,
    and DuckDB by the name of the variable, ``duckdb.sql("from hits")``.

    >>> import pelletflow as pf
    >>> table = pf.Table({"speed_m_per_s": [1.0, 2.0], "wall": ["chute", None]})
    >>> table["speed_m_per_s"]
    array([1., 2.])
    >>> len(table), list(table), table.rows
    (2, ['speed_m_per_s', 'wall'], 2)
    """

    __slots__ = ("_batch",)

    def __init__(
        self,
        columns: Mapping[str, npt.ArrayLike],
        *,
        name: str = "",
        units: Mapping[str, str] | None = None,
    ) -> None:
        """Make a table of columns of equal length.

        Args:
            columns: Numbers, truth values, or texts in which None stands for a missing one.
            name: Name of the table.
            units: Unit of each column that has one, as it is printed.

        Raises:
            InputError: A column has another length, more than one dimension or another type.

        """
        units = units or {}
        given = [(key, units.get(key, "-"), *_prepared(key, columns[key])) for key in columns]
        try:
            self._batch = Batch(name, given)
        except (TypeError, ValueError) as error:
            raise InputError(f"no table: {error}", "columns") from error

    @classmethod
    def _of(cls, batch: Batch) -> Table:
        table = cls.__new__(cls)
        table._batch = batch
        return table

    @property
    def name(self) -> str:
        """Name, such as ``bodies`` or ``meters/outflow``."""
        return self._batch.name

    @property
    def rows(self) -> int:
        """Rows of every column [-]."""
        return self._batch.rows

    @property
    def units(self) -> dict[str, str]:
        """Unit of each column as it is printed; ``-`` where it has none."""
        return dict(zip(self._batch.names, self._batch.units, strict=True))

    def __getitem__(self, column: str) -> npt.NDArray[Any]:
        """Return the values of a column, shape (rows,) [its unit].

        A missing number is NaN, a missing text None; whole numbers with gaps are a masked array.
        """
        try:
            values, known = self._batch.column(column)
        except KeyError:
            message = f"the table has no column `{column}`; it has {', '.join(self)}"
            raise KeyError(message) from None
        if isinstance(values, list):
            texts = np.empty(len(values), dtype=object)
            texts[:] = values
            return texts
        numbers: npt.NDArray[Any] = values
        if known is None:
            return numbers
        if numbers.dtype.kind == "f":
            numbers[~known] = np.nan
            return numbers
        return np.ma.masked_array(numbers, mask=~known)

    def __iter__(self) -> Iterator[str]:
        """Go through the names of the columns."""
        return iter(self._batch.names)

    def __len__(self) -> int:
        """Return the number of columns [-]."""
        return len(self._batch.names)

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object:
        """Return the rows as Arrow's stream in a capsule; nothing is copied."""
        return self._batch.__arrow_c_stream__(requested_schema)

    def __arrow_c_schema__(self) -> object:
        """Return Arrow's schema in a capsule, with the unit of each column in its metadata."""
        return self._batch.__arrow_c_schema__()

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle the table as its columns."""
        columns = [(name, unit, *self._batch.column(name)) for name, unit in self.units.items()]
        return _unpickled, (self.name, columns)

    def __eq__(self, other: object) -> bool:
        """Tell whether another table has the same columns, units and values; NaN equals NaN."""
        if not isinstance(other, Table):
            return NotImplemented
        if self.units != other.units or self.rows != other.rows:
            return False
        return all(_is_same(self._batch.column(name), other._batch.column(name)) for name in self)

    __hash__ = None  # type: ignore[assignment]

    def plot(self, x: str, y: str | Sequence[str], **options: Any) -> Axes:
        """Draw columns against another one; needs matplotlib.

        Args:
            x: Column along the horizontal axis.
            y: Column or columns along the vertical axis.
            options: Passed to ``Axes.plot``; ``ax`` is the axes to draw on.

        Returns:
            The axes.

        """
        from pelletflow._plot import columns

        return columns(self, x, [y] if isinstance(y, str) else list(y), **options)

    def __repr__(self) -> str:
        """Name, size and columns."""
        return f"<pelletflow.Table {self.name!r}: {self.rows} rows of {', '.join(self)}>"

    def _repr_html_(self) -> str:
        """First and last rows, as a notebook shows them."""
        shown = [*range(min(self.rows, SHOWN))]
        shown += [*range(max(self.rows - SHOWN, len(shown)), self.rows)]
        head = "".join(
            f"<th>{html.escape(name)}<br>[{html.escape(unit)}]</th>"
            for name, unit in self.units.items()
        )
        columns = [self[name][shown] for name in self]
        body = "".join(
            "<tr>" + "".join(f"<td>{html.escape(_text(value))}</td>" for value in row) + "</tr>"
            for row in zip(*columns, strict=True)
        )
        caption = html.escape(f"{self.name} ({self.rows} rows)".strip())
        return (
            f"<table><caption>{caption}</caption><thead><tr>{head}</tr></thead>"
            f"<tbody>{body}</tbody></table>"
        )


def _prepared(
    key: str, values: npt.ArrayLike
) -> tuple[npt.NDArray[Any] | list[str | None], npt.NDArray[np.bool_] | None]:
    """Values as the Rust module takes them, and which of them are there."""
    known = None
    if isinstance(values, np.ma.MaskedArray):
        known = ~np.ma.getmaskarray(values)
        values = values.filled()
    array = np.asarray(values)
    if array.ndim != 1:
        raise InputError(
            f"column `{key}` has shape {array.shape}; expected one dimension", key, array.shape
        )
    kind = array.dtype.kind
    if kind in "OUT":
        texts = array.tolist()
        wrong = next((text for text in texts if text is not None and type(text) is not str), None)
        if wrong is not None:
            raise InputError(
                f"column `{key}` holds {wrong!r}; expected numbers, truth values or texts",
                key,
                wrong,
            )
        return texts, None
    if kind == "i" and array.dtype.itemsize < 4:
        array = array.astype(np.int32)
    elif kind == "u" and array.dtype.itemsize < 4:
        array = array.astype(np.uint32)
    elif kind == "f" and array.dtype.itemsize not in (4, 8):
        array = array.astype(np.float64)
    return np.ascontiguousarray(array), known


def _unpickled(name: str, columns: list[Any]) -> Table:
    return Table._of(Batch(name, columns))


def _is_same(one: tuple[Any, Any], other: tuple[Any, Any]) -> bool:
    (values, known), (others, others_known) = one, other
    if isinstance(values, list):
        return bool(values == others)
    if (known is None) != (others_known is None):
        return False
    if known is not None and not np.array_equal(known, others_known):
        return False
    is_number = values.dtype.kind == "f"
    return values.dtype == others.dtype and np.array_equal(values, others, equal_nan=is_number)


def _text(value: Any) -> str:
    if value is None or value is np.ma.masked:
        return ""
    if isinstance(value, float | np.floating):
        return f"{value:.6g}"
    return str(value)
