"""The library of the FYD Touchpad: recordings as NumPy arrays, replay and what-if, the pure step, sensing, textures,
predictors, haptic scenes.

A unit stands in the name of what has one (force_N, time_s) and in `units` of what has columns. Errors are fyd.Error, and
fyd.InvalidValue (also a ValueError) for a value that is not possible; their text names the thing, its value and what was
expected.
"""
from fyd._fyd import (
    AccelerationSample, BridgeInput, Contact, Error, Event, EventKind, EventRow, Fault, FingerDetection, FingerDetector,
    FingerInput, FingerReason, Inputs, InvalidValue, IrInput, LinkPhase, Mesh, MotorCommand, MotorInput, Note, NoteKind,
    OperatorAction, OperatorCommand, Outputs, ParameterChange, ParameterInfo, Parameters, Picture, Pipeline, PREDICTORS,
    Predictor, RecordedStep, RecordingInfo, ReferenceInput, ReplayResult, RobotCommand, RobotInput, SafetyState, Scene,
    SceneTouch, Surface, SurfaceBand, TelemetrySample, TextureChain, VirtualTexture, Wholeness, __version__, fault_text,
    fit_surface, high_pass, predict_trial, spectral_match, welch)
from fyd._recording import Columns, Recording, Telemetry, open, replay  # noqa: A004: fyd.open opens a recording

__all__ = [
    "AccelerationSample", "BridgeInput", "Columns", "Contact", "Error", "Event", "EventKind", "EventRow", "Fault",
    "FingerDetection", "FingerDetector", "FingerInput", "FingerReason", "Inputs", "InvalidValue", "IrInput", "LinkPhase",
    "Mesh", "MotorCommand", "MotorInput", "Note", "NoteKind", "OperatorAction", "OperatorCommand", "Outputs", "PREDICTORS",
    "ParameterChange", "ParameterInfo", "Parameters", "Picture", "Pipeline", "Predictor", "RecordedStep", "Recording",
    "RecordingInfo", "ReferenceInput", "ReplayResult", "RobotCommand", "RobotInput", "SafetyState", "Scene", "SceneTouch",
    "Surface", "SurfaceBand", "Telemetry", "TelemetrySample", "TextureChain", "VirtualTexture", "Wholeness",
    "__version__", "fault_text", "fit_surface", "high_pass", "open", "predict_trial", "replay", "spectral_match", "welch"]
