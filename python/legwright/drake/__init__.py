# SPDX-License-Identifier: Apache-2.0
"""The engine Drake, a second one beside MuJoCo: plants from compiled MuJoCo models, and the player
of gaits in them. `pip install "legwright[drake]"` brings what it needs; for people there are
legwright.validate(design, engine='drake') and `legwright validate --engine drake RUN`.
"""
