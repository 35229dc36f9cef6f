# SPDX-License-Identifier: BSD-3-Clause
"""Smoothed-particle hydrodynamics for compressible gas."""
