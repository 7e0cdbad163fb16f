# SPDX-License-Identifier: Apache-2.0
"""What a local worker loads first. Ctrl-C reaches all processes of a terminal; the study ends its
workers itself."""

import signal

signal.signal(signal.SIGINT, signal.SIG_IGN)
