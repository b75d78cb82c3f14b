# Made by app/python/make_stubs.py from the module; not written by hand.
from collections.abc import Iterator, Sequence
from typing import Any, ClassVar, Optional, Union

import numpy
from numpy.typing import ArrayLike, NDArray

class AccelerationSample:
    """A sample of the robot's accelerometer."""
    def __init__(self, **values: Any) -> None:
        """From values by their names; the others keep their defaults. Units: those in `units`."""
    def __repr__(self) -> str:
        ...
    def as_dict(self) -> dict[str, Any]:
        """Every value by its name. Units: those in `units`."""
    help: ClassVar[dict[str, str]]
    @property
    def taken_ns(self) -> int:
        """at the sensor, on the touchpad's clock as well as it is known [ns]"""
    @taken_ns.setter
    def taken_ns(self, value: int) -> None: ...
    units: ClassVar[dict[str, str]]
    @property
    def x_g(self) -> float:
        """x, in multiples of standard gravity [g]"""
    @x_g.setter
    def x_g(self, value: float) -> None: ...
    @property
    def y_g(self) -> float:
        """y, in multiples of standard gravity [g]"""
    @y_g.setter
    def y_g(self, value: float) -> None: ...
    @property
    def z_g(self) -> float:
        """z, in multiples of standard gravity [g]"""
    @z_g.setter
    def z_g(self, value: float) -> None: ...

class BridgeInput:
    """The load cell's newest reading, with its time."""
    def __init__(self, **values: Any) -> None:
        """From values by their names; the others keep their defaults. Units: those in `units`."""
    def __repr__(self) -> str:
        ...
    def as_dict(self) -> dict[str, Any]:
        """Every value by its name. Units: those in `units`."""
    @property
    def count(self) -> int:
        """values so far; 0: there was none yet [1]"""
    @count.setter
    def count(self, value: int) -> None: ...
    help: ClassVar[dict[str, str]]
    def set(self, taken_ns: int, **values: Any) -> None:
        """A new value, taken at taken_ns [ns]: those named are changed. Units: those in `units`."""
    @property
    def taken_ns(self) -> int:
        """when it was taken [ns]"""
    @taken_ns.setter
    def taken_ns(self, value: int) -> None: ...
    units: ClassVar[dict[str, str]]
    @property
    def value_mV_per_V(self) -> float:
        """of the load cell's bridge, not calibrated [mV/V]"""
    @value_mV_per_V.setter
    def value_mV_per_V(self, value: float) -> None: ...

class Contact:
    """One body and one haptic point that touches it."""
    def __init__(self, mesh: Mesh, **values: Any) -> None:
        """With the keys of a body of a scene file, such as contact="proxy", stiffness_N_per_mm=0.8 [N/mm], radius_mm
        [mm].
        """
    def reset(self) -> None:
        """Back to before the first touch. Units: none."""
    def run(self, probe_mm: ArrayLike, period_s: float = 0.001) -> NDArray[numpy.float64]:
        """The force [N], shape (n, 3), on a point that goes this way [mm], shape (n, 3), one place each period_s [s]. A
        place that is not finite touches nothing. A proxy goes on where the last call left it: for another way,
        reset() first. Other threads go on meanwhile.
        """

class Error(Exception):
    """Something could not be done; the text names the thing, its value and what was expected."""

class Event:
    """What a step reports."""
    def __init__(self, **values: Any) -> None:
        """From values by their names; the others keep their defaults. Units: those in `units`."""
    def __repr__(self) -> str:
        ...
    def as_dict(self) -> dict[str, Any]:
        """Every value by its name. Units: those in `units`."""
    help: ClassVar[dict[str, str]]
    @property
    def id(self) -> Optional[str]:
        """Id of the parameter that changed or was refused; None: it is another event, or this library has no such
        parameter [—]
        """
    @property
    def index(self) -> int:
        """of a parameter's event: as in /inputs/changes [1]"""
    @index.setter
    def index(self, value: int) -> None: ...
    @property
    def kind(self) -> EventKind:
        """EventKind: its number [1]"""
    @kind.setter
    def kind(self, value: EventKind) -> None: ...
    @property
    def lack(self) -> Fault:
        """Fault: what is missing; 0: nothing [1]"""
    @lack.setter
    def lack(self, value: Fault) -> None: ...
    @property
    def state(self) -> SafetyState:
        """SafetyState: of state_changed and arm_refused; otherwise 0 [1]"""
    @state.setter
    def state(self, value: SafetyState) -> None: ...
    units: ClassVar[dict[str, str]]
    @property
    def value(self) -> float:
        """of the event, where it has one [1]"""
    @value.setter
    def value(self, value: float) -> None: ...

class EventKind:
    """What a step reports; files store the number."""
    def __eq__(self, other: object) -> Any:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    def __init__(self, value: int) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: object) -> Any:
        ...
    def __repr__(self) -> str:
        ...
    arm_refused: ClassVar[EventKind]
    law_contradicted: ClassVar[EventKind]
    @property
    def name(self) -> str: ...
    parameter_changed: ClassVar[EventKind]
    parameter_refused: ClassVar[EventKind]
    robot_command: ClassVar[EventKind]
    state_changed: ClassVar[EventKind]
    tare_done: ClassVar[EventKind]
    tare_failed: ClassVar[EventKind]
    target_clamped: ClassVar[EventKind]
    time_reversed: ClassVar[EventKind]
    @property
    def value(self) -> int: ...

class EventRow:
    """What a step reported, with its time."""
    def __repr__(self) -> str:
        ...
    def as_dict(self) -> dict[str, Any]:
        """Every value by its name. Units: those in `units`."""
    help: ClassVar[dict[str, str]]
    @property
    def id(self) -> Optional[str]:
        """Id of the parameter that changed or was refused; None: it is another event, or this library has no such
        parameter [—]
        """
    @property
    def index(self) -> int:
        """of a parameter's event: as in /inputs/changes [1]"""
    @index.setter
    def index(self, value: int) -> None: ...
    @property
    def kind(self) -> EventKind:
        """EventKind: its number [1]"""
    @kind.setter
    def kind(self, value: EventKind) -> None: ...
    @property
    def lack(self) -> Fault:
        """Fault: what is missing; 0: nothing [1]"""
    @lack.setter
    def lack(self, value: Fault) -> None: ...
    @property
    def state(self) -> SafetyState:
        """SafetyState: of state_changed and arm_refused; otherwise 0 [1]"""
    @state.setter
    def state(self, value: SafetyState) -> None: ...
    units: ClassVar[dict[str, str]]
    @property
    def value(self) -> float:
        """of the event, where it has one [1]"""
    @value.setter
    def value(self, value: float) -> None: ...
    @property
    def when_ns(self) -> int:
        """of the step [ns]"""
    @when_ns.setter
    def when_ns(self, value: int) -> None: ...

class Fault:
    """What is missing or went wrong; files store the number."""
    def __eq__(self, other: object) -> Any:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    def __init__(self, value: int) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: object) -> Any:
        ...
    def __repr__(self) -> str:
        ...
    bridge_invalid: ClassVar[Fault]
    bridge_stale: ClassVar[Fault]
    camera_blind: ClassVar[Fault]
    camera_stale: ClassVar[Fault]
    ir_invalid: ClassVar[Fault]
    ir_stale: ClassVar[Fault]
    motors_stale: ClassVar[Fault]
    @property
    def name(self) -> str: ...
    no_target: ClassVar[Fault]
    none: ClassVar[Fault]
    operator_silent: ClassVar[Fault]
    robot_closed: ClassVar[Fault]
    robot_frozen: ClassVar[Fault]
    robot_lost: ClassVar[Fault]
    robot_waiting: ClassVar[Fault]
    step_gap: ClassVar[Fault]
    steps_missed: ClassVar[Fault]
    @property
    def value(self) -> int: ...

class FingerDetection:
    """What the finger detector says of a picture."""
    def __init__(self, **values: Any) -> None:
        """From values by their names; the others keep their defaults. Units: those in `units`."""
    def __repr__(self) -> str:
        ...
    @property
    def area_mm2(self) -> float:
        """the same on the untouched cloth's plane, by the camera's scale; none where the picture shows no cloth [mm²]"""
    @area_mm2.setter
    def area_mm2(self, value: float) -> None: ...
    @property
    def area_px(self) -> float:
        """of the camera's picture (thesis mode: of its 160 × 120 picture); also without contact [px]"""
    @area_px.setter
    def area_px(self, value: float) -> None: ...
    def as_dict(self) -> dict[str, Any]:
        """Every value by its name. Units: those in `units`."""
    @property
    def contact(self) -> bool:
        """1: a finger presses the cloth; the position is meaningful only then [1]"""
    @contact.setter
    def contact(self, value: bool) -> None: ...
    help: ClassVar[dict[str, str]]
    @property
    def quality(self) -> float:
        """0 useless … 1 as good as it gets [1]"""
    @quality.setter
    def quality(self, value: float) -> None: ...
    @property
    def reason(self) -> FingerReason:
        """FingerReason: why there is a finger or none [1]"""
    @reason.setter
    def reason(self, value: FingerReason) -> None: ...
    units: ClassVar[dict[str, str]]
    @property
    def x_mm(self) -> float:
        """in the touchpad's frame, x right; without contact 0 (thesis mode: the last) [mm]"""
    @x_mm.setter
    def x_mm(self, value: float) -> None: ...
    @property
    def x_px(self) -> float:
        """centroid in the camera's full picture, x right; without contact 0 (thesis mode: the last) [px]"""
    @x_px.setter
    def x_px(self, value: float) -> None: ...
    @property
    def y_mm(self) -> float:
        """in the touchpad's frame, y back; without contact 0 (thesis mode: the last) [mm]"""
    @y_mm.setter
    def y_mm(self, value: float) -> None: ...
    @property
    def y_px(self) -> float:
        """centroid in the camera's full picture, y down; without contact 0 (thesis mode: the last) [px]"""
    @y_px.setter
    def y_px(self, value: float) -> None: ...

class FingerDetector:
    """Finds the finger in pictures of the cloth seen from below. It learns the light and follows the finger from picture
    to picture.
    """
    def __init__(self, parameters: Optional[Parameters] = None) -> None:
        """By the parameters sensing.finger_… and sensing.roi_… Units: their own."""
    def detect(self, picture: ArrayLike) -> FingerDetection:
        """Where the finger is in a picture, uint8 of shape (height, width) or (height, width, 3): position [mm], area
        [px] and [mm²]. A picture that shows none says why.
        """
    def detect_all(self, pictures: Sequence[Any]) -> dict[str, Any]:
        """One after the other; columns by name, as FingerDetection's values, in [mm], [px] and [mm²]. Other threads go
        on meanwhile.
        """
    def overlay(self) -> NDArray[numpy.uint8]:
        """Of the last picture's region: 255 where the finger is, 128 where else it is dark, 0 for cloth [grey value]."""
    @property
    def region_px(self) -> tuple[Any, ...]:
        """Left edge, upper edge, width and height of what was looked at in the last picture [px]"""
    def reset(self) -> None:
        """Forgets light and last finger, as for a picture on its own. Units: none."""

class FingerInput:
    """The newest picture's result, with its time."""
    def __init__(self, **values: Any) -> None:
        """From values by their names; the others keep their defaults. Units: those in `units`."""
    def __repr__(self) -> str:
        ...
    @property
    def area_mm2(self) -> float:
        """the same on the untouched cloth's plane, by the camera's scale; none where the picture shows no cloth [mm²]"""
    @area_mm2.setter
    def area_mm2(self, value: float) -> None: ...
    @property
    def area_px(self) -> float:
        """of the camera's picture (thesis mode: of its 160 × 120 picture); also without contact [px]"""
    @area_px.setter
    def area_px(self, value: float) -> None: ...
    def as_dict(self) -> dict[str, Any]:
        """Every value by its name. Units: those in `units`."""
    @property
    def contact(self) -> bool:
        """1: a finger presses the cloth; the position is meaningful only then [1]"""
    @contact.setter
    def contact(self, value: bool) -> None: ...
    @property
    def count(self) -> int:
        """values so far; 0: there was none yet [1]"""
    @count.setter
    def count(self, value: int) -> None: ...
    help: ClassVar[dict[str, str]]
    @property
    def quality(self) -> float:
        """0 useless … 1 as good as it gets [1]"""
    @quality.setter
    def quality(self, value: float) -> None: ...
    @property
    def reason(self) -> FingerReason:
        """FingerReason: why there is a finger or none [1]"""
    @reason.setter
    def reason(self, value: FingerReason) -> None: ...
    def set(self, taken_ns: int, **values: Any) -> None:
        """A new value, taken at taken_ns [ns]: those named are changed. Units: those in `units`."""
    @property
    def taken_ns(self) -> int:
        """when it was taken [ns]"""
    @taken_ns.setter
    def taken_ns(self, value: int) -> None: ...
    units: ClassVar[dict[str, str]]
    @property
    def x_mm(self) -> float:
        """in the touchpad's frame, x right; without contact 0 (thesis mode: the last) [mm]"""
    @x_mm.setter
    def x_mm(self, value: float) -> None: ...
    @property
    def x_px(self) -> float:
        """centroid in the camera's full picture, x right; without contact 0 (thesis mode: the last) [px]"""
    @x_px.setter
    def x_px(self, value: float) -> None: ...
    @property
    def y_mm(self) -> float:
        """in the touchpad's frame, y back; without contact 0 (thesis mode: the last) [mm]"""
    @y_mm.setter
    def y_mm(self, value: float) -> None: ...
    @property
    def y_px(self) -> float:
        """centroid in the camera's full picture, y down; without contact 0 (thesis mode: the last) [px]"""
    @y_px.setter
    def y_px(self, value: float) -> None: ...

class FingerReason:
    """Why there is a finger in a picture, or none; files store the number."""
    def __eq__(self, other: object) -> Any:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    def __init__(self, value: int) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: object) -> Any:
        ...
    def __repr__(self) -> str:
        ...
    at_edge: ClassVar[FingerReason]
    black_picture: ClassVar[FingerReason]
    blurred: ClassVar[FingerReason]
    flat_picture: ClassVar[FingerReason]
    found: ClassVar[FingerReason]
    light_unknown: ClassVar[FingerReason]
    @property
    def name(self) -> str: ...
    no_finger: ClassVar[FingerReason]
    no_picture: ClassVar[FingerReason]
    saturated: ClassVar[FingerReason]
    several: ClassVar[FingerReason]
    too_small: ClassVar[FingerReason]
    @property
    def value(self) -> int: ...

class Inputs:
    """All that reaches a step; nothing else does."""
    def __init__(self, **values: Any) -> None:
        """From values by their names; the others keep their defaults. Units: those in `units`."""
    def __repr__(self) -> str:
        ...
    @property
    def accelerations(self) -> tuple[Any, ...]:
        """Samples that came since the last step, a tuple of AccelerationSample, set as a whole [g]"""
    @accelerations.setter
    def accelerations(self, value: Sequence[Any]) -> None: ...
    def as_dict(self) -> dict[str, Any]:
        """Every value by its name. Units: those in `units`."""
    @property
    def bridge(self) -> BridgeInput:
        """The load cell [mV/V]"""
    @bridge.setter
    def bridge(self, value: BridgeInput) -> None: ...
    @property
    def changes(self) -> tuple[Any, ...]:
        """Live parameters changed since the last step, a tuple of ParameterChange, set as a whole [each in its unit]"""
    @changes.setter
    def changes(self, value: Sequence[Any]) -> None: ...
    @property
    def commands(self) -> tuple[Any, ...]:
        """Commands of the operator since the last step, a tuple of OperatorCommand, set as a whole [each in its unit]"""
    @commands.setter
    def commands(self, value: Sequence[Any]) -> None: ...
    def copy(self) -> Inputs:
        """The same inputs once more. Units: none."""
    @property
    def finger(self) -> FingerInput:
        """What the finger detector says [each in its unit]"""
    @finger.setter
    def finger(self, value: FingerInput) -> None: ...
    help: ClassVar[dict[str, str]]
    @property
    def ir(self) -> IrInput:
        """The distance sensors [ADC code]"""
    @ir.setter
    def ir(self, value: IrInput) -> None: ...
    @property
    def missed_cycles(self) -> int:
        """cycles of the haptic loop that got no step, since its start [1]"""
    @missed_cycles.setter
    def missed_cycles(self, value: int) -> None: ...
    @property
    def motor_reference(self) -> ReferenceInput:
        """Where the robot wants the motors [tick]"""
    @motor_reference.setter
    def motor_reference(self, value: ReferenceInput) -> None: ...
    @property
    def motors(self) -> MotorInput:
        """The motors' report [each in its unit]"""
    @motors.setter
    def motors(self, value: MotorInput) -> None: ...
    @property
    def now_ns(self) -> int:
        """when the step was [ns]"""
    @now_ns.setter
    def now_ns(self, value: int) -> None: ...
    @property
    def phase(self) -> LinkPhase:
        """LinkPhase: how the robot's link stands [1]"""
    @phase.setter
    def phase(self, value: LinkPhase) -> None: ...
    @property
    def robot_commands(self) -> tuple[Any, ...]:
        """Commands of the robot's operator since the last step, a tuple of RobotCommand, set as a whole [—]"""
    @robot_commands.setter
    def robot_commands(self, value: Sequence[Any]) -> None: ...
    @property
    def robot_state(self) -> RobotInput:
        """The robot's state [each in its unit]"""
    @robot_state.setter
    def robot_state(self, value: RobotInput) -> None: ...
    units: ClassVar[dict[str, str]]

class InvalidValue(Error, ValueError):
    """A value that was given is not possible; the text names it and what is."""

class IrInput:
    """The newest codes of the distance sensors, with their time."""
    def __init__(self, **values: Any) -> None:
        """From values by their names; the others keep their defaults. Units: those in `units`."""
    def __repr__(self) -> str:
        ...
    def as_dict(self) -> dict[str, Any]:
        """Every value by its name. Units: those in `units`."""
    @property
    def count(self) -> int:
        """values so far; 0: there was none yet [1]"""
    @count.setter
    def count(self, value: int) -> None: ...
    @property
    def counts(self) -> tuple[Any, ...]:
        """12 bit, 0 to 4095, in the profile's order of sensors [ADC code]"""
    @counts.setter
    def counts(self, value: Sequence[Any]) -> None: ...
    help: ClassVar[dict[str, str]]
    def set(self, taken_ns: int, **values: Any) -> None:
        """A new value, taken at taken_ns [ns]: those named are changed. Units: those in `units`."""
    @property
    def taken_ns(self) -> int:
        """when it was taken [ns]"""
    @taken_ns.setter
    def taken_ns(self, value: int) -> None: ...
    units: ClassVar[dict[str, str]]

class LinkPhase:
    """How the robot's link stands; files store the number."""
    def __eq__(self, other: object) -> Any:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    def __init__(self, value: int) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: object) -> Any:
        ...
    def __repr__(self) -> str:
        ...
    closed: ClassVar[LinkPhase]
    lost: ClassVar[LinkPhase]
    @property
    def name(self) -> str: ...
    none: ClassVar[LinkPhase]
    paused: ClassVar[LinkPhase]
    running: ClassVar[LinkPhase]
    @property
    def value(self) -> int: ...
    waiting: ClassVar[LinkPhase]

class LinkRow:
    """The robot's link, as it was once a second."""
    def __repr__(self) -> str:
        ...
    def as_dict(self) -> dict[str, Any]:
        """Every value by its name. Units: those in `units`."""
    help: ClassVar[dict[str, str]]
    @property
    def jitter_ms(self) -> float:
        """how much the way here varies [ms]"""
    @jitter_ms.setter
    def jitter_ms(self, value: float) -> None: ...
    @property
    def loss_percent(self) -> float:
        """messages of the robot's that did not come [%]"""
    @loss_percent.setter
    def loss_percent(self, value: float) -> None: ...
    @property
    def refused(self) -> int:
        """messages that came and were not taken, since the start [1]"""
    @refused.setter
    def refused(self, value: int) -> None: ...
    @property
    def round_trip_ms(self) -> float:
        """to the robot and back [ms]"""
    @round_trip_ms.setter
    def round_trip_ms(self, value: float) -> None: ...
    @property
    def states_received(self) -> int:
        """messages that came, since the start [1]"""
    @states_received.setter
    def states_received(self, value: int) -> None: ...
    @property
    def touches_sent(self) -> int:
        """messages sent, since the start [1]"""
    @touches_sent.setter
    def touches_sent(self, value: int) -> None: ...
    units: ClassVar[dict[str, str]]
    @property
    def when_ns(self) -> int:
        """when it was asked [ns]"""
    @when_ns.setter
    def when_ns(self, value: int) -> None: ...

class Mesh:
    """A triangle mesh that can be touched."""
    def __init__(self, vertices_mm: ArrayLike, triangles: ArrayLike) -> None:
        """Of vertices [mm], shape (n, 3), and triangles, three numbers of vertices each, counter-clockwise from outside.
        Mends what can be mended.
        """
    @property
    def area_mm2(self) -> float:
        """[mm²]"""
    @property
    def holes(self) -> int:
        """Closed loops of edges with one triangle [1]"""
    @staticmethod
    def open(path: Any, unit: str = 'mm') -> Mesh:
        """An OBJ, STL or PLY file; `unit` of its lengths: mm, cm, m or in."""
    @property
    def pieces(self) -> int:
        """Not connected [1]"""
    @property
    def triangles(self) -> NDArray[numpy.uint32]:
        """Numbers of vertices, shape (n, 3), the mesh's own memory [—]"""
    @property
    def vertices_mm(self) -> NDArray[numpy.float64]:
        """Shape (n, 3), the mesh's own memory [mm]"""
    @property
    def volume_mm3(self) -> float:
        """Of closed pieces [mm³]"""

class MotorCommand:
    """What is written to the two motors."""
    def __init__(self, **values: Any) -> None:
        """From values by their names; the others keep their defaults. Units: those in `units`."""
    def __repr__(self) -> str:
        ...
    @property
    def active(self) -> bool:
        """0: the motors are de-energised [1]"""
    @active.setter
    def active(self, value: bool) -> None: ...
    def as_dict(self) -> dict[str, Any]:
        """Every value by its name. Units: those in `units`."""
    help: ClassVar[dict[str, str]]
    @property
    def reference_ticks(self) -> tuple[Any, ...]:
        """where each motor is to turn [tick]"""
    @reference_ticks.setter
    def reference_ticks(self, value: Sequence[Any]) -> None: ...
    units: ClassVar[dict[str, str]]
    @property
    def vibration_duty_percent(self) -> tuple[Any, ...]:
        """−100 to 100 for each motor, added to the position loop's own duty [%]"""
    @vibration_duty_percent.setter
    def vibration_duty_percent(self, value: Sequence[Any]) -> None: ...

class MotorInput:
    """What the motors last reported, with its time."""
    def __init__(self, **values: Any) -> None:
        """From values by their names; the others keep their defaults. Units: those in `units`."""
    def __repr__(self) -> str:
        ...
    def as_dict(self) -> dict[str, Any]:
        """Every value by its name. Units: those in `units`."""
    @property
    def count(self) -> int:
        """values so far; 0: there was none yet [1]"""
    @count.setter
    def count(self, value: int) -> None: ...
    @property
    def current_mA(self) -> tuple[Any, ...]:
        """of each motor, signed [mA]"""
    @current_mA.setter
    def current_mA(self, value: Sequence[Any]) -> None: ...
    @property
    def encoder_counts(self) -> tuple[Any, ...]:
        """of each motor, 0 to 4095 [count]"""
    @encoder_counts.setter
    def encoder_counts(self, value: Sequence[Any]) -> None: ...
    help: ClassVar[dict[str, str]]
    @property
    def position_duty_known(self) -> bool:
        """0: the board closes its own loop unseen [1]"""
    @position_duty_known.setter
    def position_duty_known(self, value: bool) -> None: ...
    @property
    def position_duty_percent(self) -> tuple[Any, ...]:
        """share of each motor's drive that the board's position loop uses [%]"""
    @position_duty_percent.setter
    def position_duty_percent(self, value: Sequence[Any]) -> None: ...
    def set(self, taken_ns: int, **values: Any) -> None:
        """A new value, taken at taken_ns [ns]: those named are changed. Units: those in `units`."""
    @property
    def taken_ns(self) -> int:
        """when it was taken [ns]"""
    @taken_ns.setter
    def taken_ns(self, value: int) -> None: ...
    units: ClassVar[dict[str, str]]

class Note:
    """A line of the recording's own log."""
    @property
    def kind(self) -> NoteKind:
        """What it is [—]"""
    @property
    def text(self) -> str:
        """What it says [—]"""
    @property
    def time_s(self) -> float:
        """From the recording's start [s]"""

class NoteKind:
    """What a line of a recording's log is; files store the number."""
    def __eq__(self, other: object) -> Any:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    def __init__(self, value: int) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: object) -> Any:
        ...
    def __repr__(self) -> str:
        ...
    alarm: ClassVar[NoteKind]
    bookmark: ClassVar[NoteKind]
    @property
    def name(self) -> str: ...
    note: ClassVar[NoteKind]
    trial_end: ClassVar[NoteKind]
    trial_start: ClassVar[NoteKind]
    @property
    def value(self) -> int: ...

class OperatorAction:
    """What an operator asks for; files store the number."""
    def __eq__(self, other: object) -> Any:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    def __init__(self, value: int) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: object) -> Any:
        ...
    def __repr__(self) -> str:
        ...
    arm: ClassVar[OperatorAction]
    fell_silent: ClassVar[OperatorAction]
    @property
    def name(self) -> str: ...
    stop: ClassVar[OperatorAction]
    tare: ClassVar[OperatorAction]
    target_by_hand: ClassVar[OperatorAction]
    target_from_robot: ClassVar[OperatorAction]
    @property
    def value(self) -> int: ...

class OperatorCommand:
    """A command of the operator."""
    def __init__(self, **values: Any) -> None:
        """From values by their names; the others keep their defaults. Units: those in `units`."""
    def __repr__(self) -> str:
        ...
    @property
    def action(self) -> OperatorAction:
        """OperatorAction: its number [1]"""
    @action.setter
    def action(self, value: OperatorAction) -> None: ...
    def as_dict(self) -> dict[str, Any]:
        """Every value by its name. Units: those in `units`."""
    help: ClassVar[dict[str, str]]
    units: ClassVar[dict[str, str]]
    @property
    def value(self) -> float:
        """of the action, where it has one [1]"""
    @value.setter
    def value(self, value: float) -> None: ...

class Outputs:
    """What came of a step."""
    def copy(self) -> Outputs:
        """The same outputs once more. Units: none."""
    @property
    def events(self) -> list[Event]:
        """What the step reports [each in its unit]"""
    @property
    def faults(self) -> list[Fault]:
        """All that is missing for Active, the most urgent first [—]"""
    @property
    def in_contact(self) -> bool:
        """Whether a finger touches [—]"""
    @property
    def motors(self) -> MotorCommand:
        """What is written to the motors [each in its unit]"""
    @property
    def telemetry(self) -> TelemetrySample:
        """The step's sample [each in its unit]"""
    @property
    def touch_force_N(self) -> float:
        """The force sent to the robot [N]"""
    @property
    def touch_mm(self) -> tuple[Any, ...]:
        """The position sent to the robot: x right, y back, z up [mm]"""

PREDICTORS: tuple[str, ...]

class ParameterChange:
    """A live parameter's new value."""
    def __init__(self, **values: Any) -> None:
        """From values by their names; the others keep their defaults. Units: those in `units`."""
    def __repr__(self) -> str:
        ...
    def as_dict(self) -> dict[str, Any]:
        """Every value by its name. Units: those in `units`."""
    help: ClassVar[dict[str, str]]
    @property
    def id(self) -> Optional[str]:
        """Id of the parameter; None: this library has no such parameter [—]"""
    @property
    def index(self) -> int:
        """the parameter's line in the file's own profile, from 0; as read, its number here, 65535: none [1]"""
    @index.setter
    def index(self, value: int) -> None: ...
    units: ClassVar[dict[str, str]]
    @property
    def value(self) -> float:
        """new value in the parameter's own unit [1]"""
    @value.setter
    def value(self, value: float) -> None: ...

class ParameterInfo:
    """What a parameter means, and what it may be."""
    @property
    def allowed(self) -> str:
        """What may be given, as a phrase [—]"""
    @property
    def choices(self) -> tuple[Any, ...]:
        """The words of a choice [—]"""
    @property
    def default(self) -> Any:
        """Value of a new set [in its unit]"""
    @property
    def help(self) -> str:
        """One sentence [—]"""
    @property
    def id(self) -> str:
        """"module.name" [—]"""
    @property
    def kind(self) -> str:
        """real, integer, boolean, choice, list or text [—]"""
    @property
    def live(self) -> bool:
        """Whether it may change while the step renders [—]"""
    @property
    def maximum(self) -> Any:
        """Largest value [in its unit]"""
    @property
    def minimum(self) -> Any:
        """Smallest value [in its unit]"""
    @property
    def name(self) -> str:
        """Short, for people; empty where it never changes live [—]"""
    @property
    def unit(self) -> str:
        """Unit of the value; "1" for a plain number [—]"""

class Parameters:
    """The step's parameters: a mapping from id ("control.kp") to value. Each is checked when it is set: InvalidValue
    names id, value and range.
    """
    def __contains__(self, id: Any) -> bool:
        ...
    def __eq__(self, other: object) -> Any:
        ...
    def __getitem__(self, id: str) -> Any:
        ...
    __hash__: ClassVar[None]  # type: ignore[assignment]
    def __init__(self, values: Optional[dict[str, Any]] = None) -> None:
        """The defaults, and these values in their place. Units: each parameter's own."""
    def __iter__(self) -> Iterator[Any]:
        ...
    def __len__(self) -> int:
        ...
    def __setitem__(self, id: str, value: Any) -> None:
        ...
    def copy(self) -> Parameters:
        """A set of its own with the same values. Units: none."""
    @staticmethod
    def from_profile(text: str, name: str = 'profile') -> Parameters:
        """The defaults, and in their place what a TOML text of the step's parameters says; `name` begins each message.
        Units: each parameter's own.
        """
    def get(self, id: str, default: Optional[Any] = None) -> Any:
        """Value of a parameter; `default` when there is none of this id. Units: the parameter's own."""
    @staticmethod
    def info(id: str) -> ParameterInfo:
        """What a parameter means, and what it may be. Units: none."""
    def items(self) -> list[tuple[str, Any]]:
        """(Id, value) of all parameters, in that order. Units: each parameter's own."""
    def keys(self) -> list[str]:
        """Ids of all parameters, in the order of the profile. Units: none."""
    def profile(self) -> str:
        """All of them as the TOML text of a profile. Units: each in its comment."""
    def update(self, values: dict[str, Any]) -> None:
        """Sets several; none of them when one is not possible. Units: each parameter's own."""
    def values(self) -> list[Any]:
        """Values of all parameters, in the order of their ids. Units: each parameter's own."""

class Picture:
    """A picture of the camera, and what the detector said of it."""
    @property
    def finger(self) -> FingerDetection:
        """What the detector said [each in its unit]"""
    @property
    def number(self) -> int:
        """The camera's [1]"""
    @property
    def region(self) -> Any:
        """The region of interest exactly as the detector saw it. None: it lay outside of the picture [grey value, 0 to
        255]
        """
    @property
    def region_px(self) -> tuple[Any, ...]:
        """Left edge, upper edge, width and height of the region in the whole picture [px]"""
    @property
    def time_s(self) -> float:
        """When it was taken, from the recording's start [s]"""
    @property
    def whole(self) -> Any:
        """Grey values (height, width), or blue, green, red; what lies around the region is as compressed, perhaps of an
        earlier picture. None: there is none [grey value, 0 to 255]
        """

class Pipeline:
    """The pure step: all haptic behaviour in one function without I/O, threads or clock. The same parameters and inputs
    give the same outputs bit for bit.
    """
    def __init__(self, parameters: Optional[Parameters] = None, surface: Optional[Surface] = None, scene: Optional[Scene] = None) -> None:
        """With these parameters, and what is felt without a robot: a stored surface, or a scene in the robot's place,
        opened for the rate of the steps, texture.sample_rate_Hz. Units: each parameter's own.
        """
    @staticmethod
    def of(recording: RecordingFile) -> Pipeline:
        """As it stood before the first row of an open recording: its parameters, its surface or scene and its state.
        Units: each parameter's own.
        """
    @property
    def parameters(self) -> Parameters:
        """As they are now, live changes and tare included: a copy [each in its unit]"""
    def restore_state(self, state: bytes) -> None:
        """Continues from a saved step of a pipeline with the same parameters, live ones apart; Error, and the pipeline
        as it was, for other bytes. Units: none.
        """
    def save_state(self) -> bytes:
        """All that the next steps depend on, as bytes. Units: none."""
    def step(self, inputs: Inputs, state: Optional[bytes] = None) -> Outputs:
        """One step, nominally every millisecond of inputs.now_ns [ns]; from a saved state, when one is given, instead of
        from where it stands. Units: those of the values.
        """

class Predictor:
    """Where a hand is now, from messages of where it was. A message comes late, irregularly, twice, out of order or not
    at all.
    """
    def __init__(self, name: str = 'default', axes: int = 1, period_s: float = 0.0) -> None:
        """One of PREDICTORS, for 1 to 3 axes; period_s [s] of the sender's messages, 0: not known."""
    def end_motion(self) -> None:
        """The hand was lifted; the next message begins another motion. Units: none."""
    def message(self, date_s: float, position_mm: ArrayLike) -> None:
        """A message has arrived: at date_s [s] the hand was at position_mm [mm]. What is not finite is ignored."""
    def predict(self, time_s: float) -> NDArray[numpy.float64]:
        """The position [mm] at time_s [s]; always finite, zeros before the first message."""
    def velocity(self, time_s: float) -> NDArray[numpy.float64]:
        """The prediction's rate of change [mm/s] at time_s [s]."""

class RecordedStep:
    """What went into a step and what came out."""
    @property
    def events(self) -> list[Event]:
        """What the step reported [each in its unit]"""
    @property
    def inputs(self) -> Inputs:
        """As the step had them, but for what is `missing` [each in its unit]"""
    @property
    def missing(self) -> tuple[Any, ...]:
        """Paths of the tables that a recovered recording lost for this step: what they held is as if nothing had ever
        come. Empty: none [—]
        """
    @property
    def motors(self) -> MotorCommand:
        """As written to the motors [each in its unit]"""
    @property
    def telemetry(self) -> TelemetrySample:
        """The step's sample [each in its unit]"""

class RecordingFile:
    """An open recording: whole, growing, or left behind by a crash."""
    def __init__(self, path: bytes) -> None:
        """Opens FILE or FILE.partial; FILE alone also finds FILE.partial beside it. Units: none."""
    def close(self) -> None:
        """Closes the file; the arrays that were read stay. Units: none."""
    def event_columns(self) -> dict[str, Any]:
        """The events' columns by name. Units: those of EventRow.units."""
    def events(self) -> list[EventRow]:
        """What the steps reported, in their order. Units: those of its values."""
    def info(self) -> RecordingInfo:
        """The summary, as of the last refresh. Units: [s] and [byte], in its names."""
    def link_columns(self) -> dict[str, Any]:
        """The robot's link once a second, columns by name. Units: in the names; counts without."""
    def notes(self) -> list[Note]:
        """Notes, bookmarks, trials' markers and alarms, in their order. Units: [s], in its names."""
    def overview(self, name: str, from_s: float, to_s: float, buckets: int) -> tuple[Any, ...]:
        """Smallest and largest of a column between from_s and to_s [s], in at most so many buckets, one or more: (start
        of each bucket [s], smallest, largest [the column's unit]). No spike is lost.
        """
    def parameters(self) -> Parameters:
        """The step's parameters at the first row. Units: each parameter's own."""
    def picture(self, index: int) -> Picture:
        """A picture by its number in the recording, from 0. Units: [s], [px]."""
    def picture_at(self, time_s: float) -> Picture:
        """The newest picture at time_s [s] from the recording's start."""
    def read_into(self, names: list[str], first: int, arrays: list[ArrayLike]) -> None:
        """Rows of these columns, from row `first` on, into arrays of the columns' dtypes. Units: those of the columns."""
    def refresh(self) -> bool:
        """Takes in what was committed since; whether there was news. Units: none."""
    def row_at(self, time_s: float) -> int:
        """The first row at or after time_s [s] from the recording's start; the number of rows when there is none."""
    def step(self, row: int) -> RecordedStep:
        """What went into the step of this row and what came out. Units: those of its values."""

class RecordingInfo:
    """The summary of a recording, as of its last refresh."""
    @property
    def arithmetic(self) -> int:
        """Of the step that was recorded; bit for bit it comes out of the same one only, here 2 [1]"""
    @property
    def bytes(self) -> int:
        """Of the file [byte]"""
    @property
    def camera(self) -> str:
        """Where the pictures came from [—]"""
    @property
    def damage(self) -> str:
        """What is damaged; empty: nothing [—]"""
    @property
    def duration_s(self) -> float:
        """From its start to its last row [s]"""
    @property
    def events(self) -> int:
        """Events [1]"""
    @property
    def gaps(self) -> int:
        """Steps lost, not missed cycles [1]"""
    @property
    def id(self) -> str:
        """Globally unique [—]"""
    @property
    def missing_columns(self) -> list[str]:
        """Columns that this library has and the file has not: read as a new value has them [—]"""
    @property
    def notes(self) -> str:
        """Written when it started [—]"""
    @property
    def operator(self) -> str:
        """Who operated [—]"""
    @property
    def pictures(self) -> int:
        """Pictures [1]"""
    @property
    def profile(self) -> str:
        """TOML of the whole station's parameters [—]"""
    @property
    def robot(self) -> str:
        """Where the robot was [—]"""
    @property
    def rows(self) -> int:
        """Rows of telemetry to trust [1]"""
    @property
    def rows_present(self) -> int:
        """Rows of telemetry in the file [1]"""
    @property
    def started_ns(self) -> int:
        """The station's clock at time 0 of the recording [ns]"""
    @property
    def started_utc(self) -> str:
        """ISO 8601, of its start [—]"""
    @property
    def subject(self) -> str:
        """A code, never a name [—]"""
    @property
    def surface(self) -> str:
        """TOML of the stored surface; empty: none [—]"""
    @property
    def tags(self) -> list[str]:
        """Words to find it by [—]"""
    @property
    def touchpad(self) -> str:
        """Where the touchpad was [—]"""
    @property
    def unknown_columns(self) -> list[str]:
        """Columns that are not read [—]"""
    @property
    def version(self) -> str:
        """Of the program that recorded [—]"""
    @property
    def wholeness(self) -> Wholeness:
        """How it was left [—]"""
    @property
    def why_not_exact(self) -> str:
        """What of the steps is lost, so that they cannot come out bit for bit again; empty: nothing [—]"""

class ReferenceInput:
    """Where the robot wants the motors, with its time."""
    def __init__(self, **values: Any) -> None:
        """From values by their names; the others keep their defaults. Units: those in `units`."""
    def __repr__(self) -> str:
        ...
    def as_dict(self) -> dict[str, Any]:
        """Every value by its name. Units: those in `units`."""
    @property
    def count(self) -> int:
        """values so far; 0: there was none yet [1]"""
    @count.setter
    def count(self, value: int) -> None: ...
    @property
    def first_ticks(self) -> float:
        """of the first motor [tick]"""
    @first_ticks.setter
    def first_ticks(self, value: float) -> None: ...
    help: ClassVar[dict[str, str]]
    @property
    def second_ticks(self) -> float:
        """of the second motor [tick]"""
    @second_ticks.setter
    def second_ticks(self, value: float) -> None: ...
    def set(self, taken_ns: int, **values: Any) -> None:
        """A new value, taken at taken_ns [ns]: those named are changed. Units: those in `units`."""
    @property
    def taken_ns(self) -> int:
        """when it was taken [ns]"""
    @taken_ns.setter
    def taken_ns(self, value: int) -> None: ...
    units: ClassVar[dict[str, str]]

class ReplayResult:
    """What came of running a recording through the step again."""
    @property
    def closed_loop(self) -> bool:
        """Whether motors and load cell answered [—]"""
    @property
    def different(self) -> int:
        """Steps that differ [1]"""
    @property
    def duration_s(self) -> float:
        """Of the replayed part [s]"""
    @property
    def first_difference_field(self) -> str:
        """What differs there [—]"""
    @property
    def first_difference_s(self) -> float:
        """Time of the first step that differs; NaN: none [s]"""
    @property
    def from_rest(self) -> bool:
        """Started without the recorded state [—]"""
    @property
    def gaps(self) -> int:
        """Steps the recording lost; the replay ends at the first gap [1]"""
    @property
    def identical(self) -> bool:
        """Every step came out the same, bit for bit [—]"""
    @property
    def max_abs_difference(self) -> float:
        """Largest difference; infinite: a number against NaN [the column's unit]"""
    @property
    def max_difference_field(self) -> str:
        """Where that is [—]"""
    @property
    def of(self) -> int:
        """Steps there were, those included that the recording lost [1]"""
    @property
    def out_of_range(self) -> list[str]:
        """Parameters with a value beyond today's range [—]"""
    @property
    def speed_x(self) -> float:
        """Times real time [1]"""
    @property
    def steps(self) -> int:
        """Steps run [1]"""
    @property
    def stiffness_error_recorded_percent(self) -> float:
        """RMS of measured against target stiffness while observable, as recorded [%]"""
    @property
    def stiffness_error_replayed_percent(self) -> float:
        """The same, as replayed [%]"""
    @property
    def telemetry(self) -> dict[str, Any]:
        """Every column of the replayed steps by name: views of the steps' own memory, which no copy was made of [each in
        its unit]
        """
    @property
    def unknown_changes(self) -> int:
        """Recorded changes of parameters that this library does not know [1]"""
    @property
    def what_if(self) -> bool:
        """Whether parameters were changed [—]"""
    @property
    def why_not_exact(self) -> str:
        """What is lost in the recording, so that nothing can be proven; empty: nothing [—]"""

class RobotCommand:
    """What the robot's operator asks for; files store the number."""
    def __eq__(self, other: object) -> Any:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    def __init__(self, value: int) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: object) -> Any:
        ...
    def __repr__(self) -> str:
        ...
    disconnect: ClassVar[RobotCommand]
    images_off: ClassVar[RobotCommand]
    images_on: ClassVar[RobotCommand]
    motor_reference_off: ClassVar[RobotCommand]
    motor_reference_on: ClassVar[RobotCommand]
    @property
    def name(self) -> str: ...
    none: ClassVar[RobotCommand]
    resume: ClassVar[RobotCommand]
    send_info_and_pause: ClassVar[RobotCommand]
    use_dft321: ClassVar[RobotCommand]
    use_soc: ClassVar[RobotCommand]
    @property
    def value(self) -> int: ...
    vibration_down: ClassVar[RobotCommand]
    vibration_up: ClassVar[RobotCommand]

class RobotInput:
    """What the robot last said of itself, with its time."""
    def __init__(self, **values: Any) -> None:
        """From values by their names; the others keep their defaults. Units: those in `units`."""
    def __repr__(self) -> str:
        ...
    def as_dict(self) -> dict[str, Any]:
        """Every value by its name. Units: those in `units`."""
    @property
    def button(self) -> bool:
        """1: pressed [1]"""
    @button.setter
    def button(self, value: bool) -> None: ...
    @property
    def count(self) -> int:
        """values so far; 0: there was none yet [1]"""
    @count.setter
    def count(self, value: int) -> None: ...
    @property
    def force_N(self) -> float:
        """of its tool on what it touches; none where the protocol does not tell it [N]"""
    @force_N.setter
    def force_N(self, value: float) -> None: ...
    help: ClassVar[dict[str, str]]
    def set(self, taken_ns: int, **values: Any) -> None:
        """A new value, taken at taken_ns [ns]: those named are changed. Units: those in `units`."""
    @property
    def stiffness_N_per_mm(self) -> float:
        """what the robot feels; 0: it touches nothing [N/mm]"""
    @stiffness_N_per_mm.setter
    def stiffness_N_per_mm(self, value: float) -> None: ...
    @property
    def taken_ns(self) -> int:
        """when it was taken [ns]"""
    @taken_ns.setter
    def taken_ns(self, value: int) -> None: ...
    units: ClassVar[dict[str, str]]
    @property
    def x_mm(self) -> float:
        """of the end effector in the touchpad's frame, x right [mm]"""
    @x_mm.setter
    def x_mm(self, value: float) -> None: ...
    @property
    def y_mm(self) -> float:
        """of the end effector in the touchpad's frame, y back [mm]"""
    @y_mm.setter
    def y_mm(self, value: float) -> None: ...
    @property
    def z_mm(self) -> float:
        """of the end effector in the touchpad's frame, z up [mm]"""
    @z_mm.setter
    def z_mm(self, value: float) -> None: ...

class SafetyState:
    """State of a session; files store the number."""
    def __eq__(self, other: object) -> Any:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    def __init__(self, value: int) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: object) -> Any:
        ...
    def __repr__(self) -> str:
        ...
    active: ClassVar[SafetyState]
    connected: ClassVar[SafetyState]
    disconnected: ClassVar[SafetyState]
    held: ClassVar[SafetyState]
    @property
    def name(self) -> str: ...
    ready: ClassVar[SafetyState]
    stopped: ClassVar[SafetyState]
    @property
    def value(self) -> int: ...

class Scene:
    """A haptic scene as a finger feels it, step by step."""
    @property
    def bodies(self) -> list[str]:
        """Their names, in the order of the file [—]"""
    @staticmethod
    def open(path: Any, rate_Hz: float = 1000.0) -> Scene:
        """A scene file with its meshes and stored surfaces, for steps at rate_Hz [Hz]; in a Pipeline that is its
        texture.sample_rate_Hz.
        """
    def reset(self) -> None:
        """Back to before the first step. Units: none."""
    def run(self, probe_mm: ArrayLike, time_s: ArrayLike) -> dict[str, Any]:
        """A whole way [mm], shape (n, 3), at these times [s], each after the one before and after the last step; by name
        the columns of SceneTouch, in [N], [mm], [N/mm], and texture_g [g] of a finger that slides. Goes on where the
        last step ended: for another way from time 0, reset() first. Other threads go on meanwhile.
        """
    def step(self, probe_mm: ArrayLike, time_s: float) -> SceneTouch:
        """The haptic point is at probe_mm [mm] at time_s [s]. A place or a time that is no number touches nothing; a
        time that is not after the last step's gives what was felt there.
        """

class SceneTouch:
    """What the haptic point of a scene feels."""
    @property
    def body(self) -> int:
        """Which body pushes most; −1: a gesture, or nothing [—]"""
    @property
    def depth_mm(self) -> float:
        """How deep it is inside [mm]"""
    @property
    def force_N(self) -> tuple[Any, ...]:
        """On the haptic point [N]"""
    @property
    def normal(self) -> tuple[Any, ...]:
        """Of what pushes most, outwards [1]"""
    @property
    def proxy_mm(self) -> tuple[Any, ...]:
        """Where it is held by what pushes most [mm]"""
    @property
    def stiffness_N_per_mm(self) -> float:
        """Along the force; 0: nothing is touched [N/mm]"""
    @property
    def touching(self) -> bool:
        """Whether anything is touched [—]"""

class Surface:
    """A stored surface: a sum of noise bands."""
    def __init__(self) -> None:
        """Without a name and a band; see from_text. Units: none."""
    @property
    def bands(self) -> tuple[Any, ...]:
        """A tuple of SurfaceBand, set as a whole [each in its unit]"""
    @bands.setter
    def bands(self, value: Sequence[Any]) -> None: ...
    @property
    def description(self) -> str:
        """For people [—]"""
    @description.setter
    def description(self, value: str) -> None: ...
    @property
    def force_exponent(self) -> float:
        """How the amplitude grows with force [1]"""
    @force_exponent.setter
    def force_exponent(self, value: float) -> None: ...
    @staticmethod
    def from_text(text: str, name: str = 'surface') -> Surface:
        """Reads TOML, as resources/textures has it; `name` begins each message. Units: in the keys."""
    @property
    def name(self) -> str:
        """For people [—]"""
    @name.setter
    def name(self, value: str) -> None: ...
    @property
    def reference_force_N(self) -> float:
        """Force at which the bands hold [N]"""
    @reference_force_N.setter
    def reference_force_N(self, value: float) -> None: ...
    @property
    def reference_speed_mm_s(self) -> float:
        """Speed at which the bands hold [mm/s]"""
    @reference_speed_mm_s.setter
    def reference_speed_mm_s(self, value: float) -> None: ...
    @property
    def speed_exponent(self) -> float:
        """How the amplitude grows with speed [1]"""
    @speed_exponent.setter
    def speed_exponent(self, value: float) -> None: ...
    def text(self) -> str:
        """TOML that from_text reads back equal. Units: in the keys."""

class SurfaceBand:
    """A band of noise of a stored surface."""
    def __init__(self, wavelength_mm: float = 0.0, frequency_Hz: float = 0.0, quality: float = 1.0, rms_g: float = 0.0) -> None:
        """Exactly one of wavelength_mm [mm] and frequency_Hz [Hz]; rms_g [g]."""
    @property
    def frequency_Hz(self) -> float:
        """More than 0: the centre stays [Hz]"""
    @frequency_Hz.setter
    def frequency_Hz(self, value: float) -> None: ...
    @property
    def quality(self) -> float:
        """Centre over the width at −3 dB [1]"""
    @quality.setter
    def quality(self, value: float) -> None: ...
    @property
    def rms_g(self) -> float:
        """At the reference speed and force [g]"""
    @rms_g.setter
    def rms_g(self, value: float) -> None: ...
    @property
    def wavelength_mm(self) -> float:
        """More than 0: the centre moves with the finger [mm]"""
    @wavelength_mm.setter
    def wavelength_mm(self, value: float) -> None: ...

TELEMETRY_DTYPES: dict[str, numpy.dtype[Any]]

TELEMETRY_HELP: dict[str, str]

TELEMETRY_NAMES: tuple[str, ...]

TELEMETRY_UNITS: dict[str, str]

class TelemetrySample:
    """One sample of each step; NaN: no value."""
    def __init__(self, **values: Any) -> None:
        """From values by their names; the others keep their defaults. Units: those in `units`."""
    def __repr__(self) -> str:
        ...
    @property
    def acceleration_x_g(self) -> float:
        """newest acceleration of the robot's, as received, x [g]"""
    @acceleration_x_g.setter
    def acceleration_x_g(self, value: float) -> None: ...
    @property
    def acceleration_y_g(self) -> float:
        """newest acceleration of the robot's, as received, y [g]"""
    @acceleration_y_g.setter
    def acceleration_y_g(self, value: float) -> None: ...
    @property
    def acceleration_z_g(self) -> float:
        """newest acceleration of the robot's, as received, z [g]"""
    @acceleration_z_g.setter
    def acceleration_z_g(self, value: float) -> None: ...
    def as_dict(self) -> dict[str, Any]:
        """Every value by its name. Units: those in `units`."""
    @property
    def bridge_age_ms(self) -> float:
        """age of the newest force [ms]"""
    @bridge_age_ms.setter
    def bridge_age_ms(self, value: float) -> None: ...
    @property
    def contact(self) -> bool:
        """1: the cloth is touched [1]"""
    @contact.setter
    def contact(self, value: bool) -> None: ...
    @property
    def coupling_withheld_mJ(self) -> float:
        """energy that a cloth as stiff as was asked for would have given this finger more, during this touch or the last
        one [mJ]
        """
    @coupling_withheld_mJ.setter
    def coupling_withheld_mJ(self, value: float) -> None: ...
    @property
    def felt_acceleration_g(self) -> float:
        """acceleration of the finger that the duties make, by texture.plant_*: an estimate, a guess where the plant was
        not identified [g]
        """
    @felt_acceleration_g.setter
    def felt_acceleration_g(self, value: float) -> None: ...
    @property
    def felt_level_dB(self) -> float:
        """its RMS over a second, over the least that a finger feels (0.02 g); −120 at least [dB]"""
    @felt_level_dB.setter
    def felt_level_dB(self, value: float) -> None: ...
    @property
    def felt_out_of_reach(self) -> float:
        """1: a texture is wanted, and less than a finger feels arrives [1]"""
    @felt_out_of_reach.setter
    def felt_out_of_reach(self, value: float) -> None: ...
    @property
    def finger_age_ms(self) -> float:
        """age of the newest picture's result [ms]"""
    @finger_age_ms.setter
    def finger_age_ms(self, value: float) -> None: ...
    @property
    def finger_area_px(self) -> float:
        """dark area of the newest picture [px]"""
    @finger_area_px.setter
    def finger_area_px(self, value: float) -> None: ...
    @property
    def finger_energy_mJ(self) -> float:
        """energy that the finger has put into the cloth, less what came back, during this touch or the last one [mJ]"""
    @finger_energy_mJ.setter
    def finger_energy_mJ(self, value: float) -> None: ...
    @property
    def finger_x_mm(self) -> float:
        """where the finger is in the touchpad's frame, x right; none without contact [mm]"""
    @finger_x_mm.setter
    def finger_x_mm(self, value: float) -> None: ...
    @property
    def finger_y_mm(self) -> float:
        """where the finger is in the touchpad's frame, y back; none without contact [mm]"""
    @finger_y_mm.setter
    def finger_y_mm(self, value: float) -> None: ...
    @property
    def force_N(self) -> float:
        """normal force at the finger [N]"""
    @force_N.setter
    def force_N(self, value: float) -> None: ...
    help: ClassVar[dict[str, str]]
    @property
    def indentation_mm(self) -> float:
        """how deep the finger presses [mm]"""
    @indentation_mm.setter
    def indentation_mm(self, value: float) -> None: ...
    @property
    def indentation_sigma_mm(self) -> float:
        """standard deviation of the indentation [mm]"""
    @indentation_sigma_mm.setter
    def indentation_sigma_mm(self, value: float) -> None: ...
    @property
    def ir_age_ms(self) -> float:
        """age of the newest distances [ms]"""
    @ir_age_ms.setter
    def ir_age_ms(self, value: float) -> None: ...
    @property
    def lack(self) -> Fault:
        """Fault: why not ready, or why held; 0: nothing [1]"""
    @lack.setter
    def lack(self, value: Fault) -> None: ...
    @property
    def link(self) -> LinkPhase:
        """LinkPhase: how the robot's link stands [1]"""
    @link.setter
    def link(self, value: LinkPhase) -> None: ...
    @property
    def missed_cycles(self) -> float:
        """cycles of the haptic loop that got no step, since the start [1]"""
    @missed_cycles.setter
    def missed_cycles(self, value: float) -> None: ...
    @property
    def motors_age_ms(self) -> float:
        """age of the motors' newest report [ms]"""
    @motors_age_ms.setter
    def motors_age_ms(self, value: float) -> None: ...
    @property
    def now_ns(self) -> int:
        """the station's clock, exactly [ns]"""
    @now_ns.setter
    def now_ns(self, value: int) -> None: ...
    @property
    def reachable_target_N_per_mm(self) -> float:
        """stiffness nearest to the target that the touchpad can do [N/mm]"""
    @reachable_target_N_per_mm.setter
    def reachable_target_N_per_mm(self, value: float) -> None: ...
    @property
    def robot_age_ms(self) -> float:
        """age of the robot's newest state [ms]"""
    @robot_age_ms.setter
    def robot_age_ms(self, value: float) -> None: ...
    @property
    def robot_force_N(self) -> float:
        """force of the robot's tool on what it touches; none where it does not tell it [N]"""
    @robot_force_N.setter
    def robot_force_N(self, value: float) -> None: ...
    @property
    def robot_stiffness_N_per_mm(self) -> float:
        """stiffness as the robot tells it, before the coupling; 0: it touches nothing [N/mm]"""
    @robot_stiffness_N_per_mm.setter
    def robot_stiffness_N_per_mm(self, value: float) -> None: ...
    @property
    def robot_x_mm(self) -> float:
        """position that the robot reports, x right [mm]"""
    @robot_x_mm.setter
    def robot_x_mm(self, value: float) -> None: ...
    @property
    def robot_y_mm(self) -> float:
        """position that the robot reports, y back [mm]"""
    @robot_y_mm.setter
    def robot_y_mm(self, value: float) -> None: ...
    @property
    def robot_z_mm(self) -> float:
        """position that the robot reports, z up [mm]"""
    @robot_z_mm.setter
    def robot_z_mm(self, value: float) -> None: ...
    @property
    def state(self) -> SafetyState:
        """SafetyState: its number [1]"""
    @state.setter
    def state(self, value: SafetyState) -> None: ...
    @property
    def step(self) -> int:
        """counts from 1 [1]"""
    @step.setter
    def step(self, value: int) -> None: ...
    @property
    def stiffness_N_per_mm(self) -> float:
        """measured stiffness; keeps its last value while it cannot be observed [N/mm]"""
    @stiffness_N_per_mm.setter
    def stiffness_N_per_mm(self, value: float) -> None: ...
    @property
    def stiffness_observable(self) -> bool:
        """1: the measured stiffness is of now [1]"""
    @stiffness_observable.setter
    def stiffness_observable(self, value: bool) -> None: ...
    @property
    def stiffness_place_factor(self) -> float:
        """stiffness of the cloth under this finger over that of the law, by place and depth; none where unknown [1]"""
    @stiffness_place_factor.setter
    def stiffness_place_factor(self, value: float) -> None: ...
    @property
    def stretch_measured_deg(self) -> float:
        """stretch of the cloth, from the encoders [°]"""
    @stretch_measured_deg.setter
    def stretch_measured_deg(self, value: float) -> None: ...
    @property
    def stretch_reference_deg(self) -> float:
        """stretch of the cloth, as commanded [°]"""
    @stretch_reference_deg.setter
    def stretch_reference_deg(self, value: float) -> None: ...
    @property
    def t_s(self) -> float:
        """the station's clock in seconds [s]"""
    @property
    def target_N_per_mm(self) -> float:
        """stiffness asked for [N/mm]"""
    @target_N_per_mm.setter
    def target_N_per_mm(self, value: float) -> None: ...
    @property
    def target_clamped(self) -> bool:
        """1: the target asked for is not reachable [1]"""
    @target_clamped.setter
    def target_clamped(self, value: bool) -> None: ...
    @property
    def texture_signal_g(self) -> float:
        """signal of the texture after high-pass and method, before PWM [g]"""
    @texture_signal_g.setter
    def texture_signal_g(self, value: float) -> None: ...
    @property
    def touch_x_mm(self) -> float:
        """position sent to the robot, x right [mm]"""
    @touch_x_mm.setter
    def touch_x_mm(self, value: float) -> None: ...
    @property
    def touch_y_mm(self) -> float:
        """position sent to the robot, y back [mm]"""
    @touch_y_mm.setter
    def touch_y_mm(self, value: float) -> None: ...
    @property
    def touch_z_mm(self) -> float:
        """position sent to the robot, z up: pressing is negative [mm]"""
    @touch_z_mm.setter
    def touch_z_mm(self, value: float) -> None: ...
    @property
    def translation_measured_deg(self) -> float:
        """sideways motion of the cloth, from the encoders [°]"""
    @translation_measured_deg.setter
    def translation_measured_deg(self, value: float) -> None: ...
    units: ClassVar[dict[str, str]]
    @property
    def vibration_clipped(self) -> float:
        """steps in which the limit cut the signal, since the start [1]"""
    @vibration_clipped.setter
    def vibration_clipped(self, value: float) -> None: ...
    @property
    def vibration_clipped_share(self) -> float:
        """share of the last second's samples that a limit cut [1]"""
    @vibration_clipped_share.setter
    def vibration_clipped_share(self, value: float) -> None: ...
    @property
    def vibration_dead_share(self) -> float:
        """share of the last second's samples with a duty that is too small to turn a motor [1]"""
    @vibration_dead_share.setter
    def vibration_dead_share(self, value: float) -> None: ...
    @property
    def vibration_duty_percent(self) -> float:
        """vibration as sent to the first motor [%]"""
    @vibration_duty_percent.setter
    def vibration_duty_percent(self, value: float) -> None: ...
    @property
    def vibration_rms_percent(self) -> float:
        """RMS of the duty over a second, of the motor with more [%]"""
    @vibration_rms_percent.setter
    def vibration_rms_percent(self, value: float) -> None: ...

class TextureChain:
    """From three axes of acceleration to one signal: removal of rest, high-pass and method."""
    def __init__(self, parameters: Optional[Parameters] = None) -> None:
        """By texture.method, texture.filter, texture.corner_Hz, texture.sample_rate_Hz, texture.frame and texture.hop.
        Units: their own.
        """
    @property
    def delay_samples(self) -> int:
        """How much later the signal comes [sample]"""
    def run(self, accelerations_g: ArrayLike) -> NDArray[numpy.float64]:
        """The signal [g], as long as accelerations_g [g] of shape (n, 3), and delay_samples later; a row with NaN is a
        gap. Goes on where the last call ended. Other threads go on meanwhile.
        """

class VirtualTexture:
    """A stored surface as it feels under a finger of any speed and force."""
    def __init__(self, surface: Surface, rate_Hz: float = 1000.0, seed: int = 1) -> None:
        """At rate_Hz [Hz]; the same seed gives the same noise."""
    def reset(self) -> None:
        """Back to silence and the seed. Units: none."""
    def run(self, speed_mm_s: ArrayLike, force_N: ArrayLike) -> NDArray[numpy.float64]:
        """The signal [g] for a finger of these speeds [mm/s] and forces [N]; what is negative or not finite counts as 0,
        more than 1000 mm/s or 20 N as these. Other threads go on meanwhile.
        """

class Wholeness:
    """How a recording was left."""
    def __eq__(self, other: object) -> bool:
        ...
    def __hash__(self) -> int:
        ...
    def __index__(self) -> int:
        ...
    def __init__(self, value: int) -> None:
        ...
    def __int__(self) -> int:
        ...
    def __ne__(self, other: object) -> bool:
        ...
    def __repr__(self) -> str:
        ...
    crashed: ClassVar[Wholeness]
    damaged: ClassVar[Wholeness]
    growing: ClassVar[Wholeness]
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    whole: ClassVar[Wholeness]

__version__: str

def fault_text(fault: Fault) -> tuple[Any, ...]:
    """What is wrong, and what is done about it. Units: none."""

def fit_surface(accelerations_g: ArrayLike, rate_Hz: float = 1000.0, speed_mm_s: float = 0.0, force_N: float = 1.0, name: str = 'fitted') -> tuple[Any, ...]:
    """A surface from recorded accelerations_g [g], shape (n, 3), at rate_Hz [Hz]; speed_mm_s [mm/s] and force_N [N] of
    the finger; speed 0: not known, the bands then stay at fixed frequencies. (Surface, spectral match [1: equal]).
    """

def high_pass(corner_Hz: float, rate_Hz: float = 1000.0) -> tuple[Any, ...]:
    """Coefficients (b, a) of the default filter, a Butterworth high-pass of second order with its corner at corner_Hz
    [Hz], as texture.corner_Hz may be and at most 0.49 of rate_Hz [Hz], as texture.sample_rate_Hz may be.
    """

def predict_trial(time_s: ArrayLike, position_mm: ArrayLike, name: str = 'default', period_ms: float = 10.0, delay_ms: float = 50.0, jitter_ms: float = 0.0, loss_percent: float = 0.0, seed: int = 1, smooth_s: float = 0.0) -> dict[str, Any]:
    """Sends a recorded motion, time_s [s] and position_mm [mm] of shape (n, axes), over a simulated network (a message
    every period_ms [ms], delay_ms [ms], up to jitter_ms [ms] more, loss_percent [%]) and predicts it. Returns `row`
    of the motion at each tick, the predicted `position_mm` [mm] there, and the figures `rms_mm`, `mean_mm`, `max_mm`,
    `largest_step_mm` [mm], `vibration_ratio` and `jerk_ratio` [1], of the predicted motion's over the true one's. A
    ratio is NaN where the true motion has none of it, that of vibration below 1000 rows a second as well; where no
    message arrives `row` is empty and every figure NaN. smooth_s [s]: time constant of the output's smoothing. Other
    threads go on meanwhile.
    """

def replay(recording: RecordingFile, settings: dict[str, Any] = {}, closed_loop: bool = False, keep_telemetry: bool = True) -> ReplayResult:
    """Runs a recording through the step again: unchanged, which proves the outputs bit for bit, or with other parameters
    (`settings`, id to value). closed_loop: motors and load cell react to the new commands. Other threads go on
    meanwhile. Units: those of the columns, and of each parameter.
    """

def spectral_match(accelerations_g: ArrayLike, signal_g: ArrayLike, delay_samples: int = 0, rate_Hz: float = 1000.0) -> tuple[Any, ...]:
    """How well one signal [g] stands for three axes [g], shape (n, 3): (spectral match [1: equal], its energy over
    theirs [1]). NaN: the axes hold nothing to compare with, from 20 Hz on for the match, or fewer than 8 rows are
    left after delay_samples. A figure about spectra, never about what a person feels.
    """

def welch(signal: ArrayLike, rate_Hz: float = 1000.0, segment: int = 512) -> tuple[Any, ...]:
    """(Frequencies [Hz], one-sided density [unit²/Hz]) by Welch's method: Hann, half overlapped, no detrending. rate_Hz
    [Hz] as texture.sample_rate_Hz may be.
    """
