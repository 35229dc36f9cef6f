"""Smoothed-particle hydrodynamics for compressible gas."""
