//! A table of named columns.

use super::unit::unit_of;

/// Named columns of the same length.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// Name, such as `bodies` or `meters/outflow`.
    pub name: String,
    /// Columns, in order.
    pub columns: Vec<Column>,
}

/// One quantity, a value for each row.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Name, which ends in its unit where it has one: `peak_force_n`.
    pub name: String,
    /// The unit as it is printed: `N`; `-` where it has none.
    pub unit: &'static str,
    /// The values.
    pub values: Values,
    /// Which rows have a value, if not all have.
    pub is_known: Option<Vec<bool>>,
}

/// Values of one type.
#[derive(Debug, Clone, PartialEq)]
pub enum Values {
    /// Numbers in single precision.
    Float32(Vec<f32>),
    /// Numbers in double precision.
    Float64(Vec<f64>),
    /// Whole numbers with a sign.
    Int32(Vec<i32>),
    /// Numbers of pellets.
    UInt32(Vec<u32>),
    /// Counts.
    UInt64(Vec<u64>),
    /// Truth values.
    Bool(Vec<bool>),
    /// Texts.
    Text(Vec<String>),
    /// Few texts, each for many rows.
    Label {
        /// The texts.
        labels: Vec<String>,
        /// Which of them each row has [-]; 0 where the row has none.
        indices: Vec<u32>,
    },
}

impl Table {
    /// Rows of every column [-].
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, |column| column.values.len())
    }

    /// The column of a name.
    pub fn column(&self, name: &str) -> Option<&Column> {
        self.columns.iter().find(|column| column.name == name)
    }
}

impl Column {
    /// A column whose unit is at the end of its name, and in which every row has a value.
    pub fn new(name: impl Into<String>, values: impl Into<Values>) -> Self {
        let name = name.into();
        Self {
            unit: unit_of(&name),
            values: values.into(),
            is_known: None,
            name,
        }
    }

    /// The same with values only in some rows.
    pub(super) fn known_where(mut self, is_known: Vec<bool>) -> Self {
        self.is_known = Some(is_known);
        self
    }

    /// Whether a row has a value.
    pub fn is_known(&self, row: usize) -> bool {
        self.is_known.as_ref().is_none_or(|known| known[row])
    }
}

impl Values {
    /// Number of them [-].
    pub fn len(&self) -> usize {
        match self {
            Self::Float32(values) => values.len(),
            Self::Float64(values) => values.len(),
            Self::Int32(values) => values.len(),
            Self::UInt32(values) => values.len(),
            Self::UInt64(values) => values.len(),
            Self::Bool(values) => values.len(),
            Self::Text(values) => values.len(),
            Self::Label { indices, .. } => indices.len(),
        }
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

macro_rules! from_vectors {
    ($($variant:ident of $kind:ty,)*) => {
        $(impl From<Vec<$kind>> for Values {
            fn from(values: Vec<$kind>) -> Self {
                Self::$variant(values)
            }
        })*
    };
}

from_vectors! {
    Float32 of f32,
    Float64 of f64,
    Int32 of i32,
    UInt32 of u32,
    UInt64 of u64,
    Bool of bool,
    Text of String,
}
