//! Files of VTK: points and triangles with values, and lists of them over time.
//!
//! Written as XML with numbers in base 64 (VTK file formats, `PolyData`), which `ParaView` and VTK read.

use crate::markup::escaped;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use std::fs::File;
use std::io::{self, BufWriter, Write};

/// Points, what is between them, and what is known at each.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct PolyData {
    /// Places [m].
    pub(super) points: Vec<[f32; 3]>,
    /// Corners of each triangle, by index; where there is none, every point stands alone.
    pub(super) triangles: Vec<u32>,
    /// Names and values, one for each point.
    pub(super) values: Vec<(String, Array)>,
}

/// Values of one type.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Array {
    Float32(Vec<f32>),
    Float64(Vec<f64>),
    UInt32(Vec<u32>),
    Int32(Vec<i32>),
}

impl Array {
    fn kind(&self) -> &'static str {
        match self {
            Self::Float32(_) => "Float32",
            Self::Float64(_) => "Float64",
            Self::UInt32(_) => "UInt32",
            Self::Int32(_) => "Int32",
        }
    }

    fn bytes(&self) -> Vec<u8> {
        match self {
            Self::Float32(values) => values
                .iter()
                .flat_map(|value| value.to_le_bytes())
                .collect(),
            Self::Float64(values) => values
                .iter()
                .flat_map(|value| value.to_le_bytes())
                .collect(),
            Self::UInt32(values) => values
                .iter()
                .flat_map(|value| value.to_le_bytes())
                .collect(),
            Self::Int32(values) => values
                .iter()
                .flat_map(|value| value.to_le_bytes())
                .collect(),
        }
    }
}

impl PolyData {
    /// Writes a `.vtp` file.
    pub(super) fn write(&self, mut file: BufWriter<File>) -> io::Result<()> {
        let count = self.points.len();
        let is_points = self.triangles.is_empty();
        let (vertices, triangles) = if is_points {
            (count, 0)
        } else {
            (0, self.triangles.len() / 3)
        };
        writeln!(file, "<?xml version=\"1.0\"?>")?;
        writeln!(
            file,
            "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">"
        )?;
        writeln!(
            file,
            "<PolyData><Piece NumberOfPoints=\"{count}\" NumberOfVerts=\"{vertices}\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"{triangles}\">"
        )?;
        writeln!(file, "<Points>")?;
        let places = self.points.iter().flatten().copied().collect();
        array(&mut file, "Points", 3, &Array::Float32(places))?;
        writeln!(file, "</Points>\n<PointData>")?;
        for (name, values) in &self.values {
            array(&mut file, name, 1, values)?;
        }
        writeln!(file, "</PointData>")?;
        let (cells, corners, each) = if is_points {
            ("Verts", (0..count as u32).collect(), 1)
        } else {
            ("Polys", self.triangles.clone(), 3)
        };
        let ends = (1..=(vertices + triangles) as u32).map(|cell| each * cell);
        writeln!(file, "<{cells}>")?;
        array(&mut file, "connectivity", 1, &Array::UInt32(corners))?;
        array(&mut file, "offsets", 1, &Array::UInt32(ends.collect()))?;
        writeln!(file, "</{cells}>\n</Piece></PolyData></VTKFile>")?;
        file.flush()
    }
}

/// Writes an array: the number of its bytes, and these.
fn array(file: &mut impl Write, name: &str, components: usize, values: &Array) -> io::Result<()> {
    let values_bytes = values.bytes();
    let mut bytes = (values_bytes.len() as u64).to_le_bytes().to_vec();
    bytes.extend(values_bytes);
    writeln!(
        file,
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{components}\" format=\"binary\">{}</DataArray>",
        values.kind(),
        escaped(name),
        STANDARD.encode(bytes)
    )
}

/// Files over time.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Collection {
    /// Time [s], part, and file.
    entries: Vec<(f64, usize, String)>,
}

impl Collection {
    /// Adds a part of what is there at a time [s], by its file.
    pub(super) fn push(&mut self, time: f64, part: usize, file: &str) {
        self.entries.push((time, part, file.to_owned()));
    }

    /// Number of files [-].
    pub(super) fn len(&self) -> usize {
        self.entries.len()
    }

    /// Whether it names no file.
    pub(super) fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// Writes a `.pvd` file.
    pub(super) fn write(&self, mut file: BufWriter<File>) -> io::Result<()> {
        writeln!(file, "<?xml version=\"1.0\"?>")?;
        writeln!(
            file,
            "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n<Collection>"
        )?;
        for (time, part, name) in &self.entries {
            let name = escaped(name);
            writeln!(
                file,
                "<DataSet timestep=\"{time}\" group=\"\" part=\"{part}\" file=\"{name}\"/>"
            )?;
        }
        writeln!(file, "</Collection>\n</VTKFile>")?;
        file.flush()
    }
}
