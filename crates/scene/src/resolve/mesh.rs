//! A mesh as written to triangles in the world, from its file.

use super::{Resolver, point};
use crate::key_path::KeyPath;
use crate::mesh::{BakeReport, Repair, Soup, mend, read};
use crate::mistakes::SceneError;
use crate::number::show;
use crate::quantity::Size;
use crate::spec::mesh::{MeshSpec, MeshUnitSpec};
use pelletflow_core::{MeshError, TriangleMesh, UnitQuaternion, Vec3};
use pelletflow_sim::{BakedMesh, PelletKind, WallShape};
use std::io;
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

/// Longest side beyond which a unit was mistaken: no plant has a longer chute [m].
const LARGEST: f64 = 200.0;
/// Longest side over the smallest diameter below which it was, where no unit is given [-].
const FEWEST_DIAMETERS: f64 = 5.0;
/// Skin over the largest diameter up to which a grid is asked, where no skin is given [-]; beyond, the triangles are.
const SKIN_SHARE: f64 = 0.1;

/// Longest file of a mesh that is read [B]: forty million triangles.
const LONGEST_FILE: u64 = 2 << 30;

/// What a file holds, if it is one and not beyond all bounds.
fn contents(path: &Path) -> io::Result<Vec<u8>> {
    let facts = std::fs::metadata(path)?;
    if facts.is_dir() {
        return Err(io::ErrorKind::IsADirectory.into());
    }
    if !facts.is_file() {
        // A device may have no end.
        return Err(io::ErrorKind::Unsupported.into());
    }
    if facts.len() > LONGEST_FILE {
        return Err(io::ErrorKind::FileTooLarge.into());
    }
    std::fs::read(path)
}

/// A file that a wall was made from.
#[derive(Debug, Clone)]
pub(crate) struct MeshFile {
    pub(crate) wall: String,
    /// Path as written in the scene.
    pub(crate) written: String,
    pub(crate) bytes: Arc<[u8]>,
}

impl MeshFile {
    /// Where a copy lies beside a copy of the scene: where the scene says, unless that is outside of its folder.
    pub(crate) fn beside(&self) -> PathBuf {
        let path = Path::new(&self.written);
        let is_inside = |part: Component| matches!(part, Component::Normal(_) | Component::CurDir);
        if path.components().all(is_inside) {
            return path.to_owned();
        }
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        PathBuf::from(format!("{}-{name}", self.wall))
    }
}

impl Resolver<'_> {
    /// The triangles of a wall; none where there is a mistake.
    pub(super) fn mesh(
        &mut self,
        wall: &str,
        spec: &MeshSpec,
        pellets: &[PelletKind],
        path: &KeyPath,
    ) -> Option<WallShape> {
        let bytes = self.bytes(&spec.file, &path.key("file"))?;
        let refuse = |cause: String| format!("`file` is \"{}\": {cause}", spec.file);
        let soup = match read(Path::new(&spec.file), &bytes) {
            Ok(soup) => self.placed(soup, spec, path),
            Err(error) => {
                let message = refuse(error.to_string());
                self.findings.add(&path.key("file"), message);
                return None;
            }
        };
        let repair = match spec.repair {
            Some(false) => Repair::No,
            _ => Repair::Within(spec.weld.map(|distance| distance.0)),
        };
        let mended = match mend(&soup, repair) {
            Ok(mended) => mended,
            Err(error) => {
                let cure = match (&error, repair) {
                    (MeshError::Degenerate { .. }, Repair::No) => {
                        "; set `repair = true` to have it dropped"
                    }
                    (_, Repair::Within(Some(_))) => "; lower `weld`, or leave it out",
                    _ => "; export it again",
                };
                let message = refuse(format!("the mesh {error}{cure}"));
                self.findings.add(&path.key("file"), message);
                return None;
            }
        };
        let is_plausible = self.judge_size(mended.report.size.max(), spec, pellets, path);
        let mut report = mended.report;
        let shape = match spec.bake {
            // Baking a mesh in a mistaken unit could take forever.
            Some(Size(spacing)) if is_plausible => {
                let (baked, bake) = self.baked(mended.mesh, spacing, pellets, path)?;
                report.bake = Some(bake);
                baked.into()
            }
            _ => mended.mesh.into(),
        };
        wall.clone_into(&mut report.wall);
        report.file.clone_from(&spec.file);
        self.reports.push(report);
        self.files.push(MeshFile {
            wall: wall.to_owned(),
            written: spec.file.clone(),
            bytes,
        });
        Some(shape)
    }

    /// The mesh in a grid of distances, as far as pellets ask.
    fn baked(
        &mut self,
        mesh: TriangleMesh,
        spacing: f64,
        pellets: &[PelletKind],
        path: &KeyPath,
    ) -> Option<(BakedMesh, BakeReport)> {
        let (smallest, largest) = pellets
            .iter()
            .fold((f64::INFINITY, 0.0_f64), |range, kind| {
                (
                    range.0.min(kind.size.min_diameter() / 2.0),
                    range.1.max(kind.size.max_diameter() / 2.0),
                )
            });
        let skin = self.spec.contact.skin.as_ref();
        let reach = largest + skin.map_or(SKIN_SHARE * 2.0 * largest, |Size(skin)| *skin);
        match BakedMesh::new(mesh, spacing, reach) {
            Ok(baked) => {
                let report = BakeReport::new(&baked, smallest, largest);
                Some((baked, report))
            }
            Err(error) => {
                let message = format!("`bake` is {} m: {error}", show(spacing));
                self.findings.add(&path.key("bake"), message);
                None
            }
        }
    }

    fn bytes(&mut self, file: &str, key: &KeyPath) -> Option<Arc<[u8]>> {
        let path = self.directory.join(file);
        let cause = match contents(&path) {
            Ok(bytes) => return Some(bytes.into()),
            Err(error) => match error.kind() {
                io::ErrorKind::NotFound | io::ErrorKind::NotADirectory => "there is no such file",
                io::ErrorKind::IsADirectory => "this is a directory",
                io::ErrorKind::Unsupported => "this is a device and no file",
                io::ErrorKind::FileTooLarge => "this is a file of more than 2 GiB",
                _ => {
                    self.unreadable = Some(SceneError::Unreadable {
                        path,
                        source: error,
                    });
                    return None;
                }
            },
        };
        self.findings.add(
            key,
            format!(
                "`file` is \"{file}\": {cause} at {}; expected an STL or OBJ file, its path seen from the folder of the scene",
                path.display()
            ),
        );
        None
    }

    /// Taken to meters, scaled, turned and moved.
    fn placed(&mut self, soup: Soup, spec: &MeshSpec, path: &KeyPath) -> Soup {
        let (_, unit) = MeshUnitSpec::of(spec.unit);
        let factor = unit * spec.scale.unwrap_or(1.0);
        let (turn, about) = spec.rotate.as_ref().map_or_else(
            || (UnitQuaternion::identity(), Vec3::zeros()),
            |rotate| {
                let axis = self.direction(rotate.axis, &path.key("rotate").key("axis"));
                let turn = UnitQuaternion::from_axis_angle(&axis, rotate.angle.0);
                (turn, rotate.about.map_or_else(Vec3::zeros, point))
            },
        );
        let by = spec.translate.map_or_else(Vec3::zeros, point);
        let place = |at: Vec3| turn * (factor * at - about) + about + by;
        Soup {
            vertices: soup.vertices.into_iter().map(place).collect(),
            ..soup
        }
    }

    /// Whether its size is one that plants have; otherwise its unit is mistaken.
    fn judge_size(
        &mut self,
        side: f64,
        spec: &MeshSpec,
        pellets: &[PelletKind],
        path: &KeyPath,
    ) -> bool {
        let (unit, _) = MeshUnitSpec::of(spec.unit);
        let assumed = match spec.unit {
            Some(_) => format!("with `unit = \"{unit}\"`"),
            None => format!("with its numbers taken for {unit}"),
        };
        let shown = show(side);
        if side > LARGEST {
            let message = format!(
                "the mesh is {shown} m long {assumed}; expected at most {LARGEST} m: most CAD writes millimeters, add `unit = \"mm\"`"
            );
            self.findings.add(path, message);
            return false;
        }
        let smallest = pellets
            .iter()
            .map(|kind| kind.size.min_diameter())
            .fold(f64::INFINITY, f64::min);
        if spec.unit.is_none() && side < FEWEST_DIAMETERS * smallest {
            let message = format!(
                "the mesh is {shown} m long {assumed}, less than {FEWEST_DIAMETERS} of the smallest pellets of {} m; tell its unit, \
                 for example `unit = \"mm\"`, and `unit = \"m\"` if it is as small as that",
                show(smallest)
            );
            self.findings.add(path, message);
            return false;
        }
        true
    }
}
