"""Sweeps: one scene at many points, with replicates, resumable, on any executor."""

from pelletflow._sweep.result import SweepResult
from pelletflow._sweep.sweep import sweep

__all__ = ["SweepResult", "sweep"]
