"""Tables and the data frames that take them."""

import pickle

import numpy as np
import pelletflow as pf
import pytest


@pytest.fixture
def table() -> pf.Table:
    """One column of each type, two of them with gaps."""
    return pf.Table(
        {
            "speed_m_per_s": np.array([1.0, 2.0, 4.0]),
            "x_m": np.array([0.5, 0.25, 0.125], dtype=np.float32),
            "count": np.array([1, 2, 3], dtype=np.int64),
            "id": np.array([7, 8, 9], dtype=np.uint32),
            "partner": np.ma.masked_array(np.array([1, 2, 3], dtype=np.uint32), [0, 1, 0]),
            "is_open": np.array([True, False, True]),
            "wall": ["chute", None, "floor"],
        },
        name="hits",
        units={"speed_m_per_s": "m/s", "x_m": "m"},
    )


def test_columns_keep_their_type_values_and_gaps(table):
    assert table.rows == 3
    assert list(table) == [
        "speed_m_per_s",
        "x_m",
        "count",
        "id",
        "partner",
        "is_open",
        "wall",
    ]
    kinds = [table[name].dtype for name in ("speed_m_per_s", "x_m", "count", "id", "is_open")]
    assert kinds == [np.float64, np.float32, np.int64, np.uint32, np.bool_]
    assert table["partner"].tolist() == [1, None, 3]
    assert table["wall"].tolist() == ["chute", None, "floor"]
    assert table.units["speed_m_per_s"] == "m/s"
    assert table.units["count"] == "-"


def test_a_column_is_a_copy_so_that_a_table_never_changes(table):
    table["speed_m_per_s"][:] = 0.0
    assert table["speed_m_per_s"].tolist() == [1.0, 2.0, 4.0]


def test_a_table_survives_the_way_to_another_process(table):
    other = pickle.loads(pickle.dumps(table))
    assert other == table
    assert other.name == "hits"
    assert other != pf.Table({"speed_m_per_s": [1.0, 2.0, 4.0]})


def test_pyarrow_takes_a_table_with_types_gaps_and_units(table):
    pyarrow = pytest.importorskip("pyarrow")
    taken = pyarrow.table(table)
    assert taken.column_names == list(table)
    assert taken["wall"].to_pylist() == ["chute", None, "floor"]
    assert taken["partner"].to_pylist() == [1, None, 3]
    assert taken["x_m"].type == pyarrow.float32()
    assert taken.schema.field("x_m").metadata == {b"unit": b"m"}
    assert pyarrow.schema(table) == taken.schema


def test_pandas_takes_a_table(table):
    pandas = pytest.importorskip("pandas")
    taken = pandas.DataFrame.from_arrow(table)
    assert list(taken.columns) == list(table)
    assert taken["speed_m_per_s"].sum() == 7.0
    assert taken["wall"].isna().tolist() == [False, True, False]


def test_polars_takes_a_table(table):
    polars = pytest.importorskip("polars")
    taken = polars.DataFrame(table)
    assert taken.columns == list(table)
    assert taken["partner"].to_list() == [1, None, 3]
    assert taken["count"].dtype == polars.Int64


def test_duckdb_asks_a_table_by_the_name_of_the_variable(table):
    duckdb = pytest.importorskip("duckdb")
    hits = table
    (row,) = duckdb.sql("select max(speed_m_per_s), count(wall) from hits").fetchall()
    assert row == (hits["speed_m_per_s"].max(), 2)


def test_a_notebook_shows_names_units_and_both_ends():
    table = pf.Table({"a<b_m": np.arange(100.0)}, name="long", units={"a<b_m": "m"})
    shown = table._repr_html_()
    assert "a&lt;b_m<br>[m]" in shown
    assert "<td>0</td>" in shown
    assert "<td>99</td>" in shown
    assert "<td>50</td>" not in shown
    assert "100 rows" in shown


def test_a_plot_has_the_columns_as_lines_and_units_on_its_axes(table):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    axes = table.plot("count", "speed_m_per_s")
    assert axes.get_xlabel() == "count"
    assert axes.get_ylabel() == "speed_m_per_s [m/s]"
    assert axes.lines[0].get_ydata().tolist() == [1.0, 2.0, 4.0]
    both = table.plot("count", ["speed_m_per_s", "x_m"])
    assert len(both.lines) == 2
    assert table.plot("count", "x_m", ax=both) is both


@pytest.mark.parametrize(
    ("columns", "reason"),
    [
        ({"a": [1.0, 2.0], "b": [1.0]}, "length"),
        ({"a": np.zeros((2, 2))}, "dimension"),
        ({"a": [1.0, {}]}, "numbers"),
        ({"a": np.zeros(2, dtype=complex)}, "array"),
    ],
)
def test_what_is_no_table_is_refused(columns, reason):
    with pytest.raises(pf.InputError, match=reason):
        pf.Table(columns)


def test_a_column_that_is_not_there_is_told_with_those_that_are(table):
    with pytest.raises(KeyError, match="speed_m_per_s"):
        table["velocity"]
