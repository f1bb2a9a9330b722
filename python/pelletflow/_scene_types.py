"""Tables of a scene as types, so that editors complete their keys.

Made from the schema by ``python/tests/scene_types.py``; a test holds the two together.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal, TypeAlias, TypedDict


class ConditionSpec(TypedDict, total=False):
    """Bounds of a number: `{ min, max }`, or `{ value }` with `relative` or `absolute`."""

    absolute: float
    """Amount by which it may differ, in the unit of the value."""

    exact: bool
    """Whether the value is known exactly, so that `pelletflow accuracy` may hold errors against it; false where left out."""

    max: float
    """Greatest value."""

    min: float
    """Least value."""

    relative: float | str
    """Share of the value by which it may differ [-]."""

    value: float
    """Value."""


class ContactSpec(TypedDict, total=False):
    """Contact laws and neighbor search."""

    normal: _NormalSpec
    """How bodies push apart."""

    rolling: _TurningSpec
    """How bodies resist rolling over each other; `constant-torque` where none is given."""

    search: _SearchSpec
    """How neighbors are found; every way gives the same result."""

    skin: float | str
    """Extra reach of a neighbor list [m]; it follows the motion seen where none is given."""

    tangential: _TangentialSpec
    """How bodies resist sliding."""

    twisting: _TurningSpec
    """How bodies resist twisting on each other; `none` where none is given."""


class DistributionSpec(TypedDict, total=False):
    """A distribution of diameters: `min` and `max` alone, any between as likely by number; with `mean` and `deviation`."""

    deviation: float | str
    """Standard deviation of a normal distribution [m]."""

    max: float | str
    """Largest diameter [m]; three deviations above the middle where none is given."""

    mean: float | str
    """Mean of a normal distribution, by number [m]."""

    median: float | str
    """Median of a log-normal distribution, by number [m]."""

    min: float | str
    """Smallest diameter [m]; three deviations below the middle where none is given."""

    openings: Sequence[float | str]
    """Openings of the sieves of a screen analysis, rising [m]."""

    passing: Sequence[float | str]
    """Mass that passes each of them over the whole, rising from 0 to 1 [-]."""

    spread: float
    """Standard deviation of the logarithm of a log-normal distribution [-]."""


class DomainSpec(TypedDict, total=False):
    """The box in which pellets may be; one that leaves it elsewhere than by an outlet is lost."""

    max: Sequence[float | str]
    """Highest corner [m]."""

    min: Sequence[float | str]
    """Lowest corner [m]."""

    periodic: Sequence[_AxisSpec]
    """Axes along which a pellet that leaves the box comes in again at the opposite side: `["x", "y"]`; none where none is given."""


class ExpectSpec(TypedDict, total=False):
    """What a right run shows, by dotted key of its summary."""

    tolerance: float | str
    """Share by which a number may differ where an entry gives a plain number [-]; 1e-9 where none is given."""


class FillSpec(TypedDict, total=False):
    """Pellets there at the start: a `region` with a `count`, a `mass` or a level, or their centers `at`."""

    at: Sequence[Sequence[float | str]]
    """Centers of the pellets, one by one [m]; in place of `region`."""

    count: int
    """How many [-]."""

    mass: float | str
    """At least this mass, to the next whole pellet [kg]."""

    packing: _PackingSpec
    """How the pellets are put into the region; `lattice` where all are of one size or nothing pulls them down, `deposit` else."""

    pellets: str
    """Name of the kind of pellets."""

    region: _ShapeSpec
    """Where the pellets are put, without overlap and from the bottom up; each lies wholly inside."""

    spin: Sequence[float | str]
    """Spin at the start [rad/s]; none where none is given."""

    to_level: float | str
    """Height against gravity, from the origin, up to which the settled bed fills the region [m]; the number of pellets follows from an estimate of how densely they pack."""

    velocity: Sequence[float | str]
    """Velocity at the start [m/s]; at rest where none is given."""


class HeaderSpec(TypedDict, total=False):
    """What the scene is about."""

    description: str
    """What is to be seen in it, in a sentence or two."""

    gravity: Sequence[float | str]
    """Acceleration of gravity [m/s²]."""

    seed: int
    """Seed of every random draw."""

    title: str
    """Title, for reports and recordings; the file's name where there is none."""


class InletSpec(TypedDict, total=False):
    """A feeder: pellets appear at a rate, at random places of a region."""

    end: float | str
    """Last moment of feeding [s]; never where none is given."""

    pellets: str
    """Name of the kind of pellets."""

    rate: float | str
    """How fast they come: "250 t/h" or "200 1/s"; a plain number is kg/s."""

    region: _ShapeSpec
    """Where pellets appear; each lies wholly inside."""

    start: float | str
    """First moment of feeding [s]; 0 where none is given."""

    velocity: Sequence[float | str]
    """Velocity as they appear [m/s]; at rest where none is given."""


class LimitsSpec(TypedDict, total=False):
    """When the run counts as failed."""

    energy_residual: float | str
    """Largest residual of the energy ledger over the energy that went through it [-]."""

    overlap_ratio: float | str
    """Largest overlap over the smaller radius of a contact [-]."""


class MaterialSpec(TypedDict, total=False):
    """An isotropic elastic material; give one of the two moduli."""

    density: float | str
    """Mass per volume of the body itself, not of its bulk [kg/m³]."""

    poisson_ratio: float
    """Poisson's ratio [-]."""

    shear_modulus: float | str
    """Shear modulus [Pa]."""

    true_youngs_modulus: float | str
    """Young's modulus of the real body, where the one above is softened to spare steps [Pa]; hits are then told at both."""

    youngs_modulus: float | str
    """Young's modulus [Pa]."""


class MeshSpec(TypedDict, total=False):
    """Triangles from a file of CAD: thin sheets, touched from both sides."""

    bake: float | str
    """Length of the cells of a grid of distances that stands in for the triangles, baked once at the start [m]; the mesh must be closed, and a pellet touches it at the nearest point only. The triangles themselves where none is given."""

    file: str
    """STL or OBJ file; its path is seen from the folder of the scene."""

    repair: bool
    """Whether corners are welded, and triangles without area and those that are there twice dropped; true where nothing is said."""

    rotate: RotateSpec
    """A turn about an axis."""

    scale: float
    """Factor of all lengths, beside the unit [-]."""

    translate: Sequence[float | str]
    """A move, after the turn [m]."""

    unit: _MeshUnitSpec
    """Unit of the numbers in the file; m where none is given."""

    weld: float | str
    """Distance up to which corners are one [m]; a millionth of the size of the mesh where none is given."""


class OutletSpec(TypedDict, total=False):
    """Where pellets leave: one whose center is inside is discharged."""

    region: _ShapeSpec
    """The region."""


class OutputSpec(TypedDict, total=False):
    """What is recorded and how often."""

    checkpoint_interval: float | str
    """Time by the wall clock between checkpoints, from which a run that was killed can be resumed [s]; 10 min where none is given, and 0 where only an interruption is to write one."""

    contacts: bool
    """Whether every contact is recorded in every frame; false where nothing is said."""

    frame_interval: float | str
    """Time between recorded frames [s]; chosen from the length of the run where none is given."""

    frames_around_worst_hits: float | str
    """Once the run is over, only frames are kept that are no farther than this from one of its 20 hardest hits, beside the first and the last [s]; all where nothing is said. With `frames_of_last`, the frames of both are kept."""

    frames_of_last: float | str
    """Once the run is over, only frames of its last stretch are kept, of this length, beside the first and the last [s]; all where nothing is said."""

    hits: bool
    """Whether every contact is followed from first touch to release and recorded; true where nothing is said."""

    hits_above: float | str
    """Greatest normal force from which on every hit is recorded in full [N]; a tenth of the strength's load where none is given. Hits harder than all before them of a pellet are recorded in any case."""

    meter_interval: float | str
    """Time between recorded meter readings [s]; chosen from the length of the run where none is given."""

    spheres_up_to: int
    """Number of pellets up to which they are recorded as spheres of true size [-]; 2000 where none is given."""


class PairSpec(TypedDict, total=False):
    """What is measured on two materials together."""

    friction: float
    """Coulomb's coefficient of sliding friction [-]."""

    restitution: float
    """Rebound speed over approach speed of a normal impact [-]."""

    rolling_damping: float
    """Damping of rolling and twisting by the law `spring-dashpot`, over critical damping [-]; 0.3 where none is given."""

    rolling_friction: float
    """Coefficient of rolling friction [-]."""

    stiffness: float | str
    """Stiffness by the normal law `linear` [N/m]."""

    surface_energy: float | str
    """Work that parting takes per area of contact, by the normal law `jkr` [J/m²]."""

    yield_pressure: float | str
    """Pressure in the middle of the contact at which the softer body yields, by the normal law `plastic` [Pa]."""


class PelletSpec(TypedDict, total=False):
    """Pellets of one material and one distribution of sizes."""

    diameter: _DiameterSpec
    """Diameter of all [m], or a table of a distribution."""

    material: str
    """Name of the material."""


class RotateSpec(TypedDict, total=False):
    """A turn about an axis, right-handed."""

    about: Sequence[float | str]
    """A point of the axis [m]; the origin where none is given."""

    angle: float | str
    """Angle [rad]."""

    axis: Sequence[float]
    """Direction of the axis, of any length [-]."""


class ScheduleSpec(TypedDict, total=False):
    """The moments at which a gate opens and closes."""

    at_first: _GateState
    """How it is at first."""

    changes: Sequence[float | str]
    """Moments at which it changes, rising [s]."""


class SkipSpec(TypedDict, total=False):
    """Work that may be left out because it changes nothing; false forces it back in."""

    distant_walls: bool
    """No wall evaluated for a pellet that cannot reach it; true where nothing is said."""

    free_flight: bool
    """Many steps at once while no pellet is near anything; true where nothing is said."""

    rotation: bool
    """No spin where no law acts on it; true where nothing is said."""


class StopSpec(TypedDict, total=False):
    """What ends the run before its time; any one is enough."""

    empty_after: float | str
    """No pellet is inside any more, after this moment [s]."""

    settled_after: float | str
    """The bed has come to rest, after this moment [s]."""

    settled_speed: float | str
    """Root mean square speed below which the bed counts as at rest [m/s]; 5 mm/s where none is given."""


class StrengthSpec(TypedDict, total=False):
    """What a pellet withstands."""

    load: float | str
    """Normal force at which half of the pellets break [N]."""


class SwingSpec(TypedDict, total=False):
    """A turn to and fro, in time with a vibration."""

    angle: float | str
    """Greatest turn, and the way it goes first, right-handed about the axis [rad]."""

    axis: Sequence[float]
    """Direction of the axis, of any length [-]."""

    center: Sequence[float | str]
    """A point of the axis, before the displacement [m]."""


class TimeSpec(TypedDict, total=False):
    """How long and in what steps; give at most one of `step` and `peak_force_error`."""

    end: float | str
    """Simulated time at which the run ends at the latest [s]."""

    integrator: _IntegratorSpec
    """How forces become motion; `located-verlet` where none is given."""

    peak_force_error: float | str
    """Error of the peak force of the fastest hit, from which the step is chosen [-]; 0.001 where none is given."""

    step: float | str
    """A fixed time step [s]."""


class WallSpec(TypedDict, total=False):
    """A piece of equipment."""

    closes_at: float | str
    """Moment at which it appears, as a gate that closes [s]."""

    material: str
    """Name of the material."""

    mesh: MeshSpec
    """Its triangles, from a file of CAD; this or `shape`."""

    motion: _MotionsSpec
    """How it moves, or a list of motions, the innermost first; it stays where nothing is said."""

    opens_at: float | str
    """Moment at which it vanishes, as a gate that opens [s]."""

    schedule: ScheduleSpec
    """More than one opening and closing; in place of `opens_at` and `closes_at`."""

    shape: _ShapeSpec
    """Its solid; this or `mesh`."""

    surface_velocity: Sequence[float | str]
    """Velocity of its surface beside its motion, as of a belt; only the part along the surface acts [m/s]."""


class MeterMassFlow(TypedDict, total=False):
    """Mass discharged through one outlet, and its rate."""

    kind: Literal['mass-flow']

    outlet: str
    """Name of the outlet."""


class MeterPlaneFlow(TypedDict, total=False):
    """Mass and pellets that pass a plane or a disc of it, by direction."""

    kind: Literal['plane-flow']

    normal: Sequence[float]
    """Direction that counts as forward, of any length [-]."""

    point: Sequence[float | str]
    """A point of the plane; the center of the disc [m]."""

    radius: float | str
    """Radius of the disc [m]; the whole plane where none is given."""


class MeterWallForce(TypedDict, total=False):
    """Force and torque of all pellets on one wall."""

    about: Sequence[float | str]
    """Point that the torque is about, which stays where the wall moves [m]; the center of the wall's box at the start where none is given, and the origin where the wall has no end."""

    kind: Literal['wall-force']

    wall: str
    """Name of the wall."""


class MeterWallImpacts(TypedDict, total=False):
    """Impacts on one wall and their energy, patch by patch."""

    cell: float | str
    """Width of the patches [m]."""

    kind: Literal['wall-impacts']

    least_speed: float | str
    """Speed of approach up to which a touch is no impact [m/s]; 0.1 m/s where none is given."""

    wall: str
    """Name of the wall."""


class MeterWear(TypedDict, total=False):
    """Wear of one wall by impacts and by sliding, patch by patch."""

    archard: float | str
    """Archard's coefficient over the hardness [1/Pa]; sliding does not wear where none is given."""

    cell: float | str
    """Width of the patches [m]."""

    finnie: float | str
    """Finnie's constant [1/Pa]; impacts do not wear where none is given."""

    kind: Literal['wear']

    least_speed: float | str
    """Speed of approach up to which a touch is no impact [m/s]; 0.1 m/s where none is given."""

    wall: str
    """Name of the wall."""


class MeterBox(TypedDict, total=False):
    """Density, velocity and agitation of the pellets whose centers are in a box."""

    kind: Literal['box']

    max: Sequence[float | str]
    """Highest corner [m]."""

    min: Sequence[float | str]
    """Lowest corner [m]."""


class MeterResidence(TypedDict, total=False):
    """How long pellets stay, from when they came to when they left through an outlet."""

    kind: Literal['residence']


class MeterHeap(TypedDict, total=False):
    """Angle of repose of a heap."""

    kind: Literal['heap']

    point: Sequence[float | str]
    """Where the axis of the heap meets the ground [m]."""

    up: Sequence[float]
    """Direction of the axis, out of the ground, of any length [-]; z where none is given."""


class MotionFixed(TypedDict, total=False):
    """It stays."""

    kind: Literal['fixed']


class MotionTranslating(TypedDict, total=False):
    """It moves evenly between two moments."""

    end: float | str
    """Last moment [s]; never where none is given."""

    kind: Literal['translating']

    start: float | str
    """First moment [s]; 0 where none is given."""

    velocity: Sequence[float | str]
    """Velocity [m/s]."""


class MotionRotating(TypedDict, total=False):
    """It turns evenly about an axis between two moments."""

    axis: Sequence[float]
    """Direction of the axis, of any length [-]."""

    center: Sequence[float | str]
    """A point of the axis [m]."""

    end: float | str
    """Last moment [s]; never where none is given."""

    kind: Literal['rotating']

    rate: float | str
    """Turn per time, right-handed about the axis [rad/s]."""

    start: float | str
    """First moment [s]; 0 where none is given."""


class MotionVibrating(TypedDict, total=False):
    """It swings to and fro, starting from rest position."""

    amplitude: Sequence[float | str]
    """Greatest displacement, and the way it goes first [m]."""

    frequency: float | str
    """Swings per time [Hz]."""

    kind: Literal['vibrating']

    swing: SwingSpec
    """How it turns to and fro in time with that; it does not where nothing is said."""


class MotionTable(TypedDict, total=False):
    """It follows a table of moments, and waits at the first row before and at the last row after."""

    angles: Sequence[float | str]
    """Turn about the axis at each moment, right-handed [rad]; none where none are given."""

    axis: Sequence[float]
    """Direction of the axis, of any length [-]; z where none is given."""

    center: Sequence[float | str]
    """A point of the axis, before the displacement [m]; the origin where none is given."""

    displacements: Sequence[Sequence[float | str]]
    """Displacement from the rest position at each moment [m]; none where none are given."""

    interpolation: _InterpolationSpec
    """How it goes from one row to the next; `linear` where nothing is said."""

    kind: Literal['table']

    moments: Sequence[float | str]
    """Moments of the rows, rising [s]."""


class ShapeHalfSpace(TypedDict, total=False):
    """Everything on the far side of a plane."""

    kind: Literal['half-space']

    normal: Sequence[float]
    """Direction out of the solid, of any length [-]."""

    point: Sequence[float | str]
    """A point of the plane [m]."""

    rotate: RotateSpec
    """A turn about an axis."""

    translate: Sequence[float | str]
    """A move, after the turn [m]."""


class ShapeSphere(TypedDict, total=False):
    """A ball."""

    center: Sequence[float | str]
    """Center [m]."""

    kind: Literal['sphere']

    radius: float | str
    """Radius [m]."""

    rotate: RotateSpec
    """A turn about an axis."""

    translate: Sequence[float | str]
    """A move, after the turn [m]."""


class ShapeCylinder(TypedDict, total=False):
    """A solid cylinder."""

    axis: Sequence[float]
    """Direction from the lower end to the upper, of any length [-]; z where none is given."""

    base: Sequence[float | str]
    """Center of the lower end [m]."""

    height: float | str
    """Length along the axis [m]."""

    kind: Literal['cylinder']

    radius: float | str
    """Radius [m]."""

    rotate: RotateSpec
    """A turn about an axis."""

    translate: Sequence[float | str]
    """A move, after the turn [m]."""


class ShapeCone(TypedDict, total=False):
    """A solid frustum."""

    axis: Sequence[float]
    """Direction from the lower end to the upper, of any length [-]; z where none is given."""

    base: Sequence[float | str]
    """Center of the lower end [m]."""

    height: float | str
    """Length along the axis [m]."""

    kind: Literal['cone']

    lower_radius: float | str
    """Radius of the lower end [m]."""

    rotate: RotateSpec
    """A turn about an axis."""

    translate: Sequence[float | str]
    """A move, after the turn [m]."""

    upper_radius: float | str
    """Radius of the upper end [m]."""


class ShapeTorus(TypedDict, total=False):
    """A ring, round in its cross-section."""

    axis: Sequence[float]
    """Direction of the axis of the ring, of any length [-]; z where none is given."""

    center: Sequence[float | str]
    """Center [m]."""

    kind: Literal['torus']

    ring_radius: float | str
    """Radius of the circle along the middle of the tube [m]."""

    rotate: RotateSpec
    """A turn about an axis."""

    translate: Sequence[float | str]
    """A move, after the turn [m]."""

    tube_radius: float | str
    """Radius of the tube, less than that of the ring [m]."""


class ShapeCapsule(TypedDict, total=False):
    """A solid cylinder with balls for ends."""

    axis: Sequence[float]
    """Direction from the lower ball to the upper, of any length [-]; z where none is given."""

    base: Sequence[float | str]
    """Center of the lower ball [m]."""

    height: float | str
    """Length along the axis between the centers of the balls [m]."""

    kind: Literal['capsule']

    radius: float | str
    """Radius of the cylinder and of the balls [m]."""

    rotate: RotateSpec
    """A turn about an axis."""

    translate: Sequence[float | str]
    """A move, after the turn [m]."""


class ShapeEllipsoid(TypedDict, total=False):
    """A ball stretched along the axes."""

    center: Sequence[float | str]
    """Center [m]."""

    half_axes: Sequence[float | str]
    """Half of each axis, along x, y and z [m]."""

    kind: Literal['ellipsoid']

    rotate: RotateSpec
    """A turn about an axis."""

    translate: Sequence[float | str]
    """A move, after the turn [m]."""


class ShapeBox(TypedDict, total=False):
    """A box along the axes; give `min` and `max`, or `center` and `size`."""

    center: Sequence[float | str]
    """Center [m]."""

    kind: Literal['box']

    max: Sequence[float | str]
    """Highest corner [m]."""

    min: Sequence[float | str]
    """Lowest corner [m]."""

    rotate: RotateSpec
    """A turn about an axis."""

    size: Sequence[float | str]
    """Sides along x, y and z [m]."""

    translate: Sequence[float | str]
    """A move, after the turn [m]."""


class ShapePlate(TypedDict, total=False):
    """A sheet that falls off toward +x by an angle, as the floor of a chute."""

    center: Sequence[float | str]
    """Middle of the upper face [m]."""

    heading: float | str
    """Turn about z after that, counterclockwise from above [rad]."""

    incline: float | str
    """Angle by which it falls off toward +x [rad]; level where none is given."""

    kind: Literal['plate']

    rotate: RotateSpec
    """A turn about an axis."""

    size: Sequence[float | str]
    """Length, width and thickness: along x, y and z before it is inclined [m]."""

    translate: Sequence[float | str]
    """A move, after the turn [m]."""


class ShapeRevolution(TypedDict, total=False):
    """A profile turned about the z axis."""

    base: Sequence[float | str]
    """Where the origin of the profile is put [m]."""

    kind: Literal['revolution']

    profile: Sequence[Sequence[float | str]]
    """Corners [radius, z] [m]: a closed polygon, or with `thickness` the middle line of a plate."""

    rotate: RotateSpec
    """A turn about an axis."""

    thickness: float | str
    """Thickness of the plate [m]."""

    translate: Sequence[float | str]
    """A move, after the turn [m]."""


class ShapeUnion(TypedDict, total=False):
    """All of several shapes together."""

    kind: Literal['union']

    of: Sequence[_ShapeSpec]
    """The parts."""

    rotate: RotateSpec
    """A turn about an axis."""

    translate: Sequence[float | str]
    """A move, after the turn [m]."""


class ShapeIntersection(TypedDict, total=False):
    """What several shapes have in common."""

    kind: Literal['intersection']

    of: Sequence[_ShapeSpec]
    """The parts."""

    rotate: RotateSpec
    """A turn about an axis."""

    translate: Sequence[float | str]
    """A move, after the turn [m]."""


class ShapeDifference(TypedDict, total=False):
    """One shape with another cut away."""

    kind: Literal['difference']

    minus: _ShapeSpec
    """What is taken away."""

    of: _ShapeSpec
    """What is cut."""

    rotate: RotateSpec
    """A turn about an axis."""

    translate: Sequence[float | str]
    """A move, after the turn [m]."""


class ShapeBlend(TypedDict, total=False):
    """All of several shapes together, with a fillet in the corners where they meet."""

    kind: Literal['blend']

    of: Sequence[_ShapeSpec]
    """The parts."""

    radius: float | str
    """Radius of the fillets [m]."""

    rotate: RotateSpec
    """A turn about an axis."""

    translate: Sequence[float | str]
    """A move, after the turn [m]."""


class ShapeMirror(TypedDict, total=False):
    """A shape seen in a plane mirror."""

    kind: Literal['mirror']

    normal: Sequence[float]
    """Direction across the plane, of any length [-]."""

    of: _ShapeSpec
    """What is mirrored."""

    point: Sequence[float | str]
    """A point of the plane [m]."""

    rotate: RotateSpec
    """A turn about an axis."""

    translate: Sequence[float | str]
    """A move, after the turn [m]."""


class ShapeScale(TypedDict, total=False):
    """A shape made larger or smaller, alike in all directions."""

    about: Sequence[float | str]
    """The point that stays where it is [m]; the origin where none is given."""

    factor: float
    """The factor of all lengths [-]."""

    kind: Literal['scale']

    of: _ShapeSpec
    """What is scaled."""

    rotate: RotateSpec
    """A turn about an axis."""

    translate: Sequence[float | str]
    """A move, after the turn [m]."""


class ShapeShell(TypedDict, total=False):
    """A shape hollowed out, closed on all sides; its outer face stays where it is."""

    kind: Literal['shell']

    of: _ShapeSpec
    """What is hollowed out."""

    rotate: RotateSpec
    """A turn about an axis."""

    thickness: float | str
    """Thickness of the wall that is left, less than half of the smallest side of the shape [m]."""

    translate: Sequence[float | str]
    """A move, after the turn [m]."""


class ShapeOffset(TypedDict, total=False):
    """A shape grown outward; its edges become round."""

    by: float | str
    """By how much [m]."""

    kind: Literal['offset']

    of: _ShapeSpec
    """What is grown."""

    rotate: RotateSpec
    """A turn about an axis."""

    translate: Sequence[float | str]
    """A move, after the turn [m]."""


class SceneSpec(TypedDict, total=False):
    """A scene of pelletflow: pellets, equipment, and what is to be computed."""

    contact: ContactSpec
    """Contact laws and neighbor search."""

    domain: DomainSpec
    """The box in which pellets may be; chosen from the scene where none is given."""

    expect: ExpectSpec
    """What a right run shows, by dotted key of its summary: `"mass.lost" = 0`."""

    fill: Mapping[str, FillSpec]
    """Pellets there at the start, by name."""

    inlets: Mapping[str, InletSpec]
    """Feeders by name."""

    limits: LimitsSpec
    """When the run counts as failed."""

    materials: Mapping[str, MaterialSpec]
    """Materials by name."""

    meters: Mapping[str, _MeterSpec]
    """What is measured, by name."""

    outlets: Mapping[str, OutletSpec]
    """Regions where pellets leave, by name."""

    output: OutputSpec
    """What is recorded and how often."""

    pairs: Mapping[str, PairSpec]
    """What two materials do together, by both names: `[pairs."pellet-steel"]`."""

    pellets: Mapping[str, PelletSpec]
    """Kinds of pellets by name."""

    scene: HeaderSpec
    """What the scene is about, its seed and its gravity."""

    schema_version: Literal[1]
    """Version of this format; 1."""

    skip: SkipSpec
    """Work that may be left out because it changes nothing."""

    stop: StopSpec
    """What ends the run before its time."""

    strength: StrengthSpec
    """What a pellet withstands."""

    time: TimeSpec
    """How long and in what steps."""

    walls: Mapping[str, WallSpec]
    """Equipment by name."""


if TYPE_CHECKING:
    _AxisSpec: TypeAlias = "Literal['x'] | Literal['y'] | Literal['z']"
    _DiameterSpec: TypeAlias = 'float | str | DistributionSpec'
    _EntrySpec: TypeAlias = 'float | str | bool | ConditionSpec | Mapping[str, _EntrySpec]'
    _GateState: TypeAlias = "Literal['closed'] | Literal['open']"
    _IntegratorSpec: TypeAlias = "Literal['semi-implicit-euler'] | Literal['velocity-verlet'] | Literal['located-verlet']"
    _InterpolationSpec: TypeAlias = "Literal['linear'] | Literal['smooth']"
    _MeshUnitSpec: TypeAlias = "Literal['m'] | Literal['cm'] | Literal['mm'] | Literal['in'] | Literal['ft']"
    _MeterSpec: TypeAlias = 'MeterMassFlow | MeterPlaneFlow | MeterWallForce | MeterWallImpacts | MeterWear | MeterBox | MeterResidence | MeterHeap'
    _MotionSpec: TypeAlias = 'MotionFixed | MotionTranslating | MotionRotating | MotionVibrating | MotionTable'
    _MotionsSpec: TypeAlias = '_MotionSpec | Sequence[_MotionSpec]'
    _NormalSpec: TypeAlias = "Literal['hertz'] | Literal['linear'] | Literal['plastic'] | Literal['jkr']"
    _PackingSpec: TypeAlias = "Literal['lattice'] | Literal['deposit']"
    _SearchSpec: TypeAlias = "Literal['auto'] | Literal['grid'] | Literal['hierarchical-grid'] | Literal['tree'] | Literal['all-pairs']"
    _ShapeSpec: TypeAlias = 'ShapeHalfSpace | ShapeSphere | ShapeCylinder | ShapeCone | ShapeTorus | ShapeCapsule | ShapeEllipsoid | ShapeBox | ShapePlate | ShapeRevolution | ShapeUnion | ShapeIntersection | ShapeDifference | ShapeBlend | ShapeMirror | ShapeScale | ShapeShell | ShapeOffset'
    _TangentialSpec: TypeAlias = "Literal['none'] | Literal['coulomb'] | Literal['mindlin'] | Literal['partial-slip']"
    _TurningSpec: TypeAlias = "Literal['none'] | Literal['constant-torque'] | Literal['spring-dashpot']"
