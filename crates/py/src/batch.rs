//! Tables as Arrow has them, handed over without a copy to whatever speaks its `PyCapsule` protocol.

use arrow_array::cast::AsArray;
use arrow_array::ffi_stream::FFI_ArrowArrayStream;
use arrow_array::types::{
    ArrowPrimitiveType, Float32Type, Float64Type, Int32Type, Int64Type, UInt32Type, UInt64Type,
};
use arrow_array::{
    Array, ArrayRef, BooleanArray, DictionaryArray, PrimitiveArray, RecordBatch,
    RecordBatchIterator, StringArray,
};
use arrow_buffer::{BooleanBuffer, NullBuffer, ScalarBuffer};
use arrow_schema::ffi::FFI_ArrowSchema;
use arrow_schema::{ArrowError, DataType, Field, Schema};
use numpy::{Element, PyArray1, PyReadonlyArray1};
use pelletflow_log::{Column, Table, Values};
use pyo3::exceptions::{PyKeyError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyCapsule, PyList};
use std::collections::HashMap;
use std::ffi::CStr;
use std::sync::Arc;

/// Names of capsules in Arrow's protocol.
const STREAM: &CStr = c"arrow_array_stream";
const SCHEMA: &CStr = c"arrow_schema";
/// Key of a column's unit, in the metadata of its field.
const UNIT: &str = "unit";
/// Key of a table's name, in the metadata of its schema.
const NAME: &str = "name";

/// Named columns of one type each, which never change.
#[pyclass(module = "pelletflow._pelletflow", frozen)]
pub(crate) struct Batch {
    batch: RecordBatch,
}

/// Name, unit, values, and which rows have one, of a column that comes from Python.
type GivenColumn<'py> = (
    String,
    String,
    Bound<'py, PyAny>,
    Option<PyReadonlyArray1<'py, bool>>,
);

/// The values of a column and, where not every row has one, which have.
type TakenColumn<'py> = (Bound<'py, PyAny>, Option<Bound<'py, PyArray1<bool>>>);

#[pymethods]
impl Batch {
    /// Columns of equal length by name, unit, values and rows that have one.
    #[new]
    fn new(name: &str, columns: Vec<GivenColumn<'_>>) -> PyResult<Self> {
        let mut fields = Vec::with_capacity(columns.len());
        let mut arrays = Vec::with_capacity(columns.len());
        for (column, unit, values, is_known) in columns {
            let nulls = is_known.map(|known| {
                NullBuffer::from(known.as_array().iter().copied().collect::<Vec<_>>())
            });
            let array = given(&values, nulls)?;
            fields.push(field(&column, &unit, &array));
            arrays.push(array);
        }
        record_batch(name, fields, arrays)
            .map(|batch| Self { batch })
            .map_err(|error| PyValueError::new_err(error.to_string()))
    }

    /// Name of the table.
    #[getter]
    fn name(&self) -> String {
        let schema = self.batch.schema_ref();
        schema.metadata().get(NAME).cloned().unwrap_or_default()
    }

    /// Names of the columns, in order.
    #[getter]
    fn names(&self) -> Vec<String> {
        let fields = self.batch.schema_ref().fields();
        fields.iter().map(|field| field.name().clone()).collect()
    }

    /// Units of the columns, in order; `-` where there is none.
    #[getter]
    fn units(&self) -> Vec<String> {
        let fields = self.batch.schema_ref().fields();
        fields
            .iter()
            .map(|field| field.metadata().get(UNIT).cloned().unwrap_or_default())
            .collect()
    }

    /// Rows [-].
    #[getter]
    fn rows(&self) -> usize {
        self.batch.num_rows()
    }

    /// The values of a column as a new array, or a list of texts, and which rows have one if not all have.
    fn column<'py>(&self, py: Python<'py>, name: &str) -> PyResult<TakenColumn<'py>> {
        let array = self
            .batch
            .column_by_name(name)
            .ok_or_else(|| PyKeyError::new_err(name.to_owned()))?;
        let known = array
            .logical_nulls()
            .map(|nulls| PyArray1::from_iter(py, nulls.iter()));
        Ok((taken(py, array)?, known))
    }

    /// Arrow's stream of the rows, in a capsule; a schema that is requested is not looked at, as the protocol allows.
    #[pyo3(signature = (requested_schema=None))]
    fn __arrow_c_stream__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyCapsule>> {
        drop(requested_schema);
        let rows = [Ok(self.batch.clone())];
        let reader = RecordBatchIterator::new(rows, self.batch.schema());
        PyCapsule::new_with_value(py, FFI_ArrowArrayStream::new(Box::new(reader)), STREAM)
    }

    /// Arrow's schema of the columns, in a capsule.
    fn __arrow_c_schema__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyCapsule>> {
        let schema = FFI_ArrowSchema::try_from(self.batch.schema_ref().as_ref())
            .map_err(|error| PyValueError::new_err(error.to_string()))?;
        PyCapsule::new_with_value(py, schema, SCHEMA)
    }
}

impl From<Table> for Batch {
    fn from(table: Table) -> Self {
        let (fields, arrays) = table
            .columns
            .into_iter()
            .map(|column| {
                let (name, unit) = (column.name.clone(), column.unit);
                let array = own(column);
                (field(&name, unit, &array), array)
            })
            .unzip();
        let batch = record_batch(&table.name, fields, arrays);
        Self {
            batch: batch.expect("the columns of a table are of one length"),
        }
    }
}

fn record_batch(
    name: &str,
    fields: Vec<Field>,
    arrays: Vec<ArrayRef>,
) -> Result<RecordBatch, ArrowError> {
    let metadata = HashMap::from([(NAME.to_owned(), name.to_owned())]);
    let schema = Schema::new(fields).with_metadata(metadata);
    RecordBatch::try_new(Arc::new(schema), arrays)
}

fn field(name: &str, unit: &str, array: &ArrayRef) -> Field {
    Field::new(name, array.data_type().clone(), true)
        .with_metadata(HashMap::from([(UNIT.to_owned(), unit.to_owned())]))
}

/// A column of ours; its memory is handed on.
fn own(column: Column) -> ArrayRef {
    let nulls = column.is_known.map(NullBuffer::from);
    match column.values {
        Values::Float32(values) => primitive::<Float32Type>(values, nulls),
        Values::Float64(values) => primitive::<Float64Type>(values, nulls),
        Values::Int32(values) => primitive::<Int32Type>(values, nulls),
        Values::UInt32(values) => primitive::<UInt32Type>(values, nulls),
        Values::UInt64(values) => primitive::<UInt64Type>(values, nulls),
        Values::Bool(values) => Arc::new(BooleanArray::new(BooleanBuffer::from(values), nulls)),
        Values::Text(values) => Arc::new(StringArray::from(values)),
        Values::Label { labels, indices } => {
            // With a sign, because data frames of pandas know no other; there are few labels.
            let indices = indices.into_iter().map(u32::cast_signed);
            let keys = PrimitiveArray::new(indices.collect(), nulls);
            let labels = Arc::new(StringArray::from(labels));
            Arc::new(DictionaryArray::<Int32Type>::new(keys, labels))
        }
    }
}

fn primitive<T: ArrowPrimitiveType>(values: Vec<T::Native>, nulls: Option<NullBuffer>) -> ArrayRef {
    Arc::new(PrimitiveArray::<T>::new(ScalarBuffer::from(values), nulls))
}

/// A column of Python's: an array of numbers or truth values, or a list of texts.
fn given(values: &Bound<'_, PyAny>, nulls: Option<NullBuffer>) -> PyResult<ArrayRef> {
    macro_rules! try_each {
        ($($kind:ty => $arrow:ty,)*) => {
            $(if let Ok(array) = values.extract::<PyReadonlyArray1<'_, $kind>>() {
                let values = array.as_array().iter().copied().collect();
                return Ok(primitive::<$arrow>(values, nulls));
            })*
        };
    }
    try_each! {
        f64 => Float64Type,
        f32 => Float32Type,
        i64 => Int64Type,
        i32 => Int32Type,
        u64 => UInt64Type,
        u32 => UInt32Type,
    }
    if let Ok(array) = values.extract::<PyReadonlyArray1<'_, bool>>() {
        let values = array.as_array().iter().copied().collect();
        return Ok(Arc::new(BooleanArray::new(values, nulls)));
    }
    if values.is_instance_of::<PyList>() {
        let texts: Vec<Option<String>> = values.extract()?;
        return Ok(Arc::new(StringArray::from(texts)));
    }
    Err(PyTypeError::new_err(format!(
        "a column is {}; expected an array of one dimension of numbers or truth values, or a list of texts",
        values.get_type().name()?
    )))
}

/// A column as Python has it.
fn taken<'py>(py: Python<'py>, array: &ArrayRef) -> PyResult<Bound<'py, PyAny>> {
    fn numbers<'py, T: ArrowPrimitiveType<Native: Element>>(
        py: Python<'py>,
        array: &ArrayRef,
    ) -> Bound<'py, PyAny> {
        PyArray1::from_slice(py, array.as_primitive::<T>().values()).into_any()
    }
    Ok(match array.data_type() {
        DataType::Float32 => numbers::<Float32Type>(py, array),
        DataType::Float64 => numbers::<Float64Type>(py, array),
        DataType::Int32 => numbers::<Int32Type>(py, array),
        DataType::Int64 => numbers::<Int64Type>(py, array),
        DataType::UInt32 => numbers::<UInt32Type>(py, array),
        DataType::UInt64 => numbers::<UInt64Type>(py, array),
        DataType::Boolean => {
            let values = array.as_boolean().values().iter();
            PyArray1::from_iter(py, values).into_any()
        }
        DataType::Utf8 => PyList::new(py, array.as_string::<i32>().iter())?.into_any(),
        DataType::Dictionary(..) => {
            let labels = array.as_dictionary::<Int32Type>();
            let texts = labels
                .downcast_dict::<StringArray>()
                .ok_or_else(|| PyTypeError::new_err("a column of labels holds no texts"))?;
            PyList::new(py, texts)?.into_any()
        }
        other => return Err(PyTypeError::new_err(format!("a column holds {other}"))),
    })
}
